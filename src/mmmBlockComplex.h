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
#ifndef mmmBlockComplex_h
#define mmmBlockComplex_h

#include "mmmSampleLattice.h"

#include <cstddef>
#include <vector>

namespace mmm
{
/** \brief Space cut into blocks of samples by planes: the blocks and their common faces, edges and corners.
 *
 * A cell has an index of its own along each axis: 2 i is block i, 2 i + 1 the plane between it and the next one. The
 * cells are closed, the planes lie on samples, and the outermost blocks have no end. */
class BlockComplex
{
public:
  /** Keeps the blocks with samples that are kept. */
  BlockComplex(const SampleLattice & lattice, int samplesPerBlock);

  /** Along an axis. */
  int
  NumberOfBlocks(int axis) const
  {
    return m_Blocks[axis];
  }
  int
  GetSamplesPerBlock() const
  {
    return m_SamplesPerBlock;
  }

  std::size_t
  NumberOfCells() const
  {
    return std::size_t(m_Size[0]) * m_Size[1] * m_Size[2];
  }
  bool
  Contains(const Index & cell) const
  {
    return cell[0] >= 0 && cell[1] >= 0 && cell[2] >= 0 && cell[0] < m_Size[0] && cell[1] < m_Size[1] &&
           cell[2] < m_Size[2];
  }
  std::size_t
  NumberOf(const Index & cell) const
  {
    return (std::size_t(cell[2]) * m_Size[1] + cell[1]) * m_Size[0] + cell[0];
  }
  Index
  CellAt(std::size_t number) const
  {
    const auto x = std::size_t(m_Size[0]);
    const auto y = std::size_t(m_Size[1]);
    return { { int(number % x), int(number / x % y), int(number / (x * y)) } };
  }
  static int
  DimensionOf(const Index & cell)
  {
    return 3 - (cell[0] & 1) - (cell[1] & 1) - (cell[2] & 1);
  }
  /** Keeps the blocks, too, that a box from `lower` to `upper`, in units of blocks, meets. */
  void
  Keep(const Vector & lower, const Vector & upper);
  /** Whether one of the blocks at a cell is kept. */
  bool
  IsKept(const Index & cell) const
  {
    return this->HasKept(cell, cell);
  }
  /** Whether that is so for a cell from `lower` up to `upper`. */
  bool
  HasKept(const Index & lower, const Index & upper) const;

  /** The samples of a cell. */
  Index
  FirstSample(const Index & cell) const;
  Index
  LastSample(const Index & cell) const;

  /** A point in units of blocks. */
  Vector
  ToBlocks(const Vector & x) const
  {
    return (x - m_Origin).cwiseQuotient(m_BlockSize);
  }
  /** The cells along an axis that an interval, in units of blocks, meets, and maybe one more before the first. */
  void
  CellsOf(int axis, double lower, double upper, int & first, int & last) const;

private:
  /** Keeps from one block to another. */
  void
  KeepBlocks(const Index & lower, const Index & upper);

  const SampleLattice & m_Lattice;
  const int             m_SamplesPerBlock;
  Index                 m_Blocks;
  Index                 m_Size;
  Vector                m_Origin;
  Vector                m_BlockSize;
  /** Per block. */
  std::vector<char> m_IsKept;
};
} // namespace mmm

#endif
