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
#include "topology/TopologyDifferences.h"

#include "base/DisjointSets.h"
#include "topology/FineSamples.h"
#include "base/IndexBox.h"
#include "topology/LocalCharacteristics.h"
#include "base/MakeUnique.h"
#include "base/Parallel.h"
#include "indicators/SampleNeighbours.h"

#include <algorithm>
#include <iterator>

namespace mmm
{
namespace
{
/** By how much more finely places are looked at, besides for thin sheets between samples, and at how many samples at
 * most: of a place, and, if more, in all. */
constexpr int         Subdivisions[] = { 1, 2, 4 };
constexpr std::size_t MostSamplesOfPlace = 120000;
constexpr std::size_t MostSamples = 1000000;

using Cells = std::vector<std::size_t>;

/** With this sign the characteristics of cells add up. */
int
SignOf(const Index & cell)
{
  return BlockComplex::DimensionOf(cell) % 2 ? 1 : -1;
}

/** Whether one of two neighbouring cells is a part of the other. */
bool
IsIncident(const Index & a, const Index & b)
{
  bool isPart = true;
  bool hasPart = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    isPart = isPart && (a[axis] == b[axis] || a[axis] % 2 == 1);
    hasPart = hasPart && (a[axis] == b[axis] || b[axis] % 2 == 1);
  }
  return isPart || hasPart;
}

/** Sorts the differences of cells into places. */
class PlaceFinder
{
public:
  PlaceFinder(const SampleLattice &        lattice,
              const SampledMaterials &     partition,
              Material                     exterior,
              const BlockComplex &         blocks,
              const LocalCharacteristics & left)
    : m_Lattice(lattice)
    , m_Partition(partition)
    , m_Exterior(exterior)
    , m_Blocks(blocks)
    , m_Left(left)
  {}

  TopologyDifferences
  Find() const
  {
    Cells cells;
    for (const auto & entry : m_Left)
    {
      cells.push_back(entry.cell);
    }
    MakeUnique(cells);
    std::vector<Cells> incident = this->PartsOf(cells, IsIncident);
    this->TakeCancelling(incident);
    const Cells        differing = Joined(incident);
    std::vector<Cells> parts = this->PartsOf(differing, [](const Index &, const Index &) { return true; });
    const auto         cancelling = this->TakeCancelling(parts);
    const std::size_t  most = std::max(MostSamplesOfPlace, MostSamples / std::max<std::size_t>(parts.size(), 1));
    std::vector<char>  isBetweenSamples(parts.size(), 0);
    ParallelFor(parts.size(), 1, [&](std::size_t n, std::size_t) {
      isBetweenSamples[n] = char(this->VanishesBetweenSamples(parts[n], differing, most));
    });
    TopologyDifferences result;
    for (const Cells & part : cancelling)
    {
      result.cancelling.push_back(this->Describe(part));
    }
    for (std::size_t n = 0; n < parts.size(); ++n)
    {
      if (isBetweenSamples[n])
      {
        for (const auto & entry : this->ChangesOf(parts[n]))
        {
          AddChange(result.betweenSamples, entry.material, entry.change);
        }
      }
      else
      {
        result.places.push_back(this->Describe(parts[n]));
      }
    }
    return result;
  }

private:
  /** Sorts cells into parts of which neighbours, if they are joined, are in the same one. */
  template <typename TIsJoined>
  std::vector<Cells>
  PartsOf(const Cells & cells, const TIsJoined & isJoined) const
  {
    DisjointSets sets(cells.size());
    for (std::size_t n = 0; n < cells.size(); ++n)
    {
      const Index here = m_Blocks.Cells().IndexAt(cells[n]);
      IndexBox{ here, here }.Grown(1, m_Blocks.Cells().size).Visit([&](const Index & there) {
        const auto number = m_Blocks.Cells().Offset(there);
        const auto found = std::lower_bound(cells.begin(), cells.begin() + n, number);
        if (found != cells.begin() + n && *found == number && isJoined(here, there))
        {
          sets.Unite(std::uint32_t(n), std::uint32_t(found - cells.begin()));
        }
      });
    }
    std::vector<Cells>       parts;
    std::vector<std::size_t> numbers(cells.size());
    for (std::uint32_t n = 0; n < cells.size(); ++n)
    {
      const auto first = sets.Find(n);
      if (first == n)
      {
        numbers[n] = parts.size();
        parts.emplace_back();
      }
      parts[numbers[first]].push_back(cells[n]);
    }
    return parts;
  }

  /** Leaves the parts that add up to a difference, and returns the others. */
  std::vector<Cells>
  TakeCancelling(std::vector<Cells> & parts) const
  {
    const auto first = std::stable_partition(
      parts.begin(), parts.end(), [this](const Cells & part) { return !IsZero(this->ChangesOf(part)); });
    std::vector<Cells> cancelling(std::make_move_iterator(first), std::make_move_iterator(parts.end()));
    parts.erase(first, parts.end());
    return cancelling;
  }

  static Cells
  Joined(const std::vector<Cells> & parts)
  {
    Cells cells;
    for (const Cells & part : parts)
    {
      cells.insert(cells.end(), part.begin(), part.end());
    }
    std::sort(cells.begin(), cells.end());
    return cells;
  }

  /** Calls visit(material, value) for the differences of a cell. */
  template <typename TVisitor>
  void
  VisitLeft(std::size_t cell, const TVisitor & visit) const
  {
    auto entry = std::lower_bound(
      m_Left.begin(), m_Left.end(), cell, [](const LocalCharacteristic & e, std::size_t c) { return e.cell < c; });
    for (; entry != m_Left.end() && entry->cell == cell; ++entry)
    {
      visit(entry->material, entry->value);
    }
  }

  EulerChanges
  ChangesOf(const Cells & part) const
  {
    EulerChanges changes;
    for (const auto cell : part)
    {
      const int sign = SignOf(m_Blocks.Cells().IndexAt(cell));
      this->VisitLeft(cell,
                      [&](Material material, std::ptrdiff_t value) { AddChange(changes, material, sign * value); });
    }
    return changes;
  }

  /** Whether more samples, but no more than `most`, make the difference of a part go away, with all that is left of
   * differing cells within the box around it. */
  bool
  VanishesBetweenSamples(const Cells & part, const Cells & differing, std::size_t most) const
  {
    IndexBox box{ m_Blocks.Cells().IndexAt(part[0]), m_Blocks.Cells().IndexAt(part[0]) };
    for (const auto cell : part)
    {
      const Index at = m_Blocks.Cells().IndexAt(cell);
      for (int a = 0; a < 3; ++a)
      {
        box.lower[a] = std::min(box.lower[a], at[a] / 2 * 2);
        box.upper[a] = std::max(box.upper[a], (at[a] + 1) / 2 * 2);
      }
    }
    for (const int margin : { 0, 2 })
    {
      const IndexBox wide = box.Grown(margin, m_Blocks.Cells().size);
      Cells          within;
      wide.Visit([&](const Index & cell) {
        const auto number = m_Blocks.Cells().Offset(cell);
        if (std::binary_search(differing.begin(), differing.end(), number))
        {
          within.push_back(number);
        }
      });
      const auto seen = this->LookCloser(wide, this->ChangesOf(within), most);
      if (seen != CloserLook::IsCut)
      {
        return seen == CloserLook::Vanishes;
      }
    }
    return false;
  }

  /** What becomes of a difference with more samples: it may be cut by the border of what is looked at. */
  enum class CloserLook
  {
    Vanishes,
    Stays,
    IsCut
  };

  CloserLook
  LookCloser(const IndexBox & blocks, const EulerChanges & changes, std::size_t most) const
  {
    bool isCut = false;
    for (const int subdivision : Subdivisions)
    {
      if (FineSamples::Count(m_Blocks, blocks, subdivision) > most)
      {
        break;
      }
      const FineSamples samples(m_Lattice, m_Blocks, blocks, subdivision, m_Exterior);
      if (!this->IsSameAround(blocks, samples))
      {
        isCut = true;
        continue;
      }
      const auto found = ChangesWithin(blocks, samples);
      if (IsZero(Difference(found, changes)))
      {
        return CloserLook::Vanishes;
      }
      if (subdivision > 1 && IsZero(found))
      {
        break; // more samples would hardly see more
      }
    }
    return isCut ? CloserLook::IsCut : CloserLook::Stays;
  }

  /** Whether more samples within blocks leave what is around the blocks as it is. */
  bool
  IsSameAround(const IndexBox & blocks, const FineSamples & samples) const
  {
    bool isSame = true;
    blocks.Grown(1, m_Blocks.Cells().size).Visit([&](const Index & cell) {
      isSame = isSame && (blocks.Contains(cell) || IsZero(samples.ChangesAt(cell)));
    });
    return isSame;
  }

  /** By how much more samples change what is within blocks. */
  static EulerChanges
  ChangesWithin(const IndexBox & blocks, const FineSamples & samples)
  {
    EulerChanges changes;
    blocks.Visit([&](const Index & cell) {
      for (const auto & entry : samples.ChangesAt(cell))
      {
        AddChange(changes, entry.material, SignOf(cell) * entry.change);
      }
    });
    return changes;
  }

  TopologyDifference
  Describe(const Cells & part) const
  {
    TopologyDifference difference;
    const auto         changes = this->ChangesOf(part);
    const bool         isCancelling = IsZero(changes);
    std::copy_if(changes.begin(),
                 changes.end(),
                 std::back_inserter(difference.changes),
                 [&](const EulerChange & entry) { return isCancelling || entry.change != 0; });
    difference.position = Vector::Zero();
    for (const auto number : part)
    {
      const Index cell = m_Blocks.Cells().IndexAt(number);
      difference.position +=
        0.5 * (m_Lattice.Position(m_Blocks.FirstSample(cell)) + m_Lattice.Position(m_Blocks.LastSample(cell)));
      this->AddMixedSamples(cell, difference.samples);
    }
    difference.position /= double(part.size());
    MakeUnique(difference.samples);
    return difference;
  }

  /** Adds the samples of a cell that touch one of another material. */
  void
  AddMixedSamples(const Index & cell, std::vector<Index> & samples) const
  {
    IndexBox{ m_Blocks.FirstSample(cell), m_Blocks.LastSample(cell) }.Visit([&](const Index & sample) {
      const Material own = m_Lattice.At(m_Partition, sample);
      bool           isMixed = false;
      for (int n = 0; n < SampleNeighbours::Count && !isMixed; ++n)
      {
        const Index other = SampleNeighbours::Of(sample, n);
        isMixed = !m_Lattice.Contains(other) || m_Lattice.At(m_Partition, other) != own;
      }
      if (isMixed)
      {
        samples.push_back(sample);
      }
    });
  }

  const SampleLattice &        m_Lattice;
  const SampledMaterials &     m_Partition;
  const Material               m_Exterior;
  const BlockComplex &         m_Blocks;
  const LocalCharacteristics & m_Left;
};
} // namespace

TopologyDifferenceFinder::TopologyDifferenceFinder(const SampleLattice &    lattice,
                                                   const SampledMaterials & partition,
                                                   Material                 exterior)
  : m_Lattice(lattice)
  , m_Partition(partition)
  , m_Exterior(exterior)
  , m_Comparison(new CharacteristicsComparison(lattice, partition, exterior, lattice.GetRefinement()))
{}

TopologyDifferenceFinder::~TopologyDifferenceFinder() = default;

TopologyDifferences
TopologyDifferenceFinder::Find(const std::vector<Vector> &  points,
                               const TetrahedralMesh &      mesh,
                               const TetrahedronAdjacency & adjacency)
{
  const auto & left = m_Comparison->Compare(points, mesh, adjacency);
  return PlaceFinder(m_Lattice, m_Partition, m_Exterior, m_Comparison->Blocks(), left).Find();
}
} // namespace mmm
