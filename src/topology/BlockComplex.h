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

#include "base/IndexBox.h"
#include "indicators/SampleLattice.h"

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
  /** The lattice has to stay. */
  BlockComplex(const SampleLattice & lattice, int samplesPerBlock);

  /** Numbers of the blocks, and of all cells. */
  const Grid &
  Blocks() const
  {
    return m_Blocks;
  }
  const Grid &
  Cells() const
  {
    return m_Cells;
  }
  static int
  DimensionOf(const Index & cell)
  {
    return 3 - (cell[0] & 1) - (cell[1] & 1) - (cell[2] & 1);
  }

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
  /** The same for a box. */
  IndexBox
  CellsOf(const Eigen::AlignedBox3d & box) const;

private:
  const SampleLattice & m_Lattice;
  const int             m_SamplesPerBlock;
  Grid                  m_Blocks;
  Grid                  m_Cells;
  Vector                m_Origin;
  Vector                m_BlockSize;
};
} // namespace mmm

#endif
