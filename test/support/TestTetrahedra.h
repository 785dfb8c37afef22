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
#ifndef mmmTestTetrahedra_h
#define mmmTestTetrahedra_h

#include "base/Grid.h"
#include "mesh/TetrahedronQuality.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace mmmtest
{
/** The nodes of a grid. */
inline std::vector<mmm::Vector>
MakeNodes(const mmm::Grid & grid)
{
  std::vector<mmm::Vector> nodes;
  for (std::size_t n = 0; n < grid.NumberOfNodes(); ++n)
  {
    nodes.push_back(grid.Position(grid.IndexAt(n)));
  }
  return nodes;
}

/** The tetrahedra, positive, of a Freudenthal subdivision between the nodes of a grid: six in each cube. */
inline std::vector<mmm::Tetrahedron>
MakeFreudenthalTetrahedra(const mmm::Grid & grid)
{
  std::vector<mmm::Tetrahedron> tetrahedra;
  const auto                    x = MakeNodes(grid);
  for (std::size_t n = 0; n < grid.NumberOfNodes(); ++n)
  {
    const mmm::Index first = grid.IndexAt(n);
    if (!grid.Contains({ { first[0] + 1, first[1] + 1, first[2] + 1 } }))
    {
      continue;
    }
    std::array<int, 3> axes{ { 0, 1, 2 } };
    do
    {
      mmm::Index       at = first;
      mmm::Tetrahedron t{ { std::uint32_t(n), 0, 0, 0 } };
      for (int corner = 1; corner < 4; ++corner)
      {
        ++at[axes[corner - 1]];
        t[corner] = std::uint32_t(grid.Offset(at));
      }
      if (mmm::TetrahedronVolume(x[t[0]], x[t[1]], x[t[2]], x[t[3]]) < 0.0)
      {
        std::swap(t[0], t[1]);
      }
      tetrahedra.push_back(t);
    } while (std::next_permutation(axes.begin(), axes.end()));
  }
  return tetrahedra;
}
} // namespace mmmtest

#endif
