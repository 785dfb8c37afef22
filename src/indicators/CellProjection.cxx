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
#include "indicators/IndicatorSet.h"

#include "base/Shortened.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
using Parameters = ProjectionParameters;
} // namespace

struct IndicatorSet::Residuals
{
  int    count{ 0 };
  double values[4];
  Vector gradients[4];
};

IndicatorSet::Residuals
IndicatorSet::ResidualsAt(const Cell & cell, const Vector & x) const
{
  const TricubicGradientStencil stencil(m_Grid, x);
  double                        firstValue = 0.0;
  Vector                        firstGradient = Vector::Zero();
  bool                          isFirst = true;
  Residuals                     residuals;
  for (const Material m : cell)
  {
    double & value = residuals.values[residuals.count];
    Vector & gradient = residuals.gradients[residuals.count];
    if (m_Planes.Has(m))
    {
      value = m_Planes.Value(m, x);
      gradient = m_Planes.Gradient(m);
      ++residuals.count;
    }
    else if (isFirst)
    {
      firstValue = stencil.Value(m_Indicators[m], m_Outside, firstGradient);
      isFirst = false;
    }
    else
    {
      Vector ofOther;
      value = firstValue - stencil.Value(m_Indicators[m], m_Outside, ofOther);
      gradient = firstGradient - ofOther;
      ++residuals.count;
    }
  }
  return residuals;
}

bool
IndicatorSet::GaussNewtonStep(const Cell & cell, const Vector & x, Vector & step, Vector & direction) const
{
  using Jacobian = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor, 3, 3>;
  using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 3, 3>;
  using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 3, 1>;

  if (cell.count > 4)
  {
    return false; // no such place is known but the one where its junctions were joined
  }
  const Residuals residuals = this->ResidualsAt(cell, x);
  const Vector *  gradients = residuals.gradients;
  // outside of the band, nothing tells the way
  if (std::any_of(gradients, gradients + residuals.count, [](const Vector & gradient) {
        return gradient.squaredNorm() < Parameters::LeastSquaredGradient;
      }))
  {
    return false;
  }
  if (residuals.count == 1)
  {
    const double square = gradients[0].squaredNorm();
    step = -residuals.values[0] / square * gradients[0];
    direction = gradients[0] / (this->IsPlane(cell.materials[1]) ? std::sqrt(square) : -std::sqrt(square));
  }
  else
  {
    Jacobian j(residuals.count, 3);
    Column   r(residuals.count);
    for (int n = 0; n < residuals.count; ++n)
    {
      j.row(n) = gradients[n].transpose();
      r[n] = residuals.values[n];
    }
    Square a = j * j.transpose();
    a.diagonal().array() += Parameters::Regularization * a.trace();
    step = -(j.transpose() * a.ldlt().solve(r));
    direction = gradients[0].cross(gradients[1]).normalized();
  }
  return step.squaredNorm() < Parameters::LargestSquaredStep;
}

bool
IndicatorSet::Project(const Cell & cell, Vector & x, double reach) const
{
  const Vector start = x;
  for (int n = 0; n < Parameters::GaussNewtonSteps; ++n)
  {
    Vector step;
    Vector direction;
    if (!this->GaussNewtonStep(cell, x, step, direction))
    {
      return false;
    }
    if (step.norm() < Parameters::Accuracy)
    {
      x += step;
      this->SnapToPlanes(cell, x);
      return (x - start).norm() <= reach;
    }
    x += Shortened(step, Parameters::LongestGaussNewtonStep);
    if ((x - start).norm() > 2.0 * reach)
    {
      return false;
    }
  }
  return false;
}

bool
IndicatorSet::Approach(const Cell & cell, Vector & x, Vector & direction) const
{
  constexpr double Furthest = Parameters::LongestApproach;
  Vector           step;
  if (!this->GaussNewtonStep(cell, x, step, direction) || step.squaredNorm() > Furthest * Furthest)
  {
    return false;
  }
  x += step;
  this->SnapToPlanes(cell, x);
  return true;
}

void
IndicatorSet::SnapToPlanes(const Cell & cell, Vector & x) const
{
  for (const Material m : cell)
  {
    if (this->IsPlane(m))
    {
      m_Planes.Snap(m, x);
    }
  }
}

bool
IndicatorSet::IsMaximal(const Cell & cell, const Vector & x, double tolerance) const
{
  for (int p = 0; p < BoxPlanes::Count; ++p)
  {
    const Material plane = m_Planes.At(p);
    if (m_Planes.Value(plane, x) > (cell.Has(plane) ? tolerance : 0.0))
    {
      return false;
    }
  }
  const TricubicStencil stencil(m_Grid, x);
  double                own = 0.0;
  int                   count = 0;
  for (const Material m : cell)
  {
    if (!this->IsPlane(m))
    {
      own += this->Evaluate(m, stencil);
      ++count;
    }
  }
  own /= std::max(count, 1);
  const auto range = this->Candidates(x);
  for (auto m = range.first; m != range.second; ++m)
  {
    if (!cell.Has(*m) && this->Evaluate(*m, stencil) > own + tolerance)
    {
      return false;
    }
  }
  return count > 0;
}

Vector
IndicatorSet::Normal(const Cell & cell, const Vector & x) const
{
  const Residuals residuals = this->ResidualsAt(cell, x);
  // f_low - f_high falls towards the higher material; a plane's own function rises towards it
  const Vector normal = this->IsPlane(cell.materials[1]) ? residuals.gradients[0] : Vector(-residuals.gradients[0]);
  const double length = normal.norm();
  return length > 0.0 ? Vector(normal / length) : Vector::UnitZ();
}

Vector
IndicatorSet::Tangent(const Cell & cell, const Vector & x) const
{
  const Residuals residuals = this->ResidualsAt(cell, x);
  const Vector    tangent = residuals.gradients[0].cross(residuals.gradients[1]);
  const double    length = tangent.norm();
  return length > 0.0 ? Vector(tangent / length) : Vector::UnitZ();
}
} // namespace mmm
