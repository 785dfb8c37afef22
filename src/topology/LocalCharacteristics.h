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
#ifndef mmmLocalCharacteristics_h
#define mmmLocalCharacteristics_h

#include "topology/BlockComplex.h"
#include "topology/CharacteristicSums.h"
#include "mesh/TetrahedralMesh.h"
#include "mesh/TetrahedronAdjacency.h"
#include "mesh/TetrahedronChanges.h"

namespace mmm
{
class CellsToCompare;

/** \brief By how much the local characteristics of a mesh exceed those of a partition.
 *
 * Only cells are looked at that an interface of the mesh or of the partition meets, or that are of different materials
 * in the two: in all others there is nothing to see.
 *
 * What a material has of a cell in the mesh is a union of convex sets, the parts of its tetrahedra: only how these meet
 * counts. With each simplex of the material goes a weight, the alternating sum of the simplices of the material that it
 * is a part of; it counts for the cells that the simplex meets. Simplices where the boundary of a material is a
 * surface weigh nothing.
 * In the partition, a material is what its samples span, see ComputePartitionTopology(). */
class CharacteristicsComparison
{
public:
  /** Lattice and partition have to stay. */
  CharacteristicsComparison(const SampleLattice &    lattice,
                            const SampledMaterials & partition,
                            Material                 exterior,
                            int                      samplesPerBlock);

  const BlockComplex &
  Blocks() const
  {
    return m_Blocks;
  }
  /** Those of a mesh. If it is the last one with some points added at the end, only what has changed is looked at. */
  const LocalCharacteristics &
  Compare(const std::vector<Vector> & points, const TetrahedralMesh & mesh, const TetrahedronAdjacency & adjacency);

private:
  /** Those of cells that are worth a look. Positions are in units of blocks. */
  LocalCharacteristics
  CompareWithin(const CellsToCompare &      cells,
                const std::vector<Vector> & places,
                const TetrahedralMesh &     mesh,
                const Incidence &           stars) const;

  const SampleLattice &    m_Lattice;
  const SampledMaterials & m_Partition;
  const Material           m_Exterior;
  const BlockComplex       m_Blocks;
  TetrahedronChanges       m_Changes;
  LocalCharacteristics     m_Differences;
};
} // namespace mmm

#endif
