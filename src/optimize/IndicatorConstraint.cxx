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
#include "optimize/IndicatorConstraint.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
/** Points of a plane are on it but for rounding, in units of the smallest voxel spacing. */
constexpr double OnPlane = 1e-9;

std::vector<Cell>
CellsOf(const ParticleSet & particles)
{
  std::vector<Cell> cells(particles.Size());
  for (std::size_t p = 0; p < cells.size(); ++p)
  {
    cells[p] = particles.CellOf(p);
  }
  return cells;
}
} // namespace

IndicatorConstraint::IndicatorConstraint(const IndicatorSet & indicators,
                                         Material             exterior,
                                         const ParticleSet &  particles)
  : InterfaceConstraint(CellsOf(particles))
  , m_Indicators(indicators)
  , m_Exterior(exterior)
  , m_Places(particles.positions)
{}

Material
IndicatorConstraint::MaterialOf(Material m) const
{
  return m_Indicators.IsPlane(m) ? m_Exterior : m;
}

bool
IndicatorConstraint::Project(PointId p, Vector & x) const
{
  if (m_Cells[p].Dimension() == 0)
  {
    x = m_Places[p];
    return true;
  }
  return m_Indicators.ProjectWhereMaximal(m_Cells[p], x, 1.0);
}

bool
IndicatorConstraint::MayLeaveCell(PointId p) const
{
  const Cell & cell = m_Cells[p];
  return std::none_of(cell.begin(), cell.end(), [this](Material m) { return m_Indicators.IsPlane(m); });
}

Vector
IndicatorConstraint::AlongCell(PointId p, const Vector & x, const Vector & direction) const
{
  const Cell & cell = m_Cells[p];
  if (cell.Dimension() == 2)
  {
    const Vector normal = m_Indicators.Normal(cell, x);
    return direction - normal * normal.dot(direction);
  }
  if (cell.Dimension() == 1)
  {
    const Vector tangent = m_Indicators.Tangent(cell, x);
    return tangent * tangent.dot(direction);
  }
  return Vector::Zero();
}

double
IndicatorConstraint::DistanceToInterface(Material a, Material b, const Vector & x, PointId corner) const
{
  // where the exterior begins at a plane, the plane is the interface
  if (a == m_Exterior || b == m_Exterior)
  {
    if (corner < m_Cells.size())
    {
      for (const Material m : m_Cells[corner])
      {
        if (m_Indicators.IsPlane(m) && std::abs(m_Indicators.Planes().Value(m, x)) < OnPlane)
        {
          return 0.0;
        }
      }
    }
    if (std::size_t(m_Exterior) >= m_Indicators.GetNumberOfMaterials())
    {
      return NoInterface;
    }
  }
  return 0.5 * std::abs(m_Indicators.Difference(a, b, x));
}
} // namespace mmm
