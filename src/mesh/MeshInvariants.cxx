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
#include "mesh/MeshInvariants.h"

#include "mesh/TriangleLookup.h"

#include <algorithm>
#include <tuple>

namespace mmm
{
bool
ArePositive(const std::vector<Vector> & points, const std::vector<Tetrahedron> & tetrahedra, double tolerance)
{
  return std::all_of(tetrahedra.begin(), tetrahedra.end(), [&](const Tetrahedron & t) {
    const double volume = TetrahedronVolume(points[t[0]], points[t[1]], points[t[2]], points[t[3]]);
    return tolerance > 0.0 ? volume >= -tolerance : volume > 0.0;
  });
}

bool
AreAdjacent(const std::vector<Tetrahedron> & tetrahedra, const TetrahedronNeighbours & neighbours)
{
  for (std::uint32_t t = 0; t < tetrahedra.size(); ++t)
  {
    for (int f = 0; f < 4; ++f)
    {
      const auto other = neighbours[t][f];
      if (other != NoTetrahedron)
      {
        const auto & back = neighbours[other];
        const int    twin = int(std::find(back.begin(), back.end(), t) - back.begin());
        if (twin == 4 || SortedFaceOf(tetrahedra[t], f) != SortedFaceOf(tetrahedra[other], twin))
        {
          return false;
        }
      }
    }
  }
  return true;
}

bool
AreClosed(const InterfaceMesh & interfaces)
{
  // an edge of a material's boundary, and which way a triangle runs along it
  std::vector<std::tuple<Material, PointId, PointId, int>> edges;
  for (std::size_t t = 0; t < interfaces.triangles.size(); ++t)
  {
    for (int side = 0; side < 2; ++side)
    {
      for (int c = 0; c < 3; ++c)
      {
        const PointId a = interfaces.triangles[t][c];
        const PointId b = interfaces.triangles[t][(c + 1) % 3];
        edges.push_back({ interfaces.sides[t][side], std::min(a, b), std::max(a, b), (a < b) == (side == 0) ? 1 : -1 });
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  int sum = 0;
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    const auto keyOf = [&](std::size_t n) {
      return std::tie(std::get<0>(edges[n]), std::get<1>(edges[n]), std::get<2>(edges[n]));
    };
    sum += std::get<3>(edges[e]);
    const bool isLast = e + 1 == edges.size() || keyOf(e) != keyOf(e + 1);
    if (isLast && sum != 0)
    {
      return false;
    }
  }
  return true;
}
} // namespace mmm
