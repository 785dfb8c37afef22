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
/** In steps of the subdivision, both ends included. */
Index
SizeOf(const BlockComplex & complex, const IndexBox & blocks, int subdivision)
{
  const Index first = complex.FirstSample(blocks.lower);
  const Index last = complex.LastSample(blocks.upper);
  Index       size;
  for (int a = 0; a < 3; ++a)
  {
    size[a] = (last[a] - first[a]) * subdivision + 1;
  }
  return size;
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
  , m_Size(SizeOf(complex, blocks, subdivision))
{
  const Vector first(m_First[0], m_First[1], m_First[2]);
  const Index  last{ { m_Size[0] - 1, m_Size[1] - 1, m_Size[2] - 1 } };
  m_Materials.reserve(Count(complex, blocks, subdivision));
  IndexBox{ { { 0, 0, 0 } }, last }.Visit([&](const Index & at) {
    m_Materials.push_back(lattice.MaterialAt(first + Vector(at[0], at[1], at[2]) / double(subdivision), exterior));
  });
}

std::size_t
FineSamples::Count(const BlockComplex & complex, const IndexBox & blocks, int subdivision)
{
  const Index size = SizeOf(complex, blocks, subdivision);
  return std::size_t(size[0]) * size[1] * size[2];
}

EulerChanges
FineSamples::ChangesAt(const Index & cell) const
{
  EulerChanges changes;
  this->AddAt(cell, 1, 1, changes);
  this->AddAt(cell, m_Subdivision, -1, changes);
  return changes;
}

void
FineSamples::AddAt(const Index & cell, int step, int sign, EulerChanges & changes) const
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
  IndexBox{ { { 0, 0, 0 } }, { { size[0] - 1, size[1] - 1, size[2] - 1 } } }.Visit([&](const Index & at) {
    const auto row = std::size_t(begin[2] + at[2] * step) * m_Size[1] + begin[1] + at[1] * step;
    materials.push_back(m_Materials[row * m_Size[0] + begin[0] + at[0] * step]);
  });
  AddCharacteristicsOfSamples(size, materials, [&](Material material, int count) {
    if (material != m_Exterior)
    {
      AddChange(changes, material, sign * count);
    }
  });
}
} // namespace mmm
