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
#include "mesh/BoundarySheets.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
struct Spoke
{
  double        angle;
  std::uint32_t face;
  /** Whether the region follows counter-clockwise, and not the complement. */
  bool regionFollows;

  bool
  operator<(const Spoke & other) const
  {
    return angle != other.angle ? angle < other.angle : face < other.face;
  }
};
} // namespace

void
JoinSheets(const std::vector<Vector> &          points,
           const std::vector<Tetrahedron> &     tetrahedra,
           const std::vector<BoundaryFace> &    faces,
           const std::array<std::uint32_t, 2> & edge,
           const std::array<const Keyed *, 2> & run,
           DisjointSets &                       sheets)
{
  const Keyed * const begin = run[0];
  const std::size_t   count = run[1] - begin;
  if (count == 2)
  {
    sheets.Unite(begin[0].value, begin[1].value);
  }
  if (count <= 2)
  {
    return;
  }
  const Vector &     origin = points[edge[0]];
  const Vector       axis = (points[edge[1]] - origin).normalized();
  Vector             x;
  Vector             y;
  std::vector<Spoke> spokes(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto & face = faces[begin[i].value];
    const auto & tetrahedron = tetrahedra[face.tetrahedron];
    // what is left when the known points are taken out
    const auto   tip = face.points[0] ^ face.points[1] ^ face.points[2] ^ edge[0] ^ edge[1];
    const auto   inside = tip ^ edge[0] ^ edge[1] ^ tetrahedron[0] ^ tetrahedron[1] ^ tetrahedron[2] ^ tetrahedron[3];
    const Vector spoke = points[tip] - origin;
    if (i == 0)
    {
      x = (spoke - spoke.dot(axis) * axis).normalized();
      y = axis.cross(x);
    }
    spokes[i].angle = std::atan2(spoke.dot(y), spoke.dot(x));
    spokes[i].face = begin[i].value;
    spokes[i].regionFollows = axis.cross(spoke).dot(points[inside] - origin) > 0.0;
  }
  std::sort(spokes.begin(), spokes.end());
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!spokes[i].regionFollows)
    {
      sheets.Unite(spokes[i].face, spokes[(i + 1) % count].face);
    }
  }
}
} // namespace mmm
