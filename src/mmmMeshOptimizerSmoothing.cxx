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
#include "mmmMeshOptimizerSmoothing.h"

#include "mmmOptimizerState.h"
#include "mmmParallel.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
constexpr std::size_t Grain = 512;
/** How much an interface triangle counts against a tetrahedron. */
constexpr double TriangleWeight = 8.0;
/** The worth of a triangle by its radius ratio: the worse, the more a gain counts. */
double
WorthOfTriangle(double radiusRatio)
{
  return radiusRatio - 0.5 / (radiusRatio + 0.05);
}
double
DerivativeOfWorth(double radiusRatio)
{
  return 1.0 + 0.5 / ((radiusRatio + 0.05) * (radiusRatio + 0.05));
}
/** A particle leaves its cell, within the tolerance, only where a tetrahedron has an angle below this, in degrees. */
constexpr double AngleToLeaveCell = 20.0;
/** Particles that are this near are on their cell, in units of the smallest voxel spacing. */
constexpr double NegligibleDistance = 1e-3;
/** Triangles keep this radius ratio when points return to their cells. */
constexpr double TriangleToKeep = 0.5;

/** The axes, then the diagonals. */
constexpr int SearchDirections = 14;
Vector
SearchDirection(int number)
{
  if (number < 6)
  {
    return Vector::Unit(number / 2) * (number % 2 ? 1.0 : -1.0);
  }
  const int bits = number - 6;
  return Vector(bits & 1 ? 1 : -1, bits & 2 ? 1 : -1, bits & 4 ? 1 : -1) / std::sqrt(3.0);
}
} // namespace

PointSmoother::PointSmoother(const InterfaceConstraint &    constraint,
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
  , m_Star(points.size(), m_Tetrahedra.size(), [&](std::size_t t) -> const Tetrahedron & { return m_Tetrahedra[t]; })
{
  this->ClassifyPoints();
  this->ColourPoints();
}

void
PointSmoother::ClassifyPoints()
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
    if (m_FanStart[p] == m_FanStart[p + 1])
    {
      continue; // on no interface
    }
    m_Freedom[p] = Freedom::Fixed;
    if (p >= m_Cells.size() || m_Cells[p].Dimension() == 0)
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
    else if (!outside[p] && m_Constraint.MayLeaveCell(PointId(p)))
    {
      m_Freedom[p] = Freedom::NearInterfaces;
    }
  }
}

std::vector<Material>
PointSmoother::MaterialsAround(PointId p) const
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
PointSmoother::DistanceFromInterfaces(const std::vector<Material> & materials, PointId p, const Vector & x) const
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
PointSmoother::ColourPoints()
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
PointSmoother::MoveByColour(const std::function<bool(PointId)> & move)
{
  std::size_t total = 0;
  for (const auto & group : m_Colours)
  {
    std::vector<std::size_t> moved((group.size() + Grain - 1) / Grain, 0);
    ParallelFor(group.size(), Grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
      {
        moved[begin / Grain] += move(group[n]);
      }
    });
    for (const auto count : moved)
    {
      total += count;
    }
  }
  return total;
}

std::size_t
PointSmoother::SmoothAll()
{
  return this->MoveByColour([this](PointId p) { return this->MoveUphillOnAverage(p); });
}

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
  std::vector<char> marks(m_Points.size(), 0);
  for (std::size_t t = 0; t < isPoor.size(); ++t)
  {
    for (int c = 0; isPoor[t] && c < 4; ++c)
    {
      marks[m_Tetrahedra[t][c]] = 1;
    }
  }
  return marks;
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

/** The smallest quality around p if it were at x; the search ends early at one that is not better than `enough`. */
double
PointSmoother::WorstAround(PointId p, const Vector & x, double enough) const
{
  double worst = 2.0;
  for (auto s = m_Star.Begin(p); s != m_Star.End(p); ++s)
  {
    const auto &   t = m_Tetrahedra[*s];
    const Vector * corners[4];
    for (int c = 0; c < 4; ++c)
    {
      corners[c] = t[c] == p ? &x : &m_Points[t[c]];
    }
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
PointSmoother::StaysGood(PointId p, const Vector & x, double angle) const
{
  const double enough = QualityOfAngle(angle);
  if (this->WorstAround(p, x, enough) > enough)
  {
    return true;
  }
  const double                                           worst = this->WorstAround(p, m_Points[p], -2.0);
  return worst<enough && this->WorstAround(p, x, worst)> worst;
}

double
PointSmoother::WorstTriangleAround(PointId p, const Vector & x) const
{
  double worst = 1.0;
  for (auto f = m_FanStart[p]; f < m_FanStart[p + 1]; ++f)
  {
    worst = std::min(worst, TriangleRadiusRatio(x, m_Points[m_Fan[f][0]], m_Points[m_Fan[f][1]]));
  }
  return worst;
}

bool
PointSmoother::Admit(PointId p, Vector & x, double slack) const
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
  const double height = 0.8165 * std::sqrt(area / 0.8660254);
  return (a + b + c) / 3.0 - height / area * normal;
}

/** The gradient of what TotalAround() gives, where p is. */
Vector
PointSmoother::GradientAround(PointId p) const
{
  Vector         gradient = Vector::Zero();
  const Vector & x = m_Points[p];
  const bool     withTetrahedra = m_Parameters.tetrahedronWeight > 0.0;
  for (auto s = m_Star.Begin(p); withTetrahedra && s != m_Star.End(p); ++s)
  {
    if (this->IsExterior(*s))
    {
      continue;
    }
    // any order of the others will do: the radius ratio does not depend on the orientation
    const Vector * others[3];
    int            count = 0;
    for (const auto corner : m_Tetrahedra[*s])
    {
      if (corner != p)
      {
        others[count++] = &m_Points[corner];
      }
    }
    gradient += m_Parameters.tetrahedronWeight * TetrahedronRadiusRatioGradient(x, *others[0], *others[1], *others[2]);
  }
  for (auto f = m_FanStart[p]; f < m_FanStart[p + 1]; ++f)
  {
    const Vector & b = m_Points[m_Fan[f][0]];
    const Vector & c = m_Points[m_Fan[f][1]];
    gradient += TriangleWeight * DerivativeOfWorth(TriangleRadiusRatio(x, b, c)) * TriangleRadiusRatioGradient(x, b, c);
  }
  return gradient;
}

/** The sum of the radius ratios of tetrahedra around p and of the worth of triangles, if p were at x. */
double
PointSmoother::TotalAround(PointId p, const Vector & x) const
{
  double     total = 0.0;
  const bool withTetrahedra = m_Parameters.tetrahedronWeight > 0.0;
  for (auto s = m_Star.Begin(p); withTetrahedra && s != m_Star.End(p); ++s)
  {
    if (this->IsExterior(*s))
    {
      continue;
    }
    const auto &   t = m_Tetrahedra[*s];
    const Vector * corners[4];
    for (int c = 0; c < 4; ++c)
    {
      corners[c] = t[c] == p ? &x : &m_Points[t[c]];
    }
    total +=
      m_Parameters.tetrahedronWeight * TetrahedronRadiusRatio(*corners[0], *corners[1], *corners[2], *corners[3]);
  }
  for (auto f = m_FanStart[p]; f < m_FanStart[p + 1]; ++f)
  {
    total += TriangleWeight * WorthOfTriangle(TriangleRadiusRatio(x, m_Points[m_Fan[f][0]], m_Points[m_Fan[f][1]]));
  }
  return total;
}

/** A step uphill in what TotalAround() gives. Where the worst tetrahedron around is good, it may lose a little. */
bool
PointSmoother::MoveUphillOnAverage(PointId p)
{
  if (m_Freedom[p] == Freedom::NearInterfaces)
  {
    return false;
  }
  double shortest = 1e300;
  for (auto s = m_Star.Begin(p); s != m_Star.End(p); ++s)
  {
    for (const auto corner : m_Tetrahedra[*s])
    {
      if (corner != p)
      {
        shortest = std::min(shortest, (m_Points[corner] - m_Points[p]).squaredNorm());
      }
    }
  }
  shortest = std::sqrt(shortest);
  const Vector from = m_Points[p];
  const double total = this->TotalAround(p, from);
  Vector       gradient = this->GradientAround(p);
  if (m_Freedom[p] == Freedom::OnCell)
  {
    gradient = m_Constraint.AlongCell(p, from, gradient);
  }
  const double length = gradient.norm();
  if (!(length > 0.0))
  {
    return false;
  }
  for (double step = 0.16; step > 0.015; step *= 0.5)
  {
    Vector x = from + gradient * (step * shortest / length);
    if (this->Admit(p, x, 0.0) && this->TotalAround(p, x) > total && this->StaysGood(p, x, m_Parameters.angleToKeep))
    {
      m_Points[p] = x;
      return true;
    }
  }
  return false;
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
  constexpr double None = 2.0; // a point of an outer corner may have fewer than three tetrahedra
  poorest.fill({ None, 0 });
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
    if (entry.first >= None)
    {
      break;
    }
    const Vector direction = this->IdealPlace(p, m_Tetrahedra[entry.second]) - m_Points[p];
    for (const double share : { 0.5, 0.2, 0.05 })
    {
      if (this->TryMove(p, m_Points[p] + share * direction, 0.0, worst))
      {
        moved = true;
        break;
      }
    }
  }
  if (worst >= 0.5 * quality)
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
    for (double step = 0.2 * size; step > 0.02 * size; step *= 0.5)
    {
      for (int d = 0; d < SearchDirections; ++d)
      {
        moved = this->TryMove(p, m_Points[p] + step * SearchDirection(d), slack, worst) || moved;
      }
    }
    // only the flattest ones may take their corners off their cells
    if (m_Freedom[p] != Freedom::OnCell || worst >= QualityOfAngle(AngleToLeaveCell))
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
  // a point that had to leave its cell, or the interfaces, is not kept from moving by that
  const double slack = (m_Points[p] - onCell).norm();
  const auto   materials = isOnCell ? std::vector<Material>() : this->MaterialsAround(p);
  const double furthest =
    std::max(m_Parameters.interfaceTolerance, this->DistanceFromInterfaces(materials, p, m_Points[p]));
  double size = 0.0;
  for (auto f = m_FanStart[p]; f < m_FanStart[p + 1]; ++f)
  {
    size = std::max(size, (m_Points[m_Fan[f][0]] - m_Points[p]).norm());
  }
  bool moved = false;
  for (double step = 0.2 * size; step > 0.01 * size; step *= 0.5)
  {
    for (int d = 0; d < SearchDirections; ++d)
    {
      const Vector direction = SearchDirection(d);
      Vector       x = m_Points[p] + step * (isOnCell ? m_Constraint.AlongCell(p, m_Points[p], direction) : direction);
      if (isOnCell ? !this->Admit(p, x, slack) : this->DistanceFromInterfaces(materials, p, x) > furthest)
      {
        continue;
      }
      const double reached = this->WorstTriangleAround(p, x);
      if (reached > worst && this->StaysGood(p, x, m_Parameters.angleToKeepBesideTriangles))
      {
        m_Points[p] = x;
        worst = reached;
        moved = true;
      }
    }
  }
  return moved;
}

/** Moves p to its cell, or half the way, if tetrahedra and triangles stay good enough. */
bool
PointSmoother::MoveToCell(PointId p)
{
  Vector onCell = m_Points[p];
  if (m_Freedom[p] != Freedom::OnCell || !m_Constraint.Project(p, onCell) ||
      (onCell - m_Points[p]).norm() < NegligibleDistance)
  {
    return false;
  }
  const double triangle = std::min(this->WorstTriangleAround(p, m_Points[p]), TriangleToKeep);
  const double angle = m_Parameters.angleToKeepBesideTriangles;
  return this->MoveIfGood(p, onCell, angle, triangle) ||
         this->MoveIfGood(p, m_Points[p] + 0.5 * (onCell - m_Points[p]), angle, triangle);
}

/** Moves p to x if tetrahedra stay good enough, and all triangles are at least as good as `triangle` then. */
bool
PointSmoother::MoveIfGood(PointId p, const Vector & x, double angle, double triangle)
{
  if (this->WorstTriangleAround(p, x) < triangle || !this->StaysGood(p, x, angle))
  {
    return false;
  }
  m_Points[p] = x;
  return true;
}
} // namespace mmm
