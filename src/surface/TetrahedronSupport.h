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
#ifndef mmmTetrahedronSupport_h
#define mmmTetrahedronSupport_h

#include "indicators/IndicatorSet.h"
#include "surface/SurfaceParameters.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace mmm
{
/** \brief How much the indicators are for a tetrahedron's being of a material. */
class TetrahedronSupport
{
public:
  TetrahedronSupport(const IndicatorSet & indicators,
                     const Vector &       a,
                     const Vector &       b,
                     const Vector &       c,
                     const Vector &       d)
    : m_Indicators(indicators)
  {
    m_Samples[0] = 0.25 * (a + b + c + d);
    const Vector * const corners[4] = { &a, &b, &c, &d };
    for (int i = 0; i < 4; ++i)
    {
      m_Samples[i + 1] = 0.5 * (m_Samples[0] + *corners[i]);
    }
  }

  const Vector &
  Centre() const
  {
    return m_Samples[0];
  }

  /** The mean of an indicator over the centre and four points halfway to the corners. */
  double
  Of(Material m) const
  {
    constexpr double Ceiling = LabellingParameters::LargestSupport;
    double           sum = 0.0;
    for (const Vector & x : m_Samples)
    {
      sum += std::min(Ceiling, std::max(-Ceiling, m_Indicators.Value(m, x)));
    }
    return sum / 5.0;
  }

  /** Whether the samples are all within a distance of the interface of two materials. */
  bool
  IsNear(Material a, Material b, double distance) const
  {
    return std::all_of(std::begin(m_Samples), std::end(m_Samples), [&](const Vector & x) {
      return 0.5 * std::abs(m_Indicators.Difference(a, b, x)) < distance;
    });
  }

private:
  const IndicatorSet & m_Indicators;
  Vector               m_Samples[5];
};
} // namespace mmm

#endif
