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
#include "delaunay/ConformingDelaunay.h"

#include "delaunay/EncroachingPoints.h"
#include "delaunay/LocalRecovery.h"
#include "delaunay/TetGen.h"
#include "mesh/TriangleLookup.h"

#include <algorithm>

namespace mmm
{
namespace
{
/** The Delaunay tetrahedra of the points that are not left out. Points keep their numbers. */
std::vector<Tetrahedron>
TetrahedralizeOthers(const std::vector<Vector> & points, const std::vector<char> & isLeftOut)
{
  std::vector<PointId> used;
  std::vector<Vector>  positions;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    if (!isLeftOut[p])
    {
      used.push_back(PointId(p));
      positions.push_back(points[p]);
    }
  }
  auto tetrahedra = DelaunayTetrahedralization(positions);
  for (auto & t : tetrahedra)
  {
    for (auto & corner : t)
    {
      corner = used[corner];
    }
  }
  return tetrahedra;
}

/** Which triangles are no faces of the tetrahedra. */
std::vector<char>
FindMissing(const std::vector<Triangle> & triangles, const std::vector<Tetrahedron> & tetrahedra)
{
  const TriangleLookup lookup(triangles);
  std::vector<char>    isMissing(triangles.size(), 1);
  for (const auto & corners : tetrahedra)
  {
    for (int f = 0; f < 4; ++f)
    {
      const auto t = lookup.Find(FaceOf(corners, f));
      if (t != TriangleLookup::None)
      {
        isMissing[t] = 0;
      }
    }
  }
  return isMissing;
}
} // namespace

std::size_t
ConformingTetrahedralization(const Grid &                  grid,
                             std::size_t                   numberOfFixedPoints,
                             const std::vector<Triangle> & triangles,
                             std::vector<Vector> &         points,
                             std::vector<Tetrahedron> &    tetrahedra)
{
  const auto isLeftOut = FindEncroachingPoints(grid, numberOfFixedPoints, triangles, points);
  tetrahedra = TetrahedralizeOthers(points, isLeftOut);
  const auto isMissing = FindMissing(triangles, tetrahedra);
  if (std::find(isMissing.begin(), isMissing.end(), 1) != isMissing.end())
  {
    RecoverLocally(triangles, isMissing, points, tetrahedra);
  }
  return std::size_t(std::count(isLeftOut.begin(), isLeftOut.end(), 1));
}
} // namespace mmm
