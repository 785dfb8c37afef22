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
#ifndef mmmTetrahedronRaster_h
#define mmmTetrahedronRaster_h

#include "mesh/TetrahedronQuality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace mmm
{
/** The corners of a tetrahedron in units of a grid's spacing. */
inline std::array<Vector, 4>
CornersInVoxels(const Grid & grid, const std::vector<Vector> & points, const Tetrahedron & tetrahedron)
{
  std::array<Vector, 4> corners;
  for (int c = 0; c < 4; ++c)
  {
    corners[c] = points[tetrahedron[c]].cwiseQuotient(grid.spacing);
  }
  return corners;
}

/** Calls visit(index) for the points with whole-numbered coordinates, from `lower` to `upper`, that are inside of a
 * tetrahedron, its planes moved outwards by `reach` and not further than its bounding box moved likewise. */
template <typename TVisitor>
void
VisitIndicesInside(const Index &                 lower,
                   const Index &                 upper,
                   const std::array<Vector, 4> & corners,
                   double                        reach,
                   TVisitor &&                   visit)
{
  int low[3];
  int high[3];
  for (int a = 0; a < 3; ++a)
  {
    const auto coordinates = { corners[0][a], corners[1][a], corners[2][a], corners[3][a] };
    low[a] = std::max(lower[a], int(std::ceil(std::min(coordinates) - reach)));
    high[a] = std::min(upper[a], int(std::floor(std::max(coordinates) + reach)));
    if (low[a] > high[a])
    {
      return;
    }
  }
  Vector normals[4];
  double offsets[4];
  for (int f = 0; f < 4; ++f)
  {
    const Vector & a = corners[TetrahedronFaces[f][0]];
    normals[f] = (corners[TetrahedronFaces[f][1]] - a).cross(corners[TetrahedronFaces[f][2]] - a).normalized();
    offsets[f] = normals[f].dot(a) + reach;
  }
  for (int k = low[2]; k <= high[2]; ++k)
  {
    for (int j = low[1]; j <= high[1]; ++j)
    {
      double first = low[0];
      double last = high[0];
      for (int f = 0; f < 4; ++f)
      {
        const double rest = offsets[f] - normals[f][1] * j - normals[f][2] * k;
        if (normals[f][0] > 0.0)
        {
          last = std::min(last, rest / normals[f][0]);
        }
        else if (normals[f][0] < 0.0)
        {
          first = std::max(first, rest / normals[f][0]);
        }
        else if (!(rest >= 0.0))
        {
          last = -std::numeric_limits<double>::infinity();
        }
      }
      // both bounds lie within the bounding box now, or there is nothing between them
      if (!(first <= last))
      {
        continue;
      }
      const int end = int(std::floor(last));
      for (int i = int(std::ceil(first)); i <= end; ++i)
      {
        visit(Index{ { i, j, k } });
      }
    }
  }
}

/** The same from 0 up to but without `size`. */
template <typename TVisitor>
void
VisitIndicesInside(const Index & size, const std::array<Vector, 4> & corners, double reach, TVisitor && visit)
{
  const Index last{ { size[0] - 1, size[1] - 1, size[2] - 1 } };
  VisitIndicesInside(Index{ { 0, 0, 0 } }, last, corners, reach, visit);
}
} // namespace mmm

#endif
