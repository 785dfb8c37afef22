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
#include "topology/BlockComplex.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
BlockComplex::BlockComplex(const SampleLattice & lattice, int samplesPerBlock)
  : m_Lattice(lattice)
  , m_SamplesPerBlock(samplesPerBlock)
  , m_Origin(lattice.Position(Index{ { 0, 0, 0 } }))
  , m_BlockSize(lattice.Position(Index{ { samplesPerBlock, samplesPerBlock, samplesPerBlock } }) - m_Origin)
{
  for (int a = 0; a < 3; ++a)
  {
    m_Blocks.size[a] = (lattice.GetSize()[a] + samplesPerBlock - 1) / samplesPerBlock;
    m_Cells.size[a] = 2 * m_Blocks.size[a] - 1;
  }
}

Index
BlockComplex::FirstSample(const Index & cell) const
{
  return { { (cell[0] + 1) / 2 * m_SamplesPerBlock,
             (cell[1] + 1) / 2 * m_SamplesPerBlock,
             (cell[2] + 1) / 2 * m_SamplesPerBlock } };
}

Index
BlockComplex::LastSample(const Index & cell) const
{
  Index last;
  for (int a = 0; a < 3; ++a)
  {
    last[a] = std::min((cell[a] / 2 + 1) * m_SamplesPerBlock, m_Lattice.GetSize()[a] - 1);
  }
  return last;
}

void
BlockComplex::CellsOf(int axis, double lower, double upper, int & first, int & last) const
{
  const auto blockAt = [&](double x) { return std::min(std::max(int(std::floor(x)), 0), m_Blocks.size[axis] - 1); };
  first = 2 * blockAt(lower);
  first -= first > 0 && lower == 0.5 * first ? 2 : 0; // on the plane
  last = 2 * blockAt(upper);
}

IndexBox
BlockComplex::CellsOf(const Eigen::AlignedBox3d & box) const
{
  IndexBox cells;
  for (int a = 0; a < 3; ++a)
  {
    this->CellsOf(a, box.min()[a], box.max()[a], cells.lower[a], cells.upper[a]);
  }
  return cells;
}
} // namespace mmm
