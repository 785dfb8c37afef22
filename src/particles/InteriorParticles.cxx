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
#include "particles/InteriorParticles.h"

#include "base/Hash.h"
#include "base/ParallelCollect.h"
#include "base/PointBins.h"
#include "particles/SpatialOrder.h"

#include <algorithm>
#include <map>

namespace mmm
{
namespace
{
using Parameters = InteriorSeedingParameters;

/** A number between 0 and 1 from the bits of a hash. */
double
Fraction(std::uint64_t hash)
{
  return double(hash >> 11) * 0x1p-53;
}

struct Candidate
{
  Vector        position;
  Material      material;
  float         size;
  std::uint64_t order;
};

/** Random points, as many as the thinning needs to choose from. */
std::vector<Candidate>
CollectCandidates(const IndicatorSet & indicators, const SizingField & sizing, int exterior, std::uint64_t seed)
{
  const Grid & grid = indicators.GetGrid();
  const auto   layer = std::size_t(grid.size[0]) * grid.size[1];
  auto         candidates =
    ParallelCollect<Candidate>(grid.NumberOfNodes(), layer, [&](std::size_t n, std::vector<Candidate> & found) {
      const Material m = indicators.MaterialAtNode(n);
      if (int(m) == exterior)
      {
        return;
      }
      const Vector node = grid.Position(grid.IndexAt(n));
      const double h = sizing(node);
      const double cubes = grid.spacing.prod() / (h * h * h);
      const double expected = std::min(Parameters::CandidatesPerCube * cubes, Parameters::MostCandidates);
      for (int c = 0; c < expected; ++c)
      {
        const std::uint64_t draw = Hash(seed ^ Hash(n) ^ (std::uint64_t(c) << 32));
        if (Fraction(draw) > expected - c)
        {
          continue;
        }
        Vector x;
        for (int a = 0; a < 3; ++a)
        {
          x[a] = node[a] + (Fraction(Hash(draw + a + 1)) - 0.5) * grid.spacing[a];
        }
        if (indicators.MaterialAt(x) == m)
        {
          found.push_back({ x, m, float(sizing(x)), Hash(draw) });
        }
      }
    });
  std::sort(
    candidates.begin(), candidates.end(), [](const Candidate & a, const Candidate & b) { return a.order < b.order; });
  return candidates;
}
} // namespace

void
SeedInteriorParticles(const IndicatorSet & indicators,
                      const SizingField &  sizing,
                      int                  exterior,
                      std::uint64_t        seed,
                      ParticleSet &        particles)
{
  const auto candidates = CollectCandidates(indicators, sizing, exterior, seed);

  PointBins                               binning(indicators.GetGrid());
  std::vector<std::vector<std::uint32_t>> bins(binning.NumberOfBins());
  const std::size_t                       firstInterior = particles.Size();
  for (std::size_t p = 0; p < firstInterior; ++p)
  {
    bins[binning.BinAt(particles.positions[p])].push_back(std::uint32_t(p));
  }
  std::map<Material, std::uint32_t> cellNumbers;
  for (const Candidate & candidate : candidates)
  {
    bool         free = true;
    const double reach = Parameters::ThinningDistance * candidate.size;
    binning.VisitBins(candidate.position, reach, [&](std::size_t bin) {
      for (const auto p : bins[bin])
      {
        const double distance = p < firstInterior ? Parameters::InterfaceDistance * candidate.size : reach;
        free = free && (particles.positions[p] - candidate.position).squaredNorm() >= distance * distance;
      }
    });
    if (free)
    {
      const auto entry = cellNumbers.insert({ candidate.material, std::uint32_t(particles.cellTable.size()) });
      if (entry.second)
      {
        particles.cellTable.push_back(Cell{ candidate.material });
      }
      bins[binning.BinAt(candidate.position)].push_back(std::uint32_t(particles.Size()));
      particles.positions.push_back(candidate.position);
      particles.cells.push_back(entry.first->second);
    }
  }
  SortInSpace(particles, firstInterior);
}
} // namespace mmm
