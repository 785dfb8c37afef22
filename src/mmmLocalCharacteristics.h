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

#include "mmmBlockComplex.h"
#include "mmmCharacteristicSums.h"
#include "mmmTetrahedralMesh.h"

namespace mmm
{
/** \brief By how much the local characteristics of a mesh exceed those of a partition.
 *
 * Those of kept blocks, that is: besides those with samples that are kept, blocks will be with an interface of the
 * mesh, or of different materials in mesh and partition. In all others there is nothing to see.
 *
 * What a material has of a cell in the mesh is a union of convex sets, the parts of its tetrahedra: only how these meet
 * counts. With each simplex of the material goes a weight, the alternating sum of the simplices of the material that it
 * is a part of; it counts for the cells that the simplex meets. Simplices where the boundary of a material is a
 * surface weigh nothing.
 * In the partition, a material is what its samples span, see ComputePartitionTopology(). */
LocalCharacteristics
CompareCharacteristics(BlockComplex &              blocks,
                       const SampleLattice &       lattice,
                       const SampledMaterials &    partition,
                       const std::vector<Vector> & points,
                       const TetrahedralMesh &     mesh,
                       Material                    exterior);
} // namespace mmm

#endif
