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
#include "indicators/PassageWidening.h"

#include "indicators/IndicatorSmoothing.h"
#include "base/MakeUnique.h"
#include "base/ParallelCollect.h"
#include "indicators/PassageBalances.h"
#include "indicators/SampleLattice.h"
#include "indicators/SampleNeighbours.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace mmm
{
namespace
{
using Parameters = PassageParameters;

constexpr int         Refinement = Parameters::Refinement;
constexpr std::size_t PlacesPerRange = 4096;

/** A sample whose material leads by little. */
struct WeakSample
{
  std::size_t place;
  float       lead;
  Material    second;
};

class PassageWidener
{
public:
  PassageWidener(const Grid & grid, bool keepContacts, std::vector<Block<float>> & blocks)
    : m_Grid(grid)
    , m_KeepContacts(keepContacts)
    , m_Blocks(blocks)
    , m_Indicators(MakeIndicatorSet(grid, blocks))
    , m_Lattice(m_Indicators, Refinement)
    , m_Materials(m_Lattice.NumberOfKept())
    , m_IsClosed(m_Materials.size(), 0)
  {}

  void
  Widen()
  {
    std::vector<std::size_t> places(m_Materials.size());
    std::iota(places.begin(), places.end(), 0);
    const int passes = m_KeepContacts ? Parameters::ContactPasses : Parameters::Passes;
    for (int pass = 0; pass < passes && !places.empty(); ++pass)
    {
      if (pass > 0)
      {
        m_Indicators = MakeIndicatorSet(m_Grid, m_Blocks);
      }
      const auto weak = this->Collect<WeakSample>(
        places, [this](std::size_t place, std::vector<WeakSample> & found) { this->ReadSample(place, found); });
      auto raises = this->Collect<Raise>(places, [this](std::size_t place, std::vector<Raise> & found) {
        m_IsClosed[place] = this->AddContacts(m_Lattice.SampleAt(place), m_Materials[place], found);
      });
      for (const WeakSample & sample : weak)
      {
        this->AddRaises(sample, raises);
      }
      if (m_KeepContacts)
      {
        TipBalances(m_Indicators, this->WeakPlaces(weak), raises);
      }
      ApplyRaises(m_Indicators, raises, m_Blocks);
      places = this->PlacesAround(raises);
    }
  }

private:
  /** The materials of a sample's neighbours. */
  using Surroundings = std::array<Material, SampleNeighbours::Count>;

  /** What visit(place, found) finds at some places, in their order. */
  template <typename T, typename TVisitor>
  static std::vector<T>
  Collect(const std::vector<std::size_t> & places, const TVisitor & visit)
  {
    return ParallelCollect<T>(
      places.size(), PlacesPerRange, [&](std::size_t n, std::vector<T> & found) { visit(places[n], found); });
  }

  void
  ReadSample(std::size_t place, std::vector<WeakSample> & weak)
  {
    const Index sample = m_Lattice.SampleAt(place);
    if (m_Lattice.IsDecidedByNodes(sample))
    {
      m_Materials[place] = m_Indicators.MaterialAtNode(m_Lattice.VoxelOf(sample));
      return;
    }
    const Vector x = m_Lattice.Position(sample);
    Material     best[2] = { 0, 0 };
    double       values[2] = { -1e300, -1e300 };
    const auto   range = m_Indicators.Candidates(x);
    for (auto m = range.first; m != range.second; ++m)
    {
      const double value = m_Indicators.Value(*m, x);
      if (value > values[0])
      {
        best[1] = best[0];
        values[1] = values[0];
        best[0] = *m;
        values[0] = value;
      }
      else if (value > values[1])
      {
        best[1] = *m;
        values[1] = value;
      }
    }
    m_Materials[place] = best[0];
    const auto lead = float(values[0] - values[1]);
    if (lead < Parameters::Lead)
    {
      weak.push_back({ place, lead, best[1] });
    }
  }

  IndexBox
  NodesAround(const Index & sample, const Index & other) const
  {
    IndexBox box;
    for (int a = 0; a < 3; ++a)
    {
      box.lower[a] = sample[a] / Refinement;
      box.upper[a] = std::min((other[a] + Refinement - 1) / Refinement, m_Grid.size[a] - 1);
    }
    return box;
  }

  /** What a weak sample needs if it holds something together, or apart. */
  void
  AddRaises(const WeakSample & weak, std::vector<Raise> & raises) const
  {
    const Index    sample = m_Lattice.SampleAt(weak.place);
    const Material own = m_Materials[weak.place];
    if (m_IsClosed[weak.place])
    {
      return;
    }
    const Surroundings around = this->Around(sample);
    if (m_Neighbours.IsDisk(SetOf(around, own)) && m_Neighbours.IsDisk(SetOf(around, weak.second)))
    {
      return;
    }
    const IndexBox box = this->NodesAround(sample, sample);
    double         amount = Parameters::Lead - weak.lead;
    for (int a = 0; a < 3; ++a)
    {
      amount /= box.upper[a] > box.lower[a] ? Parameters::Halfway : 1.0;
    }
    box.Visit([&](const Index & node) { raises.push_back({ m_Grid.Offset(node), own, float(amount) }); });
  }

  /** Where samples lead by little that are not to be closed. */
  std::vector<WeakPlace>
  WeakPlaces(const std::vector<WeakSample> & weak) const
  {
    std::vector<WeakPlace> places;
    for (const WeakSample & sample : weak)
    {
      if (!m_IsClosed[sample.place])
      {
        const Vector x = m_Lattice.Position(m_Lattice.SampleAt(sample.place));
        places.push_back({ x, m_Materials[sample.place], sample.second });
      }
    }
    return places;
  }

  /** What is to change where a sample touches others of another material, and a third one that holds something together
   * around it could come between them. Returns whether that one shall. */
  bool
  AddContacts(const Index & sample, Material own, std::vector<Raise> & raises) const
  {
    const Surroundings around = this->Around(sample);
    const auto         other = std::find_if(around.begin(), around.end(), [&](Material m) { return m != own; });
    if (std::all_of(other, around.end(), [&](Material m) { return m == own || m == *other; }))
    {
      return false;
    }
    bool isClosed = false;
    for (auto third = around.begin(); third != around.end(); ++third)
    {
      if (*third == own || std::find(around.begin(), third, *third) != third ||
          m_Neighbours.IsDisk(SetOf(around, *third)))
      {
        continue;
      }
      for (int n = 0; n < SampleNeighbours::Count; ++n)
      {
        if (around[n] != own && around[n] != *third)
        {
          isClosed |= this->AddContact(sample, n, Cell{ own, around[n] }, *third, raises);
        }
      }
    }
    return isClosed;
  }

  /** The same for a sample and its n-th neighbour, which are of a pair of materials. */
  bool
  AddContact(const Index & sample, int n, const Cell & pair, Material third, std::vector<Raise> & raises) const
  {
    const Index other = SampleNeighbours::Of(sample, n);
    if (!m_Lattice.Contains(other))
    {
      return false;
    }
    const Vector x = 0.5 * (m_Lattice.Position(sample) + m_Lattice.Position(other));
    const auto lead = float(std::max(m_Indicators.Value(*pair.begin(), x), m_Indicators.Value(*(pair.begin() + 1), x)) -
                            m_Indicators.Value(third, x));
    if (lead >= Parameters::Lead)
    {
      return false;
    }
    // the first neighbours are those of larger indices
    const bool     isUpper = n < SampleNeighbours::Count / 2;
    const IndexBox box = isUpper ? this->NodesAround(sample, other) : this->NodesAround(other, sample);
    const bool     isKept = m_KeepContacts && this->ShareFace(box, pair);
    const float    amount = isKept ? lead - Parameters::Lead : lead + Parameters::Lead;
    box.Visit([&](const Index & node) { raises.push_back({ m_Grid.Offset(node), third, amount }); });
    return !isKept;
  }

  /** Whether voxels of two materials share a face, of some voxels. */
  bool
  ShareFace(const IndexBox & box, const Cell & pair) const
  {
    bool isShared = false;
    box.Visit([&](const Index & node) {
      const Material here = m_Indicators.MaterialAtNode(m_Grid.Offset(node));
      for (int axis = 0; axis < 3; ++axis)
      {
        Index next = node;
        if (++next[axis] <= box.upper[axis])
        {
          const Material there = m_Indicators.MaterialAtNode(m_Grid.Offset(next));
          isShared = isShared || (here != there && pair.Has(here) && pair.Has(there));
        }
      }
    });
    return isShared;
  }

  /** Beyond the border a sample is as the one on it. */
  Material
  AtNearest(Index sample) const
  {
    for (int a = 0; a < 3; ++a)
    {
      sample[a] = std::min(std::max(sample[a], 0), m_Lattice.GetSize()[a] - 1);
    }
    return m_Lattice.At(m_Materials, sample);
  }

  Surroundings
  Around(const Index & sample) const
  {
    Surroundings around;
    for (int n = 0; n < SampleNeighbours::Count; ++n)
    {
      around[n] = this->AtNearest(SampleNeighbours::Of(sample, n));
    }
    return around;
  }

  static unsigned
  SetOf(const Surroundings & around, Material material)
  {
    unsigned set = 0;
    for (int n = 0; n < SampleNeighbours::Count; ++n)
    {
      set |= unsigned(around[n] == material) << n;
    }
    return set;
  }

  /** The places that interpolation takes changes to, ascending. */
  std::vector<std::size_t>
  PlacesAround(const std::vector<Raise> & raises) const
  {
    std::vector<std::size_t> places;
    for (const Raise & raise : raises)
    {
      const Index    node = m_Grid.IndexAt(raise.node);
      const IndexBox box{ m_Grid.Clamp({ { node[0] - 2, node[1] - 2, node[2] - 2 } }),
                          m_Grid.Clamp({ { node[0] + 2, node[1] + 2, node[2] + 2 } }) };
      box.Visit([&](const Index & at) {
        const auto first = m_Lattice.PlaceOf({ { Refinement * at[0], Refinement * at[1], Refinement * at[2] } });
        if (first != SampleLattice::NotKept)
        {
          places.push_back(first);
        }
      });
    }
    MakeUnique(places);
    constexpr std::size_t    PerVoxel = Refinement * Refinement * Refinement;
    std::vector<std::size_t> all;
    all.reserve(PerVoxel * places.size());
    for (const auto first : places)
    {
      for (std::size_t n = 0; n < PerVoxel; ++n)
      {
        all.push_back(first + n);
      }
    }
    return all;
  }

  const Grid &                m_Grid;
  const bool                  m_KeepContacts;
  std::vector<Block<float>> & m_Blocks;
  IndicatorSet                m_Indicators;
  const SampleLattice         m_Lattice;
  const SampleNeighbours      m_Neighbours;
  std::vector<Material>       m_Materials;
  /** The samples that another material shall close. */
  std::vector<char> m_IsClosed;
};
} // namespace

void
WidenPassages(const Grid & grid, bool keepContacts, std::vector<Block<float>> & indicators)
{
  PassageWidener(grid, keepContacts, indicators).Widen();
}
} // namespace mmm
