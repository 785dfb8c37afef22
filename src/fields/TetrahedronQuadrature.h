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
#ifndef mmmTetrahedronQuadrature_h
#define mmmTetrahedronQuadrature_h

#include "itkContinuousIndex.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mmm
{
using TetrahedronCorners = std::array<itk::ContinuousIndex<double, 3>, 4>;

/** How many parts edges are cut into, so that none is longer than a third of a voxel; corners are in voxels. */
inline int
PartsOfEdges(const TetrahedronCorners & corners)
{
  // a mesh that is much coarser than the image is not to take forever
  constexpr double most = 64.0;
  double           longest = 0.0;
  for (std::size_t a = 0; a < 4; ++a)
  {
    for (std::size_t b = 0; b < a; ++b)
    {
      longest = std::max(longest, (corners[a] - corners[b]).GetNorm());
    }
  }
  return static_cast<int>(std::clamp(std::ceil(3.0 * longest), 1.0, most));
}

/** Calls visit(point, weight) for the points of a quadrature; the weights sum up to parts^3.
 *
 * Planes parallel to the faces cut the tetrahedron into smaller ones of its shape, upright and turned over, and
 * octahedra of four times their volume. The points are their centers. */
template <typename TVisit>
void
VisitTetrahedron(const TetrahedronCorners & corners, int parts, const TVisit & visit)
{
  const auto visitAt = [&](double a, double b, double c, double weight) {
    const double                    by = 1.0 / parts;
    itk::ContinuousIndex<double, 3> point = corners[0];
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      point[axis] += by * (a * (corners[1][axis] - corners[0][axis]) + b * (corners[2][axis] - corners[0][axis]) +
                           c * (corners[3][axis] - corners[0][axis]));
    }
    visit(point, weight);
  };
  for (int i = 0; i < parts; ++i)
  {
    for (int j = 0; i + j < parts; ++j)
    {
      for (int k = 0; i + j + k < parts; ++k)
      {
        const int left = parts - (i + j + k);
        visitAt(i + 0.25, j + 0.25, k + 0.25, 1.0);
        if (left > 1)
        {
          visitAt(i + 0.5, j + 0.5, k + 0.5, 4.0);
        }
        if (left > 2)
        {
          visitAt(i + 0.75, j + 0.75, k + 0.75, 1.0);
        }
      }
    }
  }
}
} // namespace mmm

#endif
