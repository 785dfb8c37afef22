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
#include "delaunay/EncroachingPoints.h"

#include "base/ParallelCollect.h"
#include "base/PointBins.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mmm
{
namespace
{
constexpr std::size_t Grain = 4096;

/** Balls may be that many times as large as the smallest ones through the corners: those that are cleared, and those
 * that are looked at. */
constexpr double LargestGrowth = 1.5;
constexpr double LargestGrowthOfFace = 4.0;
/** What is less inside than this, in squares of the radius, is on the sphere. */
constexpr double OnSphere = 1e-9;

struct Ball
{
  Vector centre;
  double radius;
};

bool
IsCorner(PointId p, const Triangle & corners)
{
  return std::find(corners.begin(), corners.end(), p) != corners.end();
}

/** Looks for balls through the corners of triangles that are empty of some points. */
class EmptyBallFinder
{
public:
  /** The first points, up to that number. */
  EmptyBallFinder(const Grid & grid, const std::vector<Vector> & points, std::size_t count)
    : m_Points(points)
    , m_Bins(grid)
  {
    m_Bins.Assign({ points.begin(), points.begin() + std::ptrdiff_t(count) });
  }

  /** The smallest one, or where that is too large or there is none, the smallest through the corners. */
  Ball
  Find(const Triangle & corners, double largestGrowth) const
  {
    const Vector & a = m_Points[corners[0]];
    const Vector   u = m_Points[corners[1]] - a;
    const Vector   v = m_Points[corners[2]] - a;
    const Vector   n = u.cross(v);
    const double   square = n.squaredNorm();
    if (!(square > std::numeric_limits<double>::min()))
    {
      return { a + (u + v) / 3.0, std::max(u.norm(), v.norm()) };
    }
    const Vector normal = n / std::sqrt(square);
    const Vector toCentre = (u.squaredNorm() * v.cross(n) + v.squaredNorm() * n.cross(u)) / (2.0 * square);
    const Ball   smallest{ a + toCentre, toCentre.norm() };
    // how far the centre has to go along the normal, because of points above and below
    const double squaredRadius = smallest.radius * smallest.radius;
    double       least = 0.0;
    double       most = 0.0;
    m_Bins.Visit(smallest.centre, smallest.radius, [&](PointId p) {
      const Vector away = m_Points[p] - smallest.centre;
      const double height = normal.dot(away);
      const double power = away.squaredNorm() - squaredRadius;
      if (power < 0.0 && height != 0.0 && !IsCorner(p, corners))
      {
        const double shift = power / (2.0 * height);
        least = std::max(least, shift);
        most = std::min(most, shift);
      }
    });
    const double shift = least > -most ? least : most;
    const double radius = std::sqrt(squaredRadius + shift * shift);
    return radius <= largestGrowth * smallest.radius ? Ball{ smallest.centre + shift * normal, radius } : smallest;
  }

  /** Whether there is one. */
  bool
  HasAny(const Triangle & corners) const
  {
    const Ball ball = this->Find(corners, LargestGrowthOfFace);
    bool       isEmpty = true;
    this->VisitInside(ball, [&](PointId p) { isEmpty = isEmpty && IsCorner(p, corners); });
    return isEmpty;
  }

  template <typename TVisitor>
  void
  VisitInside(const Ball & ball, TVisitor && visit) const
  {
    const double square = ball.radius * ball.radius * (1.0 - OnSphere);
    m_Bins.Visit(ball.centre, ball.radius, [&](PointId p) {
      if ((m_Points[p] - ball.centre).squaredNorm() < square)
      {
        visit(p);
      }
    });
  }

private:
  const std::vector<Vector> & m_Points;
  PointBins                   m_Bins;
};
} // namespace

std::vector<char>
FindEncroachingPoints(const Grid &                  grid,
                      std::size_t                   numberOfFirst,
                      const std::vector<Triangle> & triangles,
                      const std::vector<Vector> &   points)
{
  const EmptyBallFinder amongFirst(grid, points, numberOfFirst);
  const EmptyBallFinder amongAll(grid, points, points.size());
  const auto            encroaching =
    ParallelCollect<PointId>(triangles.size(), Grain, [&](std::size_t t, std::vector<PointId> & found) {
      if (!amongAll.HasAny(triangles[t]))
      {
        amongAll.VisitInside(amongFirst.Find(triangles[t], LargestGrowth), [&](PointId p) {
          if (p >= numberOfFirst)
          {
            found.push_back(p);
          }
        });
      }
    });
  std::vector<char> isEncroaching(points.size(), 0);
  for (const PointId p : encroaching)
  {
    isEncroaching[p] = 1;
  }
  return isEncroaching;
}
} // namespace mmm
