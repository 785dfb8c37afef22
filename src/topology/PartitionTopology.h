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
#ifndef mmmPartitionTopology_h
#define mmmPartitionTopology_h

#include "mesh/MeshTopology.h"
#include "indicators/SampleLattice.h"

#include <functional>
#include <vector>

namespace mmm
{
/** \brief The Betti numbers of each material of a partition that is known at the samples of a lattice.
 *
 * A material is the full subcomplex of a Freudenthal subdivision that its samples span, see SampleNeighbours: the same
 * holds for what is not of the material, and none of two has the better of the other where they meet crosswise. */
std::vector<BettiNumbers>
ComputePartitionTopology(const SampleLattice & lattice, const SampledMaterials & partition);

/** The same for samples on a grid, the first index fastest: `row(j, k, labels)` gives the materials of a row. It may be
 * called from several threads, and more than once for a row. */
std::vector<BettiNumbers>
ComputeSampleTopology(const Index &                                                  size,
                      std::size_t                                                    numberOfMaterials,
                      const std::function<void(int, int, std::vector<Material> &)> & row);
} // namespace mmm

#endif
