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
#ifndef mmmCellsToCompare_h
#define mmmCellsToCompare_h

#include "mesh/TetrahedralMesh.h"
#include "mesh/TetrahedronNeighbours.h"
#include "topology/BlockComplex.h"

#include <algorithm>

namespace mmm
{
/** The cells in which there may be something to see. */
class CellsToCompare
{
public:
  /** Lattice and partition have to stay. */
  CellsToCompare(const BlockComplex & blocks, const SampleLattice & lattice, const SampledMaterials & partition)
    : m_Blocks(blocks)
    , m_Lattice(lattice)
    , m_Partition(partition)
    , m_States(blocks.Cells().NumberOfNodes())
  {}

  const BlockComplex &
  Blocks() const
  {
    return m_Blocks;
  }
  bool
  Has(std::size_t cell) const
  {
    return m_States[cell] != Same;
  }
  /** Whether there is one in a row of cells. */
  bool
  HasAny(int first, int last, int j, int k) const
  {
    const auto row = m_States.begin() + std::ptrdiff_t(m_Blocks.Cells().Offset(0, j, k));
    return std::any_of(row + first, row + last + 1, [](char state) { return state != Same; });
  }
  bool
  HasAny(const IndexBox & cells) const
  {
    for (int k = cells.lower[2]; k <= cells.upper[2]; ++k)
    {
      for (int j = cells.lower[1]; j <= cells.upper[1]; ++j)
      {
        if (this->HasAny(cells.lower[0], cells.upper[0], j, k))
        {
          return true;
        }
      }
    }
    return false;
  }

  /** Takes the cells that an interface of a mesh or of the partition meets, and those of another material. Places are
   * in units of blocks. */
  void
  Find(const std::vector<Vector> &   places,
       const TetrahedralMesh &       mesh,
       Material                      exterior,
       const TetrahedronNeighbours & neighbours);
  /** Leaves only those that have changed. */
  void
  KeepOnly(const std::vector<char> & hasChanged);

private:
  enum State : char
  {
    Same,
    Other,
    Met
  };

  /** By the partition alone: what no tetrahedron comes to is exterior. */
  void
  FindMixed(Material exterior);
  bool
  IsMixed(const Index & cell) const;
  /** What it is of if it is of one material. */
  Material
  MaterialOf(const Index & cell) const
  {
    return m_Lattice.At(m_Partition, m_Blocks.FirstSample(cell));
  }
  /** By the tetrahedra in which the middles of cells are. */
  void
  FindOthers(const std::vector<Vector> & places, const TetrahedralMesh & mesh);
  void
  FindMet(const std::vector<Vector> & places, const std::vector<Triangle> & triangles);

  const BlockComplex &     m_Blocks;
  const SampleLattice &    m_Lattice;
  const SampledMaterials & m_Partition;
  std::vector<char>        m_States;
};
} // namespace mmm

#endif
