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
#include "optimize/MovablePoints.h"

#include "base/ParallelCollect.h"
#include "optimize/ShapeQuality.h"
#include "mesh/TetrahedronNeighbours.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
constexpr std::size_t Grain = 512;
} // namespace

MovablePoints::MovablePoints(const InterfaceConstraint &    constraint,
                             Material                       exterior,
                             const OptimizationParameters & parameters,
                             std::vector<Vector> &          points,
                             const TetrahedralComplex &     complex)
  : m_Constraint(constraint)
  , m_Parameters(parameters)
  , m_Exterior(exterior)
  , m_Cells(constraint.Cells())
  , m_Points(points)
  , m_Complex(complex)
  , m_Tetrahedra(complex.Tetrahedra())
  , m_Materials(complex.Materials())
  , m_Star(StarsOfPoints(m_Tetrahedra, points.size()))
{
  this->ClassifyPoints();
  this->ColourPoints();
}

void
MovablePoints::ClassifyPoints()
{
  // the materials that really meet at each point, against those of its cell
  std::vector<std::pair<PointId, std::array<PointId, 2>>> fans;
  std::vector<char>                                       outside(m_Points.size(), 0);
  for (std::uint32_t t = 0; t < m_Tetrahedra.size(); ++t)
  {
    for (int f = 0; f < 4; ++f)
    {
      const auto other = m_Complex.Neighbour(t, f);
      if (other == NoTetrahedron ? this->IsExterior(t) : m_Materials[other] <= m_Materials[t])
      {
        continue;
      }
      PointId corners[3];
      for (int c = 0; c < 3; ++c)
      {
        corners[c] = m_Tetrahedra[t][TetrahedronFaces[f][c]];
        outside[corners[c]] |= other == NoTetrahedron;
      }
      for (int c = 0; c < 3; ++c)
      {
        fans.push_back({ corners[c], { { corners[(c + 1) % 3], corners[(c + 2) % 3] } } });
      }
    }
  }
  m_FanStart.assign(m_Points.size() + 1, 0);
  for (const auto & fan : fans)
  {
    ++m_FanStart[fan.first + 1];
  }
  for (std::size_t p = 0; p < m_Points.size(); ++p)
  {
    m_FanStart[p + 1] += m_FanStart[p];
  }
  m_Fan.resize(fans.size());
  std::vector<std::uint32_t> next(m_FanStart.begin(), m_FanStart.end() - 1);
  for (const auto & fan : fans)
  {
    m_Fan[next[fan.first]++] = fan.second;
  }

  m_Freedom.assign(m_Points.size(), Freedom::Free);
  for (std::size_t p = 0; p < m_Points.size(); ++p)
  {
    if (!this->IsOnInterface(PointId(p)))
    {
      continue;
    }
    m_Freedom[p] = Freedom::Fixed;
    if (p >= m_Cells.size() || (m_Cells[p].Dimension() == 0 && !m_Constraint.MayLeaveCell(PointId(p))))
    {
      continue;
    }
    auto present = this->MaterialsAround(PointId(p));
    if (outside[p] && std::find(present.begin(), present.end(), m_Exterior) == present.end())
    {
      present.push_back(m_Exterior);
    }
    std::vector<Material> own;
    for (const Material m : m_Cells[p])
    {
      const Material mapped = m_Constraint.MaterialOf(m);
      if (std::find(own.begin(), own.end(), mapped) == own.end())
      {
        own.push_back(mapped);
      }
    }
    std::sort(present.begin(), present.end());
    std::sort(own.begin(), own.end());
    if (present == own)
    {
      m_Freedom[p] = Freedom::OnCell;
    }
    else if (!outside[p] && m_Constraint.MayLeaveCell(PointId(p)) &&
             this->DistanceFromInterfaces(present, PointId(p), m_Points[p]) <
               OptimizationParameters::NearInTolerances * m_Parameters.interfaceTolerance)
    {
      m_Freedom[p] = Freedom::NearInterfaces;
    }
  }
}

std::vector<char>
MovablePoints::MarkCorners(const std::vector<char> & tetrahedra) const
{
  std::vector<char> marks(m_Points.size(), 0);
  for (std::size_t t = 0; t < tetrahedra.size(); ++t)
  {
    for (int c = 0; tetrahedra[t] && c < 4; ++c)
    {
      marks[m_Tetrahedra[t][c]] = 1;
    }
  }
  return marks;
}

std::vector<Material>
MovablePoints::MaterialsAround(PointId p) const
{
  std::vector<Material> materials;
  for (auto s = m_Star.Begin(p); s != m_Star.End(p); ++s)
  {
    if (std::find(materials.begin(), materials.end(), m_Materials[*s]) == materials.end())
    {
      materials.push_back(m_Materials[*s]);
    }
  }
  return materials;
}

/** The largest distance of x from the interfaces of some materials. */
double
MovablePoints::DistanceFromInterfaces(const std::vector<Material> & materials, PointId p, const Vector & x) const
{
  double largest = 0.0;
  for (std::size_t i = 0; i < materials.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      largest = std::max(largest, m_Constraint.DistanceToInterface(materials[i], materials[j], x, p));
    }
  }
  return largest;
}

void
MovablePoints::ColourPoints()
{
  std::vector<int>  colour(m_Points.size(), -1);
  std::vector<char> taken;
  for (PointId p = 0; p < m_Points.size(); ++p)
  {
    if (m_Freedom[p] == Freedom::Fixed || m_Star.Begin(p) == m_Star.End(p))
    {
      continue;
    }
    taken.assign(m_Colours.size() + 1, 0);
    for (auto s = m_Star.Begin(p); s != m_Star.End(p); ++s)
    {
      for (const auto corner : m_Tetrahedra[*s])
      {
        if (colour[corner] >= 0)
        {
          taken[colour[corner]] = 1;
        }
      }
    }
    colour[p] = int(std::find(taken.begin(), taken.end(), 0) - taken.begin());
    if (std::size_t(colour[p]) == m_Colours.size())
    {
      m_Colours.emplace_back();
    }
    m_Colours[colour[p]].push_back(p);
  }
}

std::size_t
MovablePoints::MoveByColour(const std::function<bool(PointId)> & move)
{
  std::size_t total = 0;
  for (const auto & group : m_Colours)
  {
    total += ParallelCount(group.size(), Grain, [&](std::size_t n) { return move(group[n]); });
  }
  return total;
}

/** The smallest quality around p if it were at x; the search ends early at one that is not better than `enough`. */
double
MovablePoints::WorstAround(PointId p, const Vector & x, double enough) const
{
  double worst = BestQuality;
  for (auto s = m_Star.Begin(p); s != m_Star.End(p); ++s)
  {
    const auto corners = this->CornersWith(*s, p, x);
    worst = std::min(worst, MaterialQuality(*corners[0], *corners[1], *corners[2], *corners[3], this->IsExterior(*s)));
    if (worst <= enough)
    {
      return worst;
    }
  }
  return worst;
}

/** Whether tetrahedra around p are good enough if it moves to x: those of larger angles than `angle`, in degrees, may
 * lose down to it, others have to be better than the worst one is now. */
bool
MovablePoints::StaysGood(PointId p, const Vector & x, double angle) const
{
  const double enough = QualityOfAngle(angle);
  if (this->WorstAround(p, x, enough) > enough)
  {
    return true;
  }
  const double worst = this->WorstAround(p, m_Points[p], WorstQuality);
  return (worst < enough) && (this->WorstAround(p, x, worst) > worst);
}

double
MovablePoints::WorstTriangleAround(PointId p, const Vector & x) const
{
  double worst = 1.0;
  for (auto f = m_FanStart[p]; f < m_FanStart[p + 1]; ++f)
  {
    worst = std::min(worst, TriangleRadiusRatio(x, m_Points[m_Fan[f][0]], m_Points[m_Fan[f][1]]));
  }
  return worst;
}

Vector
MovablePoints::SearchDirection(int number)
{
  if (number < 6)
  {
    return Vector::Unit(number / 2) * (number % 2 ? 1.0 : -1.0);
  }
  const int bits = number - 6;
  return Vector(bits & 1 ? 1 : -1, bits & 2 ? 1 : -1, bits & 4 ? 1 : -1) / std::sqrt(3.0);
}

bool
MovablePoints::Admit(PointId p, Vector & x, double slack) const
{
  if (m_Freedom[p] != Freedom::OnCell)
  {
    return true;
  }
  Vector onCell = x;
  if (!m_Constraint.Project(p, onCell))
  {
    return false;
  }
  if (!m_Constraint.MayLeaveCell(p))
  {
    slack = 0.0;
  }
  const double distance = (x - onCell).norm();
  x = distance > slack ? Vector(onCell + slack / distance * (x - onCell)) : x;
  return true;
}

/** Moves p to x if tetrahedra stay good enough, and all triangles are at least as good as `triangle` then. */
bool
MovablePoints::MoveIfGood(PointId p, const Vector & x, double angle, double triangle)
{
  if (this->WorstTriangleAround(p, x) < triangle || !this->StaysGood(p, x, angle))
  {
    return false;
  }
  m_Points[p] = x;
  return true;
}
} // namespace mmm
