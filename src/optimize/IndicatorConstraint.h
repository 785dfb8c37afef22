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
#ifndef mmmIndicatorConstraint_h
#define mmmIndicatorConstraint_h

#include "indicators/IndicatorSet.h"
#include "optimize/InterfaceConstraint.h"
#include "particles/Particles.h"

namespace mmm
{
/** \brief Points stay on the cells of indicator functions, those of 0-cells where they were at first. Distances are in
 * units of the smallest voxel spacing. */
class IndicatorConstraint : public InterfaceConstraint
{
public:
  IndicatorConstraint(const IndicatorSet & indicators, Material exterior, const ParticleSet & particles);

  Material
  MaterialOf(Material m) const override;
  bool
  Project(PointId p, Vector & x) const override;
  bool
  MayLeaveCell(PointId p) const override;
  Vector
  AlongCell(PointId p, const Vector & x, const Vector & direction) const override;
  double
  DistanceToInterface(Material a, Material b, const Vector & x, PointId corner) const override;

private:
  const IndicatorSet &      m_Indicators;
  const Material            m_Exterior;
  const std::vector<Vector> m_Places;
};
} // namespace mmm

#endif
