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
#include "optimize/OptimizerState.h"

#include "optimize/ShapeQuality.h"

#include <algorithm>

namespace mmm
{
double
OptimizerState::TriangleFloor(double quality)
{
  return quality < QualityOfAngle(OptimizationParameters::FlatAngle) ? OptimizationParameters::TriangleFloorBesideFlat
                                                                     : OptimizationParameters::TriangleFloor;
}

double
OptimizerState::EnoughBesideTriangles(double before) const
{
  return std::min(before + OptimizationParameters::LeastGain, QualityOfAngle(parameters.angleToKeepBesideTriangles));
}

void
OptimizerState::Make(const ComplexChange & change)
{
  complex.Replace(change.old, change.fresh);
  switch (change.kind)
  {
    case ComplexChange::Kind::Flip:
      ++report.flips;
      break;
    case ComplexChange::Kind::InterfaceFlip:
      ++report.interfaceFlips;
      break;
    case ComplexChange::Kind::Collapse:
      ++report.collapses;
      break;
  }
}

double
OptimizerState::Shape(Id t) const
{
  const auto & c = complex.Corners(t);
  return ShapeQuality(points[c[0]], points[c[1]], points[c[2]], points[c[3]]);
}

double
OptimizerState::Quality(const Tetrahedron & t, Material material) const
{
  return MaterialQuality(points[t[0]], points[t[1]], points[t[2]], points[t[3]], material == exterior);
}

double
OptimizerState::WorstOf(const std::vector<Id> & tetrahedra) const
{
  double worst = BestQuality;
  for (const Id t : tetrahedra)
  {
    worst = std::min(worst, this->Quality(t));
  }
  return worst;
}
} // namespace mmm
