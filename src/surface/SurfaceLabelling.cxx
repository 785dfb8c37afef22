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
#include "surface/SurfaceLabelling.h"

#include "base/Parallel.h"
#include "surface/TetrahedronSupport.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
constexpr std::size_t Grain = 2048;

/** The centre of the sphere through the corners of a tetrahedron; false if they are in a plane. */
bool
FindCircumcentre(const Vector & a, const Vector & b, const Vector & c, const Vector & d, Vector & centre)
{
  const Vector u = b - a;
  const Vector v = c - a;
  const Vector w = d - a;
  const double volume = u.dot(v.cross(w)); // six times
  const Vector sum = u.squaredNorm() * v.cross(w) + v.squaredNorm() * w.cross(u) + w.squaredNorm() * u.cross(v);
  centre = a + sum / (2.0 * volume);
  return std::abs(volume) > 1e-12 * sum.norm();
}

/** Gives one tetrahedron its material. */
class TetrahedronLabeller
{
public:
  TetrahedronLabeller(const IndicatorSet & indicators, const ParticleSet & particles, const Tetrahedron & corners)
    : m_Indicators(indicators)
    , m_Corners{ &particles.positions[corners[0]],
                 &particles.positions[corners[1]],
                 &particles.positions[corners[2]],
                 &particles.positions[corners[3]] }
  {
    for (const Material m : particles.CellOf(corners[0]))
    {
      if (particles.CellOf(corners[1]).Has(m) && particles.CellOf(corners[2]).Has(m) &&
          particles.CellOf(corners[3]).Has(m))
      {
        m_Common[m_Count++] = m;
      }
    }
  }

  Material
  Label() const
  {
    if (m_Count == 1)
    {
      return m_Common[0];
    }
    const TetrahedronSupport support(m_Indicators, *m_Corners[0], *m_Corners[1], *m_Corners[2], *m_Corners[3]);
    Material                 side = 0;
    if (this->LiesFlat(support) && this->FindSide(support.Centre(), side))
    {
      return side;
    }
    return this->BestSupported(support);
  }

private:
  /** Whether all corners are of one interface, which the tetrahedron nowhere leaves. */
  bool
  LiesFlat(const TetrahedronSupport & support) const
  {
    return m_Count == 2 && !m_Indicators.IsPlane(m_Common[0]) && !m_Indicators.IsPlane(m_Common[1]) &&
           support.IsNear(
             m_Common[0], m_Common[1], LabellingParameters::FlatDistance * std::min(1.0, this->LongestEdge()));
  }

  double
  LongestEdge() const
  {
    double square = 0.0;
    for (int a = 0; a < 4; ++a)
    {
      for (int b = a + 1; b < 4; ++b)
      {
        square = std::max(square, (*m_Corners[a] - *m_Corners[b]).squaredNorm());
      }
    }
    return std::sqrt(square);
  }

  /** On which side of the interface the centre of the sphere through the corners lies. */
  bool
  FindSide(const Vector & x, Material & side) const
  {
    Vector centre;
    if (!FindCircumcentre(*m_Corners[0], *m_Corners[1], *m_Corners[2], *m_Corners[3], centre))
    {
      return false;
    }
    // the normal points from the first material to the second
    const Vector normal = m_Indicators.Normal(Cell{ m_Common[0], m_Common[1] }, x);
    const double height = 0.5 * m_Indicators.Difference(m_Common[1], m_Common[0], x);
    side = m_Common[normal.dot(centre - x) + height > 0.0];
    return true;
  }

  /** Of the materials that all corners have or, if there are none, of those nearby. */
  Material
  BestSupported(const TetrahedronSupport & support) const
  {
    const auto nearby = m_Indicators.Candidates(support.Centre());
    const auto first = m_Count > 0 ? m_Common : nearby.first;
    const auto last = m_Count > 0 ? m_Common + m_Count : nearby.second;
    Material   best = m_Common[0];
    double     largest = -1e300;
    for (auto m = first; m != last; ++m)
    {
      const double value = support.Of(*m);
      if (value > largest)
      {
        largest = value;
        best = *m;
      }
    }
    return best;
  }

  const IndicatorSet & m_Indicators;
  const Vector * const m_Corners[4];
  Material             m_Common[Cell::Capacity] = {};
  int                  m_Count{ 0 };
};
} // namespace

std::vector<Material>
LabelTetrahedra(const IndicatorSet &             indicators,
                const ParticleSet &              particles,
                const std::vector<Tetrahedron> & tetrahedra,
                Material                         exterior)
{
  std::vector<Material> materials(tetrahedra.size());
  ParallelFor(tetrahedra.size(), Grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
    {
      const Material m = TetrahedronLabeller(indicators, particles, tetrahedra[t]).Label();
      materials[t] = indicators.IsPlane(m) ? exterior : m;
    }
  });
  return materials;
}
} // namespace mmm
