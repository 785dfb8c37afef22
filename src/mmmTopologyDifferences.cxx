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
#include "mmmTopologyDifferences.h"

#include "mmmSampleNeighbours.h"

#include <algorithm>

namespace mmm
{
namespace
{
class PartitionComparer
{
public:
  PartitionComparer(const SampleLattice & lattice, const SampledMaterials & wanted, SampledMaterials & actual)
    : m_Lattice(lattice)
    , m_Wanted(wanted)
    , m_Actual(actual)
  {}

  std::vector<TopologyDifference>
  Compare()
  {
    for (std::size_t place = 0; place < m_Wanted.size(); ++place)
    {
      if (m_Wanted[place] != m_Actual[place])
      {
        m_Left.push_back(place);
      }
    }
    std::size_t before = 0;
    do
    {
      before = m_Left.size();
      m_Left.erase(
        std::remove_if(m_Left.begin(), m_Left.end(), [this](std::size_t place) { return this->Turn(place); }),
        m_Left.end());
    } while (m_Left.size() < before);
    return this->SortIntoParts();
  }

private:
  /** The neighbours that are of a material at present. */
  unsigned
  NeighboursOf(const Index & sample, Material material) const
  {
    unsigned set = 0;
    for (int n = 0; n < SampleNeighbours::Count; ++n)
    {
      const Index other = SampleNeighbours::Of(sample, n);
      set |= unsigned(m_Lattice.Contains(other) && m_Lattice.At(m_Actual, other) == material) << n;
    }
    return set;
  }

  /** Gives a sample the material that is wanted, unless that changes the topology. */
  bool
  Turn(std::size_t place)
  {
    const Index sample = m_Lattice.SampleAt(place);
    if (!m_Neighbours.IsDisk(this->NeighboursOf(sample, m_Actual[place])) ||
        !m_Neighbours.IsDisk(this->NeighboursOf(sample, m_Wanted[place])))
    {
      return false;
    }
    m_Actual[place] = m_Wanted[place];
    return true;
  }

  std::vector<TopologyDifference>
  SortIntoParts()
  {
    std::vector<TopologyDifference> differences;
    std::vector<char>               isTaken(m_Left.size(), 0);
    for (std::size_t first = 0; first < m_Left.size(); ++first)
    {
      if (isTaken[first])
      {
        continue;
      }
      isTaken[first] = 1;
      TopologyDifference difference{ { m_Left[first] }, {} };
      auto &             samples = difference.samples;
      for (std::size_t s = 0; s < samples.size(); ++s)
      {
        const Index sample = m_Lattice.SampleAt(samples[s]);
        for (int n = 0; n < SampleNeighbours::Count; ++n)
        {
          const Index other = SampleNeighbours::Of(sample, n);
          const auto  place = m_Lattice.Contains(other) ? m_Lattice.PlaceOf(other) : SampleLattice::NotKept;
          const auto  found = std::lower_bound(m_Left.begin(), m_Left.end(), place);
          if (found != m_Left.end() && *found == place && !isTaken[found - m_Left.begin()])
          {
            isTaken[found - m_Left.begin()] = 1;
            samples.push_back(place);
          }
        }
      }
      std::sort(samples.begin(), samples.end());
      this->AddChanges(difference);
      differences.push_back(std::move(difference));
    }
    return differences;
  }

  /** Turns the samples all the same, and counts what that does. */
  void
  AddChanges(TopologyDifference & difference)
  {
    auto &     changes = difference.changes;
    const auto add = [&](Material material, std::ptrdiff_t change) {
      const auto isBelow = [](const EulerChange & entry, Material m) { return entry.material < m; };
      auto       at = std::lower_bound(changes.begin(), changes.end(), material, isBelow);
      if (at == changes.end() || at->material != material)
      {
        at = changes.insert(at, { material, 0 });
      }
      at->change += change;
    };
    for (const auto place : difference.samples)
    {
      // with the sample come a vertex and the simplices between it and the part that the neighbours span
      const Index sample = m_Lattice.SampleAt(place);
      add(m_Actual[place], 1 - m_Neighbours.CharacteristicOf(this->NeighboursOf(sample, m_Actual[place])));
      add(m_Wanted[place], m_Neighbours.CharacteristicOf(this->NeighboursOf(sample, m_Wanted[place])) - 1);
      m_Actual[place] = m_Wanted[place];
    }
  }

  const SampleLattice &    m_Lattice;
  const SampledMaterials & m_Wanted;
  SampledMaterials &       m_Actual;
  const SampleNeighbours   m_Neighbours;
  /** Where they differ still, ascending. */
  std::vector<std::size_t> m_Left;
};
} // namespace

std::vector<TopologyDifference>
FindTopologyDifferences(const SampleLattice & lattice, const SampledMaterials & wanted, SampledMaterials actual)
{
  return PartitionComparer(lattice, wanted, actual).Compare();
}
} // namespace mmm
