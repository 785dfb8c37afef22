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
#include "mmmCriticalPoint.h"

#include <cmath>

namespace mmm
{
namespace
{
/** Away from others, the difference of two signed distances has a gradient of 2. */
constexpr double SteepStart = 1.6;
constexpr double Converged = 0.02;
constexpr double Tolerated = 0.1;
/** Second derivatives below this, per voxel, are none. */
constexpr double LeastBend = 0.1;
constexpr int    MaximumSteps = 6;
constexpr double LongestStep = 0.25;
constexpr double DifferenceStep = 0.05;

Vector
GradientOfDifference(const IndicatorSet & indicators, Material a, Material b, const Vector & x)
{
  Vector first;
  Vector second;
  indicators.ValueAndGradient(a, x, first);
  indicators.ValueAndGradient(b, x, second);
  return first - second;
}

/** By central differences of gradients. */
Eigen::Matrix3d
HessianOfDifference(const IndicatorSet & indicators, Material a, Material b, const Vector & x)
{
  Eigen::Matrix3d hessian;
  for (int axis = 0; axis < 3; ++axis)
  {
    const Vector step = DifferenceStep * Vector::Unit(axis);
    hessian.col(axis) =
      (GradientOfDifference(indicators, a, b, x + step) - GradientOfDifference(indicators, a, b, x - step)) /
      (2.0 * DifferenceStep);
  }
  return 0.5 * (hessian + hessian.transpose());
}

/** To where a quadratic function has no gradient, along the axes in which it bends. */
Vector
NewtonStep(const Vector & gradient, const Eigen::Matrix3d & hessian)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(hessian);
  Vector                                               step = Vector::Zero();
  for (int n = 0; n < 3; ++n)
  {
    const double bend = solver.eigenvalues()[n];
    if (std::abs(bend) > LeastBend)
    {
      const Vector axis = solver.eigenvectors().col(n);
      step -= axis.dot(gradient) / bend * axis;
    }
  }
  const double length = step.norm();
  return length > LongestStep ? Vector(step * (LongestStep / length)) : step;
}
} // namespace

bool
FindCriticalPoint(const IndicatorSet & indicators, Material a, Material b, const Vector & reach, Vector & x)
{
  const Vector start = x;
  Vector       gradient = GradientOfDifference(indicators, a, b, x);
  if (gradient.norm() > SteepStart)
  {
    return false;
  }
  for (int n = 0; n < MaximumSteps && gradient.norm() > Converged; ++n)
  {
    x += NewtonStep(gradient, HessianOfDifference(indicators, a, b, x));
    if (((x - start).cwiseAbs() - reach).maxCoeff() > 0.0)
    {
      return false;
    }
    gradient = GradientOfDifference(indicators, a, b, x);
  }
  return gradient.norm() < Tolerated;
}
} // namespace mmm
