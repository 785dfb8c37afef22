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
#include "mmmFineSamples.h"

#include "mmmSampleCharacteristics.h"

namespace mmm
{
namespace
{
/** What is thinner than this part of the distance of two samples is not found between them. */
constexpr int Bisections = 10;

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
  const auto & materials = m_Sampled;
  IndexBox::Of(m_Grid.size).Visit([&](const Index & at) {
    const std::size_t here = m_Grid.Offset(at);
    for (int n = 1; n < 8; ++n)
    {
      const Index other{ { at[0] + (n & 1), at[1] + (n >> 1 & 1), at[2] + (n >> 2) } };
      if (!m_Grid.Contains(other) || materials[m_Grid.Offset(other)] == materials[here])
      {
        continue;
      }
      const std::size_t there = m_Grid.Offset(other);
      const Material    between = this->MaterialBetween(
        lattice, this->SamplePosition(at), this->SamplePosition(other), materials[here], materials[there]);
      if (between != materials[here] && between != materials[there])
      {
        m_Separated[materials[here] < materials[there] ? here : there] = between;
      }
    }
  });
}

Material
FineSamples::MaterialBetween(const SampleLattice & lattice, Vector begin, Vector end, Material first, Material last)
  const
{
  for (int bisection = 0; bisection < Bisections; ++bisection)
  {
    const Vector   middle = 0.5 * (begin + end);
    const Material material = lattice.MaterialAt(middle, m_Exterior);
    if (material != first && material != last)
    {
      return material;
    }
    (material == first ? begin : end) = middle;
  }
  return first;
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
