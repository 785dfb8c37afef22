/*=========================================================================
 *
 *  Copyright NumFOCUS
 *
 *  Licensed under the Apache License, Version 2.0 (the "License");
 *  you may not use this file except in compliance with the License.
 *  You may obtain a copy of the License at
 *
 *         https://www.apache.org/licenses/LICENSE-2.0.txt
 *
 *  Unless required by applicable law or agreed to in writing, software
 *  distributed under the License is distributed on an "AS IS" BASIS,
 *  WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
 *  See the License for the specific language governing permissions and
 *  limitations under the License.
 *
 *=========================================================================*/
#include "SurfaceQuality.h"

#include "mmmTetrahedronQuality.h"

#include <algorithm>

namespace cli
{
SurfaceQuality
ComputeSurfaceQuality(const itk::LabelInterfaceMesh & surface)
{
  SurfaceQuality quality;
  const auto     count = surface.GetNumberOfCells();
  if (count == 0)
  {
    return quality;
  }
  const auto & points = *surface.GetPoints();
  const auto   corner = [&](const auto & triangle, int c) {
    const auto & point = points.ElementAt(triangle.GetPointIds()[c]);
    return mmm::Vector(point[0], point[1], point[2]);
  };
  quality.minimum = 1.0;
  for (auto cell = surface.GetCells()->Begin(); cell != surface.GetCells()->End(); ++cell)
  {
    const auto & triangle = *cell.Value();
    const double ratio = mmm::TriangleRadiusRatio(corner(triangle, 0), corner(triangle, 1), corner(triangle, 2));
    quality.average += ratio / double(count);
    quality.minimum = std::min(quality.minimum, ratio);
  }
  return quality;
}
} // namespace cli
