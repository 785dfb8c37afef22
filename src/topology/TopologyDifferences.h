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

#include "indicators/SampleLattice.h"
#include "mesh/TetrahedralMesh.h"
#include "mesh/TetrahedronAdjacency.h"
#include "topology/EulerChanges.h"

#include <memory>

namespace mmm
{
/** \brief A place where the topology of a mesh is not that of a partition. */
struct TopologyDifference
{
  Vector position;
  /** The samples at the place that touch one of another material, ascending. */
  std::vector<Index> samples;
  /** What the mesh has more, by material. A component or a cavity more is 1, a tunnel more -1. */
  EulerChanges changes;
};

struct TopologyDifferences
{
  std::vector<TopologyDifference> places;
  /** Where differences side by side cancel out: that may be a component and a tunnel more, or nothing. The changes of
   * all materials there are 0. */
  std::vector<TopologyDifference> cancelling;
  /** What the partition has more where it is sampled finely enough to see that the mesh is right, by material. */
  EulerChanges betweenSamples;
};

class CharacteristicsComparison;

/** \brief Finds where meshes differ from a partition in topology.
 *
 * Space is cut into blocks of samples, a voxel each. The Euler characteristics of what a material has of the blocks and
 * of their common faces, edges and corners, with alternating signs, add up to that of the material. Nearly all of them
 * are the same in the mesh and in the partition. Those that are not are sorted into parts that touch: where only the
 * interface is a little off, the differences of a part add up to nothing. The others are the places where the topology
 * is another one, and they add up to the whole difference of the characteristics. Parts that cancel out are told of if
 * they consist of smaller ones that do not, of cells each of which bounds the next; where even these cancel out, a
 * component and a tunnel next to each other are not seen.
 *
 * A sheet that is thinner than the distance of the samples has holes in the partition that the indicators do not have.
 * So these places are looked at more closely, see FineSamples, and do not count where that makes the difference go
 * away. */
class TopologyDifferenceFinder
{
public:
  /** Lattice and partition have to stay. */
  TopologyDifferenceFinder(const SampleLattice & lattice, const SampledMaterials & partition, Material exterior);
  ~TopologyDifferenceFinder();

  TopologyDifferenceFinder(const TopologyDifferenceFinder &) = delete;
  TopologyDifferenceFinder &
  operator=(const TopologyDifferenceFinder &) = delete;

  /** If the points are those of the last call and some more behind them, it looks only at what has changed. */
  TopologyDifferences
  Find(const std::vector<Vector> & points, const TetrahedralMesh & mesh, const TetrahedronAdjacency & adjacency);

private:
  const SampleLattice &                      m_Lattice;
  const SampledMaterials &                   m_Partition;
  const Material                             m_Exterior;
  std::unique_ptr<CharacteristicsComparison> m_Comparison;
};
} // namespace mmm

#endif
