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

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
using Parameters = OptimizationParameters;

/** The worth of a triangle by its radius ratio: the worse, the more a gain counts. */
double
WorthOfTriangle(double radiusRatio)
{
  return radiusRatio - Parameters::TriangleScarcity / (radiusRatio + Parameters::TriangleOffset);
}
double
DerivativeOfWorth(double radiusRatio)
{
  return 1.0 + Parameters::TriangleScarcity /
                 ((radiusRatio + Parameters::TriangleOffset) * (radiusRatio + Parameters::TriangleOffset));
}
} // namespace

/** The tetrahedra around a point that moves, exterior ones aside. */
class PointSmoother::MovedStar
{
public:
  MovedStar(const PointSmoother & smoother, PointId p)
  {
    for (auto s = smoother.m_Star.Begin(p); s != smoother.m_Star.End(p); ++s)
    {
      if (smoother.IsExterior(*s))
      {
        continue;
      }
      const int at = int(m_Own.size()) % EightTetrahedra::Count;
      if (at == 0)
      {
        m_Tetrahedra.emplace_back();
      }
      const Tetrahedron & corners = smoother.m_Tetrahedra[*s];
      for (int c = 0; c < 4; ++c)
      {
        m_Tetrahedra.back().SetCorner(at, c, smoother.m_Points[corners[c]]);
      }
      m_Own.push_back(int(std::find(corners.begin(), corners.end(), p) - corners.begin()));
    }
  }

  /** Adds the radius ratios times a weight, if the point were at x, to a sum. */
  void
  AddRadiusRatios(const Vector & x, double weight, double & sum)
  {
    for (std::size_t t = 0; t < m_Own.size(); ++t)
    {
      m_Tetrahedra[t / EightTetrahedra::Count].SetCorner(int(t % EightTetrahedra::Count), m_Own[t], x);
    }
    for (std::size_t t = 0; t < m_Own.size();)
    {
      for (const double ratio : TetrahedronRadiusRatios(m_Tetrahedra[t / EightTetrahedra::Count]))
      {
        if (t++ < m_Own.size())
        {
          sum += weight * ratio;
        }
      }
    }
  }

private:
  std::vector<EightTetrahedra> m_Tetrahedra;
  std::vector<int>             m_Own; // which corner the point is
};

std::size_t
PointSmoother::SmoothAll()
{
  return this->MoveByColour(
    [this](PointId p) { return this->MoveUphillOnAverage(p, [&](Vector & x) { return this->Admit(p, x, 0.0); }); });
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
    gradient += Parameters::TriangleWeight * DerivativeOfWorth(TriangleRadiusRatio(x, b, c)) *
                TriangleRadiusRatioGradient(x, b, c);
  }
  return gradient;
}

/** The sum of the radius ratios of tetrahedra around p and of the worth of triangles, if p were at x. */
double
PointSmoother::TotalAround(PointId p, MovedStar & star, const Vector & x) const
{
  double total = 0.0;
  if (m_Parameters.tetrahedronWeight > 0.0)
  {
    star.AddRadiusRatios(x, m_Parameters.tetrahedronWeight, total);
  }
  for (auto f = m_FanStart[p]; f < m_FanStart[p + 1]; ++f)
  {
    total += Parameters::TriangleWeight *
             WorthOfTriangle(TriangleRadiusRatio(x, m_Points[m_Fan[f][0]], m_Points[m_Fan[f][1]]));
  }
  return total;
}

/** A step uphill in what TotalAround() gives, to a place that `admit` lets pass, or changes. Where the worst
 * tetrahedron around is good, it may lose a little. */
bool
PointSmoother::MoveUphillOnAverage(PointId p, const std::function<bool(Vector &)> & admit)
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
  MovedStar    star(*this, p);
  const double total = this->TotalAround(p, star, from);
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
  const auto at = [&](double step) { return Vector(from + gradient * (step * shortest / length)); };
  // to the top of the parabola that has the total and its slope here, and the total at a trial
  double step = 0.5 * Parameters::TrialStepUphill;
  Vector x = at(Parameters::TrialStepUphill);
  if (admit(x))
  {
    const double slope = length * shortest;
    const double bend = slope - (this->TotalAround(p, star, x) - total) / Parameters::TrialStepUphill;
    step = bend > 0.0 ? std::min(Parameters::LongestStepUphill, 0.5 * slope * Parameters::TrialStepUphill / bend)
                      : Parameters::LongestStepUphill;
  }
  for (int trial = 0; trial < Parameters::StepsUphill && step > Parameters::ShortestStepUphill; ++trial, step *= 0.5)
  {
    x = at(step);
    if (admit(x) && this->TotalAround(p, star, x) > total && this->StaysGood(p, x, m_Parameters.angleToKeep))
    {
      m_Points[p] = x;
      return true;
    }
  }
  return false;
}
} // namespace mmm
