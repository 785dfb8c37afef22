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
#include "surface/SampleFinder.h"

#include "surface/SurfaceParameters.h"

#include <cmath>

namespace mmm
{
namespace
{
using Parameters = MissingSampleParameters;

/** The corners whose bits are set. */
TetrahedronPart
PartOf(const TetrahedronPart & whole, int mask)
{
  TetrahedronPart part;
  for (int c = 0; c < whole.count; ++c)
  {
    if (mask >> c & 1)
    {
      part.corners[part.count++] = whole.corners[c];
    }
  }
  return part;
}
} // namespace

SampleFinder::SampleFinder(const IndicatorSet & indicators, const ParticleSet & particles)
  : m_Indicators(indicators)
  , m_Particles(particles)
{}

void
SampleFinder::ListParts(const Tetrahedron & tetrahedron, std::vector<TetrahedronPart> & parts) const
{
  TetrahedronPart whole{ tetrahedron, 4 };
  std::sort(whole.corners.begin(), whole.corners.end());
  if (this->HaveCommonMaterial(whole))
  {
    return;
  }
  const std::size_t before = parts.size();
  for (int count = 2; parts.size() == before; ++count)
  {
    for (int mask = 0; mask < 16; ++mask)
    {
      const TetrahedronPart part = PartOf(whole, mask);
      if (part.count == count && !this->HaveCommonMaterial(part))
      {
        parts.push_back(part);
      }
    }
  }
}

bool
SampleFinder::HaveCommonMaterial(const TetrahedronPart & part) const
{
  const Cell & first = m_Particles.CellOf(part.corners[0]);
  return std::any_of(first.begin(), first.end(), [&](Material m) {
    return !m_Indicators.IsPlane(m) &&
           std::all_of(part.begin(), part.end(), [&](PointId p) { return m_Particles.CellOf(p).Has(m); });
  });
}

bool
SampleFinder::FindSample(const TetrahedronPart & part, MissingSample & sample) const
{
  return part.count == 2 ? this->FindOnLine(m_Particles.positions[part.corners[0]],
                                            m_Particles.positions[part.corners[1]],
                                            this->CommonPlanes(part),
                                            sample)
                         : this->FindJunction(part, sample) || this->FindBetween(part, sample);
}

Vector
SampleFinder::CentreOf(const TetrahedronPart & part) const
{
  Vector sum = Vector::Zero();
  for (const PointId p : part)
  {
    sum += m_Particles.positions[p];
  }
  return sum / part.count;
}

Cell
SampleFinder::CommonPlanes(const TetrahedronPart & part) const
{
  Cell planes;
  for (int n = 0; n < 6; ++n)
  {
    const auto plane = Material(m_Indicators.GetNumberOfMaterials() + n);
    if (std::all_of(part.begin(), part.end(), [&](PointId p) { return m_Particles.CellOf(p).Has(plane); }))
    {
      planes.Join(Cell{ plane });
    }
  }
  return planes;
}

bool
SampleFinder::FindOnLine(const Vector & from, const Vector & to, const Cell & planes, MissingSample & sample) const
{
  const Vector way = to - from;
  const int    steps = std::max(2, int(std::ceil(way.norm() / Parameters::LongestStep)));
  const auto   at = [&](int n) -> Vector { return from + double(n) / steps * way; };
  double       nearest = steps;
  Material     own = m_Indicators.MaterialAt(from);
  for (int n = 1; n <= steps; ++n)
  {
    const Material other = m_Indicators.MaterialAt(at(n));
    const double   distance = std::abs(n - 0.5 * (steps + 1));
    MissingSample  crossing;
    if (other != own && distance < nearest && this->FindCrossing(at(n - 1), at(n), own, planes, crossing))
    {
      nearest = distance;
      sample = crossing;
    }
    own = other;
  }
  return nearest < steps;
}

bool
SampleFinder::FindCrossing(Vector inside, Vector outside, Material own, const Cell & planes, MissingSample & sample)
  const
{
  Material other = m_Indicators.MaterialAt(outside);
  for (int n = 0; n < Parameters::Halvings; ++n)
  {
    const Vector   middle = 0.5 * (inside + outside);
    const Material m = m_Indicators.MaterialAt(middle);
    (m == own ? inside : outside) = middle;
    other = m == own ? other : m;
  }
  sample.position = 0.5 * (inside + outside);
  sample.cell = Cell{ own, other };
  return sample.cell.Join(planes) && m_Indicators.ProjectWhereMaximal(sample.cell, sample.position, Parameters::Reach);
}

bool
SampleFinder::FindJunction(const TetrahedronPart & part, MissingSample & sample) const
{
  const Vector centre = this->CentreOf(part);
  double       reach = 0.0;
  Cell         cell = this->CommonPlanes(part);
  for (int left = 0; left < part.count; ++left)
  {
    const TetrahedronPart side = PartOf(part, ((1 << part.count) - 1) ^ (1 << left));
    const Cell &          first = m_Particles.CellOf(side.corners[0]);
    const auto            common = std::find_if(first.begin(), first.end(), [&](Material m) {
      return !m_Indicators.IsPlane(m) && !cell.Has(m) &&
             std::all_of(side.begin(), side.end(), [&](PointId p) { return m_Particles.CellOf(p).Has(m); });
    });
    if (common == first.end() || !cell.Join(Cell{ *common }))
    {
      return false;
    }
    reach = std::max(reach, (m_Particles.positions[part.corners[left]] - centre).norm());
  }
  sample = { centre, cell };
  return m_Indicators.ProjectWhereMaximal(cell, sample.position, reach);
}

bool
SampleFinder::FindBetween(const TetrahedronPart & part, MissingSample & sample) const
{
  const Vector   centre = this->CentreOf(part);
  const Material own = m_Indicators.MaterialAt(centre);
  const Cell     planes = this->CommonPlanes(part);
  return std::any_of(part.begin(), part.end(), [&](PointId p) {
    return !m_Particles.CellOf(p).Has(own) && this->FindOnLine(centre, m_Particles.positions[p], planes, sample);
  });
}
} // namespace mmm
