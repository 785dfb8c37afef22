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
#include "mesh/TetrahedronNeighbours.h"

#include "base/Parallel.h"

#include <algorithm>

namespace mmm
{
namespace
{
constexpr std::size_t Grain = 1024;

/** A face by the two larger of its corners, and whose it is. */
struct Face
{
  std::uint64_t corners;
  std::uint32_t tetrahedron;
  int           number;

  bool
  operator<(const Face & other) const
  {
    return corners != other.corners ? corners < other.corners : tetrahedron < other.tetrahedron;
  }
};

/** The faces of a tetrahedron that have `smallest` as their smallest corner. */
void
AddFaces(const Tetrahedron & corners, std::uint32_t tetrahedron, PointId smallest, std::vector<Face> & faces)
{
  const auto smaller = std::count_if(corners.begin(), corners.end(), [=](PointId c) { return c < smallest; });
  if (smaller > 1)
  {
    return;
  }
  for (int f = 0; f < 4; ++f)
  {
    // without the one that is smaller
    if (corners[f] == smallest || (smaller == 1 && corners[f] > smallest))
    {
      continue;
    }
    PointId others[2];
    int     count = 0;
    for (int c = 0; c < 4; ++c)
    {
      if (c != f && corners[c] != smallest)
      {
        others[count++] = corners[c];
      }
    }
    const auto ends = std::minmax(others[0], others[1]);
    faces.push_back({ std::uint64_t(ends.first) << 32 | ends.second, tetrahedron, f });
  }
}
} // namespace

TetrahedronNeighbours
ComputeTetrahedronNeighbours(const std::vector<Tetrahedron> & tetrahedra)
{
  PointId points = 0;
  for (const auto & t : tetrahedra)
  {
    points = std::max(points, *std::max_element(t.begin(), t.end()) + 1);
  }
  return ComputeTetrahedronNeighbours(tetrahedra, points, StarsOfPoints(tetrahedra, points));
}

TetrahedronNeighbours
ComputeTetrahedronNeighbours(const std::vector<Tetrahedron> & tetrahedra, std::size_t points, const Incidence & stars)
{
  TetrahedronNeighbours neighbours(tetrahedra.size(),
                                   { { NoTetrahedron, NoTetrahedron, NoTetrahedron, NoTetrahedron } });
  // a face is paired with its twin at their smallest corner
  ParallelFor(points, Grain, [&](std::size_t begin, std::size_t end) {
    std::vector<Face> faces;
    for (std::size_t p = begin; p < end; ++p)
    {
      faces.clear();
      for (auto t = stars.Begin(p); t != stars.End(p); ++t)
      {
        AddFaces(tetrahedra[*t], *t, PointId(p), faces);
      }
      std::sort(faces.begin(), faces.end());
      for (std::size_t f = 1; f < faces.size(); ++f)
      {
        const Face & one = faces[f - 1];
        const Face & twin = faces[f];
        if (one.corners == twin.corners)
        {
          neighbours[one.tetrahedron][one.number] = twin.tetrahedron;
          neighbours[twin.tetrahedron][twin.number] = one.tetrahedron;
          ++f;
        }
      }
    }
  });
  return neighbours;
}
} // namespace mmm
