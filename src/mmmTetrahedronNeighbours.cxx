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
#include "mmmTetrahedronNeighbours.h"

#include <algorithm>

namespace mmm
{
std::vector<std::array<std::uint32_t, 4>>
ComputeTetrahedronNeighbours(const std::vector<Tetrahedron> & tetrahedra)
{
  // Faces are chained at their smallest point; a face that is met again is its twin.
  struct Face
  {
    PointId       middle;
    PointId       largest;
    std::uint32_t slot; // 4 * tetrahedron + face
    std::uint32_t next;
  };
  PointId points = 0;
  for (const auto & t : tetrahedra)
  {
    points = std::max(points, *std::max_element(t.begin(), t.end()) + 1);
  }
  std::vector<std::uint32_t>                chain(points, NoTetrahedron);
  std::vector<Face>                         faces(4 * tetrahedra.size());
  std::vector<std::array<std::uint32_t, 4>> neighbours(
    tetrahedra.size(), { { NoTetrahedron, NoTetrahedron, NoTetrahedron, NoTetrahedron } });
  for (std::size_t t = 0; t < tetrahedra.size(); ++t)
  {
    for (int f = 0; f < 4; ++f)
    {
      Triangle corners;
      for (int c = 0; c < 3; ++c)
      {
        corners[c] = tetrahedra[t][TetrahedronFaces[f][c]];
      }
      std::sort(corners.begin(), corners.end());
      const auto      slot = std::uint32_t(4 * t + f);
      std::uint32_t * link = &chain[corners[0]];
      while (*link != NoTetrahedron && (faces[*link].middle != corners[1] || faces[*link].largest != corners[2]))
      {
        link = &faces[*link].next;
      }
      if (*link == NoTetrahedron)
      {
        faces[slot] = { corners[1], corners[2], slot, chain[corners[0]] };
        chain[corners[0]] = slot;
      }
      else
      {
        const auto twin = faces[*link].slot;
        neighbours[t][f] = twin / 4;
        neighbours[twin / 4][twin % 4] = std::uint32_t(t);
        *link = faces[*link].next;
      }
    }
  }
  return neighbours;
}
} // namespace mmm
