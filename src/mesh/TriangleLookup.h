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
#ifndef mmmTriangleLookup_h
#define mmmTriangleLookup_h

#include "mesh/Incidence.h"
#include "mesh/TetrahedralMesh.h"

#include <algorithm>

namespace mmm
{
/** Finds the triangle with three given corners. The triangles must outlive it. */
class TriangleLookup
{
public:
  static constexpr std::uint32_t None = 0xffffffffu;

  explicit TriangleLookup(const std::vector<Triangle> & triangles)
    : m_Triangles(triangles)
    , m_Points(CountPoints(triangles))
    , m_BySmallest(m_Points, triangles.size(), [&](std::size_t t) {
      return std::array<PointId, 1>{ { *std::min_element(triangles[t].begin(), triangles[t].end()) } };
    })
  {}

  /** The number of the triangle, whatever its orientation, or None. */
  std::uint32_t
  Find(const Triangle & corners) const
  {
    const PointId smallest = *std::min_element(corners.begin(), corners.end());
    if (smallest < m_Points)
    {
      for (auto t = m_BySmallest.Begin(smallest); t != m_BySmallest.End(smallest); ++t)
      {
        if (std::is_permutation(corners.begin(), corners.end(), m_Triangles[*t].begin()))
        {
          return *t;
        }
      }
    }
    return None;
  }

private:
  static PointId
  CountPoints(const std::vector<Triangle> & triangles)
  {
    PointId points = 0;
    for (const auto & t : triangles)
    {
      points = std::max(points, *std::max_element(t.begin(), t.end()) + 1);
    }
    return points;
  }

  const std::vector<Triangle> & m_Triangles;
  PointId                       m_Points;
  Incidence                     m_BySmallest;
};

/** The corners of a tetrahedron's face; its normal points outward. */
inline Triangle
FaceOf(const Tetrahedron & corners, int face)
{
  const auto & numbers = TetrahedronFaces[face];
  return { { corners[numbers[0]], corners[numbers[1]], corners[numbers[2]] } };
}

/** The same corners, ascending. */
inline Triangle
SortedFaceOf(const Tetrahedron & corners, int face)
{
  Triangle triangle = FaceOf(corners, face);
  std::sort(triangle.begin(), triangle.end());
  return triangle;
}
} // namespace mmm

#endif
