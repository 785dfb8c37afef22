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
#include "itkMeshReport.h"

#include "mesh/TetrahedronQuality.h"
#include "quality/Distribution.h"

namespace itk
{
mmm::Distribution
ComputeSurfaceQuality(const LabelInterfaceMesh & surface)
{
  if (surface.GetNumberOfCells() == 0)
  {
    return {};
  }
  const auto & points = *surface.GetPoints();
  const auto   corner = [&](const auto & triangle, int c) {
    const auto & point = points.ElementAt(triangle.GetPointIds()[c]);
    return mmm::Vector(point[0], point[1], point[2]);
  };
  std::vector<double> ratios;
  ratios.reserve(surface.GetNumberOfCells());
  for (auto cell = surface.GetCells()->Begin(); cell != surface.GetCells()->End(); ++cell)
  {
    const auto & triangle = *cell.Value();
    ratios.push_back(mmm::TriangleRadiusRatio(corner(triangle, 0), corner(triangle, 1), corner(triangle, 2)));
  }
  return mmm::Summarize(ratios.data(), ratios.data() + ratios.size());
}
} // end namespace itk
