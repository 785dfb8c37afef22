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
  m_IsKept.assign(m_Blocks.NumberOfNodes(), 0);
  const int perVoxel = lattice.GetSamplesPerVoxel();
  for (std::size_t place = 0; place < lattice.NumberOfKept(); place += perVoxel)
  {
    IndexBox box{ lattice.SampleAt(place), lattice.SampleAt(place + perVoxel - 1) };
    for (int a = 0; a < 3; ++a)
    {
      box.lower[a] = std::max(0, box.lower[a] - 1) / samplesPerBlock; // a sample on a plane is of both blocks
      box.upper[a] /= samplesPerBlock;
    }
    this->Keep(box);
  }
}

void
BlockComplex::Keep(const IndexBox & blocks)
{
  blocks.Visit([this](const Index & block) { m_IsKept[m_Blocks.Offset(block)] = 1; });
}

void
BlockComplex::KeepAround(const Eigen::AlignedBox3d & box)
{
  IndexBox cells = this->CellsOf(box);
  for (int a = 0; a < 3; ++a)
  {
    cells.lower[a] /= 2;
    cells.upper[a] /= 2;
  }
  this->Keep(cells);
}

BlockComplex
BlockComplex::WithoutKept() const
{
  BlockComplex same = *this;
  std::fill(same.m_IsKept.begin(), same.m_IsKept.end(), 0);
  return same;
}

void
BlockComplex::KeepOnlyOf(const BlockComplex & other)
{
  for (std::size_t n = 0; n < m_IsKept.size(); ++n)
  {
    m_IsKept[n] = m_IsKept[n] && other.m_IsKept[n];
  }
}

bool
BlockComplex::HasKept(const IndexBox & cells) const
{
  for (int k = cells.lower[2] / 2; k <= (cells.upper[2] + 1) / 2; ++k)
  {
    for (int j = cells.lower[1] / 2; j <= (cells.upper[1] + 1) / 2; ++j)
    {
      for (int i = cells.lower[0] / 2; i <= (cells.upper[0] + 1) / 2; ++i)
      {
        if (m_IsKept[m_Blocks.Offset(i, j, k)])
        {
          return true;
        }
      }
    }
  }
  return false;
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
