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
#include "mmmVolumeBalance.h"

#include "mmmPointSmoother.h"
#include "mmmParallel.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
constexpr int Passes = 2;
/** Nothing moves further than this in one pass, in units of the smallest voxel spacing. */
constexpr double LongestMove = 0.3;
/** A tetrahedron may get worse by this, but not beyond the angle, in degrees. */
constexpr double AngleToKeep = 20.0;
/** Likewise a triangle, but not beyond this radius ratio. */
constexpr double TriangleToKeep = 0.75;
} // namespace

/** How far the zero set is from the triangles around p on average, along the normal of p's cell. */
double
PointSmoother::MeanGap(const IndicatorSet & indicators, PointId p) const
{
  const Cell & cell = m_Cells[p];
  const auto   gapAt = [&](const Vector & x) {
    return 0.5 * (indicators.Value(cell.materials[0], x) - indicators.Value(cell.materials[1], x));
  };
  double sum = 0.0;
  double areas = 0.0;
  for (auto f = m_FanStart[p]; f < m_FanStart[p + 1]; ++f)
  {
    const Vector & a = m_Points[p];
    const Vector & b = m_Points[m_Fan[f][0]];
    const Vector & c = m_Points[m_Fan[f][1]];
    const double   area = (b - a).cross(c - a).norm();
    // the middles of the edges give the mean of a quadratic function
    sum += area * (gapAt(0.5 * (a + b)) + gapAt(0.5 * (a + c)) + gapAt(0.5 * (b + c))) / 3.0;
    areas += area;
  }
  return areas > 0.0 ? sum / areas : 0.0;
}

std::size_t
PointSmoother::BalanceVolumes(const IndicatorSet & indicators)
{
  const auto isOnSurface = [&](PointId p) {
    return m_Freedom[p] == Freedom::OnCell && m_Cells[p].count == 2 && !indicators.IsPlane(m_Cells[p].materials[1]);
  };
  std::size_t         moves = 0;
  std::vector<double> gaps(m_Points.size());
  for (int pass = 0; pass < Passes; ++pass)
  {
    // all gaps first: what the neighbours do about theirs is not to count twice
    ParallelFor(m_Points.size(), 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p)
      {
        gaps[p] = isOnSurface(PointId(p)) ? this->MeanGap(indicators, PointId(p)) : 0.0;
      }
    });
    moves += this->MoveByColour([&](PointId p) {
      if (gaps[p] == 0.0)
      {
        return false;
      }
      const double gap = std::min(std::max(gaps[p], -LongestMove), LongestMove);
      const Vector x = m_Points[p] + gap * indicators.Normal(m_Cells[p], m_Points[p]);
      const double angle = std::min(m_Parameters.angleToKeep, AngleToKeep);
      const double triangle = std::min(this->WorstTriangleAround(p, m_Points[p]), TriangleToKeep);
      return this->MoveIfGood(p, x, angle, triangle);
    });
  }
  return moves;
}

void
BalanceVolumes(const IndicatorSet &           indicators,
               const InterfaceConstraint &    constraint,
               Material                       exterior,
               const OptimizationParameters & parameters,
               const TetrahedralComplex &     complex,
               std::vector<Vector> &          points)
{
  PointSmoother(constraint, exterior, parameters, points, complex).BalanceVolumes(indicators);
}
} // namespace mmm
