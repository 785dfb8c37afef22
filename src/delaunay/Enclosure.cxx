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
#include "delaunay/Enclosure.h"

#include "delaunay/TetGen.h"

#include "itkMacro.h"

#include <algorithm>

namespace mmm
{
std::array<Vector, 8>
EnclosingCorners(const Grid & grid)
{
  Vector extent;
  for (int a = 0; a < 3; ++a)
  {
    extent[a] = grid.size[a] * grid.spacing[a];
  }
  const double          margin = extent.norm();
  std::array<Vector, 8> corners;
  for (int c = 0; c < 8; ++c)
  {
    for (int a = 0; a < 3; ++a)
    {
      corners[c][a] = (c >> a) & 1 ? extent[a] + margin : -margin;
    }
  }
  return corners;
}

std::vector<Tetrahedron>
TetrahedralizeWithin(const Grid & grid, const std::vector<Vector> & points)
{
  std::vector<Vector> all = points;
  const auto          corners = EnclosingCorners(grid);
  all.insert(all.end(), corners.begin(), corners.end());
  auto tetrahedra = DelaunayTetrahedralization(all);
  tetrahedra.erase(
    std::remove_if(tetrahedra.begin(),
                   tetrahedra.end(),
                   [&](const Tetrahedron & t) { return *std::max_element(t.begin(), t.end()) >= points.size(); }),
    tetrahedra.end());
  if (tetrahedra.empty())
  {
    itkGenericExceptionMacro("No tetrahedra between "
                             << points.size()
                             << " points: they lie in one plane. The parts to be meshed are too "
                                "small; a --radius of 0 keeps more of them.");
  }
  return tetrahedra;
}
} // namespace mmm
