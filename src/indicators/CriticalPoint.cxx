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
#include "indicators/CriticalPoint.h"

#include "base/Shortened.h"

#include <cmath>

namespace mmm
{
namespace
{
using Parameters = CriticalPointParameters;

/** How much one material leads another one, as a function of places in voxels. */
class Lead
{
public:
  Lead(const IndicatorSet & indicators, Material a, Material b)
    : m_Indicators(indicators)
    , m_A(a)
    , m_B(b)
  {}

  Vector
  GradientInVoxels(const Vector & at) const
  {
    const Vector & spacing = m_Indicators.GetGrid().spacing;
    const Vector   x = at.cwiseProduct(spacing);
    Vector         first;
    Vector         second;
    m_Indicators.ValueAndGradient(m_A, x, first);
    m_Indicators.ValueAndGradient(m_B, x, second);
    return (first - second).cwiseProduct(spacing);
  }

  /** What a gradient is in space. */
  double
  Steepness(const Vector & gradientInVoxels) const
  {
    return gradientInVoxels.cwiseQuotient(m_Indicators.GetGrid().spacing).norm();
  }

  /** By central differences of gradients. */
  Eigen::Matrix3d
  HessianInVoxels(const Vector & at) const
  {
    Eigen::Matrix3d hessian;
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector step = Parameters::DifferenceStep * Vector::Unit(axis);
      hessian.col(axis) =
        (this->GradientInVoxels(at + step) - this->GradientInVoxels(at - step)) / (2.0 * Parameters::DifferenceStep);
    }
    return 0.5 * (hessian + hessian.transpose());
  }

private:
  const IndicatorSet & m_Indicators;
  const Material       m_A;
  const Material       m_B;
};

/** To where a quadratic function has no gradient, along the axes in which it bends. */
Vector
NewtonStep(const Vector & gradient, const Eigen::Matrix3d & hessian)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(hessian);
  Vector                                               step = Vector::Zero();
  for (int n = 0; n < 3; ++n)
  {
    const double bend = solver.eigenvalues()[n];
    if (std::abs(bend) > Parameters::LeastBend)
    {
      const Vector axis = solver.eigenvectors().col(n);
      step -= axis.dot(gradient) / bend * axis;
    }
  }
  return Shortened(step, Parameters::LongestNewtonStep);
}

/** Beyond the nodes at the border indicators are constant across it. */
bool
IsBetweenNodes(const Grid & grid, const Vector & at)
{
  return at.minCoeff() > 0.0 && at[0] < grid.size[0] - 1 && at[1] < grid.size[1] - 1 && at[2] < grid.size[2] - 1;
}
} // namespace

bool
FindCriticalPoint(const IndicatorSet & indicators, Material a, Material b, double reach, Vector & x)
{
  const Grid & grid = indicators.GetGrid();
  const Lead   lead(indicators, a, b);
  const Vector start = x.cwiseQuotient(grid.spacing);
  Vector       at = start;
  Vector       gradient = lead.GradientInVoxels(at);
  if (!IsBetweenNodes(grid, at) || lead.Steepness(gradient) > Parameters::SteepStart)
  {
    return false;
  }
  for (int n = 0; n < Parameters::NewtonSteps && lead.Steepness(gradient) > Parameters::Converged; ++n)
  {
    at += NewtonStep(gradient, lead.HessianInVoxels(at));
    if ((at - start).cwiseAbs().maxCoeff() > reach || !IsBetweenNodes(grid, at))
    {
      return false;
    }
    gradient = lead.GradientInVoxels(at);
  }
  x = at.cwiseProduct(grid.spacing);
  return lead.Steepness(gradient) < Parameters::Tolerated;
}
} // namespace mmm
