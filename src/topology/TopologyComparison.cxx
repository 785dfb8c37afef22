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
#include "topology/TopologyComparison.h"

#include "base/Points.h"
#include "topology/PartitionTopology.h"

namespace mmm
{
namespace
{
std::ptrdiff_t
CharacteristicOf(const BettiNumbers & betti)
{
  return betti[0] - betti[1] + betti[2];
}

TopologyPlace
Describe(const TopologyDifference & difference)
{
  TopologyPlace entry;
  entry.place.position = ToPoint(difference.position);
  for (const auto & change : difference.changes)
  {
    entry.place.labels.push_back(int(change.material));
    entry.changes.push_back(change.change);
  }
  return entry;
}
} // namespace

TopologyComparison::TopologyComparison(const IndicatorSet & indicators, Material exterior, int samplesPerVoxel)
  : m_Lattice(indicators, samplesPerVoxel)
  , m_Partition(m_Lattice.SamplePartition(exterior))
  , m_Exterior(exterior)
  , m_Finder(m_Lattice, m_Partition, exterior)
{}

TopologyReport
TopologyComparison::Compare(const std::vector<Vector> &  points,
                            const TetrahedralMesh &      mesh,
                            const TetrahedronAdjacency & adjacency)
{
  auto                        partition = ComputePartitionTopology(m_Lattice, m_Partition);
  TopologyReport              report;
  std::vector<std::ptrdiff_t> explained(partition.size(), 0);
  std::vector<char>           hasPlace(partition.size(), 0);
  const auto                  differences = this->FindDifferences(points, mesh, adjacency);
  for (const auto & place : differences.cancelling)
  {
    report.cancelling.push_back(Describe(place).place);
    for (const auto & change : place.changes)
    {
      hasPlace[change.material] = 1;
    }
  }
  for (const auto & place : differences.places)
  {
    report.differences.push_back(Describe(place));
    for (const auto & change : place.changes)
    {
      explained[change.material] += change.change;
      hasPlace[change.material] = 1;
    }
  }
  const auto topology = ComputeMeshTopology(points, mesh, partition.size());
  for (const auto & change : differences.betweenSamples)
  {
    // without a place, all differences went away, of components and cavities, too
    BettiNumbers &       betti = partition[change.material];
    const BettiNumbers & ofMesh = topology.regions[change.material].betti;
    if (!hasPlace[change.material] && CharacteristicOf(betti) + change.change == CharacteristicOf(ofMesh))
    {
      betti = ofMesh;
    }
    else
    {
      betti[1] -= change.change;
    }
  }
  for (std::size_t m = 0; m < partition.size(); ++m)
  {
    if (m != m_Exterior)
    {
      const BettiNumbers & betti = topology.regions[m].betti;
      report.labels.push_back(
        { int(m), betti, partition[m], CharacteristicOf(betti) - CharacteristicOf(partition[m]) - explained[m] });
    }
  }
  return report;
}
} // namespace mmm
