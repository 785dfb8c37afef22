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
#include "topology/FineSamples.h"

#include "topology/SampleCharacteristics.h"
#include "indicators/SampleNeighbours.h"

#include <algorithm>
#include <vector>

namespace mmm
{
namespace
{
/** In steps of the subdivision. */
Grid
GridOf(const BlockComplex & complex, const IndexBox & blocks, int subdivision)
{
  const Index first = complex.FirstSample(blocks.lower);
  const Index last = complex.LastSample(blocks.upper);
  Grid        grid;
  for (int a = 0; a < 3; ++a)
  {
    grid.size[a] = (last[a] - first[a]) * subdivision + 1;
  }
  return grid;
}
} // namespace

FineSamples::FineSamples(const SampleLattice & lattice,
                         const BlockComplex &  complex,
                         const IndexBox &      blocks,
                         int                   subdivision,
                         Material              exterior)
  : m_Complex(complex)
  , m_Subdivision(subdivision)
  , m_Exterior(exterior)
  , m_First(complex.FirstSample(blocks.lower))
  , m_Grid(GridOf(complex, blocks, subdivision))
{
  m_Sampled.reserve(m_Grid.NumberOfNodes());
  IndexBox::Of(m_Grid.size).Visit([&](const Index & at) {
    m_Sampled.push_back(lattice.MaterialAt(this->SamplePosition(at), exterior));
  });
  m_Separated = m_Sampled;
  this->SeparateByThinSheets(lattice);
}

void
FineSamples::SeparateByThinSheets(const SampleLattice & lattice)
{
  IndexBox::Of(m_Grid.size).Visit([&](const Index & at) {
    const Material own = m_Sampled[m_Grid.Offset(at)];
    // in the order in which they are found
    std::vector<Material> separated;
    std::vector<Material> touching;
    Material              between = own;
    for (int n = 0; n < SampleNeighbours::Count; ++n)
    {
      const Index    neighbour = SampleNeighbours::Of(at, n);
      const Material other = m_Grid.Contains(neighbour) ? m_Sampled[m_Grid.Offset(neighbour)] : own;
      if (other > own)
      {
        const Material found =
          lattice.MaterialBetween(this->SamplePosition(at), this->SamplePosition(neighbour), own, other);
        const bool isSeparated = found != own && found != other;
        (isSeparated ? separated : touching).push_back(other);
        between = isSeparated && between == own ? found : between;
      }
    }
    // where it also touches what is behind the sheet, that has a hole
    const bool hasHole = std::any_of(separated.begin(), separated.end(), [&](Material other) {
      return std::find(touching.begin(), touching.end(), other) != touching.end();
    });
    if (!hasHole)
    {
      m_Separated[m_Grid.Offset(at)] = between;
    }
  });
}

Vector
FineSamples::SamplePosition(const Index & at) const
{
  return Vector(m_First[0], m_First[1], m_First[2]) + Vector(at[0], at[1], at[2]) / double(m_Subdivision);
}

std::size_t
FineSamples::Count(const BlockComplex & complex, const IndexBox & blocks, int subdivision)
{
  return GridOf(complex, blocks, subdivision).NumberOfNodes();
}

EulerChanges
FineSamples::ChangesAt(const Index & cell) const
{
  EulerChanges changes;
  this->AddAt(cell, m_Separated, 1, 1, changes);
  this->AddAt(cell, m_Sampled, m_Subdivision, -1, changes);
  return changes;
}

void
FineSamples::AddAt(const Index &                 cell,
                   const std::vector<Material> & samples,
                   int                           step,
                   int                           sign,
                   EulerChanges &                changes) const
{
  const Index first = m_Complex.FirstSample(cell);
  const Index last = m_Complex.LastSample(cell);
  Index       begin;
  Index       size;
  for (int a = 0; a < 3; ++a)
  {
    begin[a] = (first[a] - m_First[a]) * m_Subdivision;
    size[a] = (last[a] - first[a]) * m_Subdivision / step + 1;
  }
  std::vector<Material> materials;
  IndexBox::Of(size).Visit([&](const Index & at) {
    materials.push_back(
      samples[m_Grid.Offset(begin[0] + at[0] * step, begin[1] + at[1] * step, begin[2] + at[2] * step)]);
  });
  AddCharacteristicsOfSamples(size, materials, [&](Material material, int count) {
    if (material != m_Exterior)
    {
      AddChange(changes, material, sign * count);
    }
  });
}
} // namespace mmm
