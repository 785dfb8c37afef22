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

#include "mmmIndicatorSet.h"
#include "mmmMeshTopology.h"

#include <functional>
#include <vector>

namespace mmm
{
/** \brief The Betti numbers of each material of the argmax partition of the indicators, which a mesh should have, too.
 *
 * The partition is sampled at the grid's nodes and halfway between them. A sample stands for a closed box around it:
 * samples of a material that touch in a corner are connected, as tetrahedra are that share a point. */
MultiMaterialMeshing_EXPORT std::vector<BettiNumbers>
                            ComputePartitionTopology(const IndicatorSet & indicators);

/** The same for labels on a grid of boxes, the first index fastest: `row(j, k, labels)` gives those of a row. It may be
 * called from several threads, and more than once for a row. */
MultiMaterialMeshing_EXPORT std::vector<BettiNumbers>
                            ComputeBoxTopology(const Index &                                                  size,
                                               std::size_t                                                    numberOfMaterials,
                                               const std::function<void(int, int, std::vector<Material> &)> & row);
} // namespace mmm

#endif
