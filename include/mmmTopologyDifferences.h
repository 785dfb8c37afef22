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
#ifndef mmmTopologyDifferences_h
#define mmmTopologyDifferences_h

#include "mmmSampleLattice.h"

namespace mmm
{
/** By how much the Euler characteristic of what is of a material differs. */
struct EulerChange
{
  Material       material;
  std::ptrdiff_t change;
};

/** \brief A place where one partition differs from another in topology. */
struct TopologyDifference
{
  /** The samples that cannot be reconciled, as places in SampledMaterials, ascending. */
  std::vector<std::size_t> samples;
  /** The materials that these samples have in either partition, ascending, and what the actual partition has more than
   * the wanted one. A component or a cavity more is 1, a tunnel more -1. */
  std::vector<EulerChange> changes;
};

/** \brief Where partitions differ in topology.
 *
 * `actual` is turned into `wanted` sample by sample, as long as that leaves the components, tunnels and cavities of
 * each material as they are, see SampleNeighbours. The samples that cannot be turned in this way are where the
 * partitions differ. They are sorted into parts that touch, which do not depend on each other: the changes of all parts
 * add up to the difference of the Euler characteristics. */
MultiMaterialMeshing_EXPORT std::vector<TopologyDifference>
FindTopologyDifferences(const SampleLattice & lattice, const SampledMaterials & wanted, SampledMaterials actual);
} // namespace mmm

#endif
