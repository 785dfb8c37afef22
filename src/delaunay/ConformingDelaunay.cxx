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

#include "delaunay/TetGen.h"
#include "mesh/TriangleLookup.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mmm
{
namespace
{
/** Tries with fewer and fewer points; then all that may be left out are. */
constexpr int Rounds = 10;
/** By how much further each round looks for points in the way, in radii of the circumcircle. */
constexpr double ReachGrowth = 0.3;

/** The triangles that are no faces of the tetrahedra. */
std::vector<Triangle>
FindMissing(const std::vector<Triangle> & triangles, const std::vector<Tetrahedron> & tetrahedra)
{
  const TriangleLookup lookup(triangles);
  std::vector<char>    found(triangles.size(), 0);
  for (const auto & corners : tetrahedra)
  {
    for (int f = 0; f < 4; ++f)
    {
      const auto t = lookup.Find(FaceOf(corners, f));
      if (t != TriangleLookup::None)
      {
        found[t] = 1;
      }
    }
  }
  std::vector<Triangle> missing;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (!found[t])
    {
      missing.push_back(triangles[t]);
    }
  }
  return missing;
}

/** The ball around the circumcircle of a triangle. */
struct Ball
{
  Vector centre;
  double radius;
};

Ball
SmallestBall(const Vector & a, const Vector & b, const Vector & c)
{
  const Vector u = b - a;
  const Vector v = c - a;
  const Vector n = u.cross(v);
  const double square = n.squaredNorm();
  if (!(square > 0.0))
  {
    return { (a + b + c) / 3.0, std::max(u.norm(), v.norm()) };
  }
  const Vector toCentre = (u.squaredNorm() * v.cross(n) + v.squaredNorm() * n.cross(u)) / (2.0 * square);
  return { a + toCentre, toCentre.norm() };
}

/** Points sorted along x: those of a slab are found by bisection. */
class PointsByX
{
public:
  PointsByX(const std::vector<Vector> & points, const std::vector<PointId> & ids)
    : m_Points(points)
    , m_Ids(ids)
  {
    std::sort(m_Ids.begin(), m_Ids.end(), [&](PointId p, PointId q) { return points[p][0] < points[q][0]; });
  }
  template <typename TVisitor>
  void
  VisitBall(const Ball & ball, TVisitor && visit) const
  {
    auto p = std::lower_bound(m_Ids.begin(), m_Ids.end(), ball.centre[0] - ball.radius, [&](PointId id, double x) {
      return m_Points[id][0] < x;
    });
    for (; p != m_Ids.end() && m_Points[*p][0] <= ball.centre[0] + ball.radius; ++p)
    {
      if ((m_Points[*p] - ball.centre).squaredNorm() <= ball.radius * ball.radius)
      {
        visit(*p);
      }
    }
  }

private:
  const std::vector<Vector> & m_Points;
  std::vector<PointId>        m_Ids;
};
} // namespace

std::optional<std::size_t>
ConformingTetrahedralization(const std::vector<Vector> &   points,
                             std::size_t                   numberOfSurfacePoints,
                             const std::vector<Triangle> & triangles,
                             std::vector<Tetrahedron> &    tetrahedra)
{
  std::vector<PointId> used(points.size());
  std::iota(used.begin(), used.end(), PointId(0));
  for (int round = 0; round <= Rounds; ++round)
  {
    if (round == Rounds)
    {
      used.resize(numberOfSurfacePoints);
    }
    std::vector<Vector> positions;
    positions.reserve(used.size());
    for (const auto p : used)
    {
      positions.push_back(points[p]);
    }
    tetrahedra = DelaunayTetrahedralization(positions);
    const auto missing = FindMissing(triangles, tetrahedra);
    if (missing.empty())
    {
      for (auto & t : tetrahedra)
      {
        for (auto & corner : t)
        {
          corner = used[corner];
        }
      }
      return points.size() - used.size();
    }
    // the points of the surface stay in front, and keep their numbers
    const PointsByX   others(points, std::vector<PointId>(used.begin() + numberOfSurfacePoints, used.end()));
    std::vector<char> inTheWay(points.size(), 0);
    for (const auto & t : missing)
    {
      Ball ball = SmallestBall(points[t[0]], points[t[1]], points[t[2]]);
      ball.radius *= 1.0 + ReachGrowth * round;
      others.VisitBall(ball, [&](PointId p) { inTheWay[p] = 1; });
    }
    used.erase(std::remove_if(used.begin(), used.end(), [&](PointId p) { return inTheWay[p] != 0; }), used.end());
  }
  return std::nullopt;
}
} // namespace mmm
