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
#include "optimize/PointSmoother.h"

#include "optimize/OptimizerState.h"
#include "base/Parallel.h"
#include "optimize/ShapeQuality.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
constexpr std::size_t Grain = 512;
/** Of a regular tetrahedron with edges of 1: the height, and twice the area of a face. */
constexpr double HeightOfRegular = 0.8165;
constexpr double AreaOfRegular = 0.8660254;
} // namespace

std::size_t
PointSmoother::SmoothWorst(double quality, double tolerance)
{
  const auto isPoor = this->MarkPointsOfPoor(quality);
  return this->MoveByColour([&](PointId p) { return isPoor[p] && this->MoveUphill(p, quality, tolerance); });
}

/** The points that have a tetrahedron below a quality. */
std::vector<char>
PointSmoother::MarkPointsOfPoor(double quality) const
{
  std::vector<char> isPoor(m_Tetrahedra.size(), 0);
  ParallelFor(m_Tetrahedra.size(), Grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
    {
      const auto & c = m_Tetrahedra[t];
      isPoor[t] = !this->IsExterior(std::uint32_t(t)) &&
                  ShapeQuality(m_Points[c[0]], m_Points[c[1]], m_Points[c[2]], m_Points[c[3]]) < quality;
    }
  });
  return this->MarkCorners(isPoor);
}

std::size_t
PointSmoother::SmoothTriangles(double radiusRatio)
{
  return this->MoveByColour([=](PointId p) { return this->MoveForTriangles(p, radiusRatio); });
}

std::size_t
PointSmoother::ReturnToCells()
{
  return this->MoveByColour([this](PointId p) { return this->MoveToCell(p); });
}

/** Moves p to the target, or as near to it as its cell and the slack allow, if all around gets better than `worst`,
 * which is brought up to date. */
bool
PointSmoother::TryMove(PointId p, const Vector & target, double slack, double & worst)
{
  Vector x = target;
  if (!this->Admit(p, x, slack))
  {
    return false;
  }
  const double reached = this->WorstAround(p, x, worst);
  if (!(reached > worst))
  {
    return false;
  }
  if (m_Freedom[p] == Freedom::OnCell)
  {
    const double triangle = this->WorstTriangleAround(p, x);
    if (triangle < OptimizerState::TriangleFloor(worst) && triangle < this->WorstTriangleAround(p, m_Points[p]))
    {
      return false;
    }
  }
  m_Points[p] = x;
  worst = reached;
  return true;
}

/** Where one tetrahedron wants its corner p: above the centre of the opposite face, as high as in a regular one. */
Vector
PointSmoother::IdealPlace(PointId p, const Tetrahedron & t) const
{
  const int      own = int(std::find(t.begin(), t.end(), p) - t.begin());
  const Vector & a = m_Points[t[TetrahedronFaces[own][0]]];
  const Vector & b = m_Points[t[TetrahedronFaces[own][1]]];
  const Vector & c = m_Points[t[TetrahedronFaces[own][2]]];
  const Vector   normal = (b - a).cross(c - a); // away from p
  const double   area = normal.norm();
  if (!(area > 0.0))
  {
    return m_Points[p];
  }
  const double height = HeightOfRegular * std::sqrt(area / AreaOfRegular);
  return (a + b + c) / 3.0 - height / area * normal;
}

/** Searches for a place where the worst tetrahedron is better: towards what the worst ones want, then all around. */
bool
PointSmoother::MoveUphill(PointId p, double quality, double tolerance)
{
  if (m_Freedom[p] == Freedom::NearInterfaces)
  {
    return false;
  }
  std::array<std::pair<double, std::uint32_t>, 3> poorest;
  poorest.fill({ BestQuality, 0 }); // a point of an outer corner may have fewer than three tetrahedra
  for (auto s = m_Star.Begin(p); s != m_Star.End(p); ++s)
  {
    if (this->IsExterior(*s))
    {
      continue;
    }
    const auto & t = m_Tetrahedra[*s];
    const double q = ShapeQuality(m_Points[t[0]], m_Points[t[1]], m_Points[t[2]], m_Points[t[3]]);
    if (q < poorest[2].first)
    {
      poorest[2] = { q, *s };
      std::sort(poorest.begin(), poorest.end());
    }
  }
  double worst = poorest[0].first;
  if (worst >= quality)
  {
    return false;
  }
  bool moved = false;
  for (const auto & entry : poorest)
  {
    if (entry.first >= BestQuality)
    {
      break;
    }
    const Vector direction = this->IdealPlace(p, m_Tetrahedra[entry.second]) - m_Points[p];
    for (const double share : OptimizationParameters::SharesOfIdeal)
    {
      if (this->TryMove(p, m_Points[p] + share * direction, 0.0, worst))
      {
        moved = true;
        break;
      }
    }
  }
  if (worst >= OptimizationParameters::ShareOfPoorToSearch * quality)
  {
    return moved;
  }
  double size = 0.0;
  for (const auto corner : m_Tetrahedra[poorest[0].second])
  {
    size = std::max(size, (m_Points[corner] - m_Points[p]).norm());
  }
  for (const double slack : { 0.0, tolerance })
  {
    moved |= SearchAround(OptimizationParameters::LongestSearch * size,
                          OptimizationParameters::ShortestSearch * size,
                          [&](double step, const Vector & direction) {
                            return this->TryMove(p, m_Points[p] + step * direction, slack, worst);
                          });
    // only the flattest ones may take their corners off their cells
    if (m_Freedom[p] != Freedom::OnCell || worst >= QualityOfAngle(OptimizationParameters::AngleToLeaveCell))
    {
      break;
    }
  }
  return moved;
}

/** Searches the cell, or what is near the interfaces, for a place where the worst triangle is better; tetrahedra that
 * are good may lose for that. */
bool
PointSmoother::MoveForTriangles(PointId p, double radiusRatio)
{
  const bool isOnCell = m_Freedom[p] == Freedom::OnCell;
  if (!isOnCell && m_Freedom[p] != Freedom::NearInterfaces)
  {
    return false;
  }
  double worst = this->WorstTriangleAround(p, m_Points[p]);
  Vector onCell = m_Points[p];
  if (worst >= radiusRatio || (isOnCell && !m_Constraint.Project(p, onCell)))
  {
    return false;
  }
  const auto anywhere = [](const Vector & direction) { return direction; };
  // a point that had to leave its cell, or the interfaces, is not kept from moving by that
  if (!isOnCell)
  {
    const auto   materials = this->MaterialsAround(p);
    const double furthest =
      std::max(m_Parameters.interfaceTolerance, this->DistanceFromInterfaces(materials, p, m_Points[p]));
    return this->SearchForTriangles(
      p, anywhere, [&](Vector & x) { return this->DistanceFromInterfaces(materials, p, x) <= furthest; }, worst);
  }
  const double slack = (m_Points[p] - onCell).norm();
  const auto   along = [&](const Vector & direction) { return m_Constraint.AlongCell(p, m_Points[p], direction); };
  bool         moved = this->SearchForTriangles(p, along, [&](Vector & x) { return this->Admit(p, x, slack); }, worst);
  if (worst < m_Parameters.flatTriangle && m_Constraint.MayLeaveCell(p))
  {
    const double more = std::max(slack, m_Parameters.interfaceTolerance);
    moved |= this->SearchForTriangles(p, anywhere, [&](Vector & x) { return this->Admit(p, x, more); }, worst);
  }
  return moved;
}

/** Searches around p, in directions that `along` turns, for places that `admit` lets pass, or changes, where the worst
 * triangle is better than `worst`, which is brought up to date. */
template <typename TAlong, typename TAdmit>
bool
PointSmoother::SearchForTriangles(PointId p, const TAlong & along, const TAdmit & admit, double & worst)
{
  double size = 0.0;
  for (auto f = m_FanStart[p]; f < m_FanStart[p + 1]; ++f)
  {
    size = std::max(size, (m_Points[m_Fan[f][0]] - m_Points[p]).norm());
  }
  return SearchAround(OptimizationParameters::LongestSearch * size,
                      OptimizationParameters::ShortestSearchForTriangles * size,
                      [&](double step, const Vector & direction) {
                        Vector x = m_Points[p] + step * along(direction);
                        // `admit` takes longest, and changes little where triangles are not flat
                        const bool isHopeless =
                          worst >= m_Parameters.flatTriangle && !(this->WorstTriangleAround(p, x) > worst);
                        if (isHopeless || !admit(x))
                        {
                          return false;
                        }
                        const double reached = this->WorstTriangleAround(p, x);
                        if (!(reached > worst && this->StaysGood(p, x, m_Parameters.angleToKeepBesideTriangles)))
                        {
                          return false;
                        }
                        m_Points[p] = x;
                        worst = reached;
                        return true;
                      });
}

/** Moves p to its cell, or half the way, if tetrahedra and triangles stay good enough. */
bool
PointSmoother::MoveToCell(PointId p)
{
  Vector onCell = m_Points[p];
  if (m_Freedom[p] != Freedom::OnCell || !m_Constraint.Project(p, onCell) ||
      (onCell - m_Points[p]).norm() < OptimizationParameters::OnCell)
  {
    return false;
  }
  const double triangle =
    std::min(this->WorstTriangleAround(p, m_Points[p]), OptimizationParameters::TriangleFloorOfReturn);
  const double angle = m_Parameters.angleToKeepBesideTriangles;
  return this->MoveIfGood(p, onCell, angle, triangle) ||
         this->MoveIfGood(p, m_Points[p] + 0.5 * (onCell - m_Points[p]), angle, triangle);
}

} // namespace mmm
