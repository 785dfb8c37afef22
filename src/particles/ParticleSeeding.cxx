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
#include "particles/CellNumbers.h"
#include "base/Hash.h"
#include "base/MakeUnique.h"
#include "base/ParallelCollect.h"
#include "base/PointBins.h"
#include "particles/Particles.h"
#include "particles/SpatialOrder.h"

#include <algorithm>

namespace mmm
{
namespace
{
using Parameters = SeedingParameters;

struct Seed
{
  Vector        position;
  Vector        normal; // of a 2-cell
  Cell          cell;
  std::uint64_t order;
};

/** Starts particles from cubes. */
class CubeSeeder
{
public:
  CubeSeeder(const SeedCubes & cubes, int exterior)
    : m_Cubes(cubes)
    , m_Indicators(cubes.GetIndicators())
    , m_Exterior(exterior)
    , m_Reach(Parameters::Reach * m_Indicators.GetGrid().spacing.maxCoeff())
  {}

  /** Seeds from `count` cubes in their order; cubeAt(n) is the n-th. */
  template <typename TCubeAt>
  std::vector<Seed>
  Collect(std::size_t count, const TCubeAt & cubeAt) const
  {
    constexpr std::size_t CubesPerRange = 256;
    return ParallelCollect<Seed>(
      count, CubesPerRange, [&](std::size_t n, std::vector<Seed> & seeds) { this->SeedCube(cubeAt(n), seeds); });
  }

private:
  /** Every pair, triple and quadruple of the materials. */
  void
  SeedCube(const Index & cube, std::vector<Seed> & seeds) const
  {
    Material  present[SeedCubes::MostMaterials];
    const int count = m_Cubes.ListMaterials(cube, present);
    if (count < 2)
    {
      return;
    }
    const Vector middle = m_Cubes.Middle(cube);
    for (int a = 0; a < count; ++a)
    {
      for (int b = a + 1; b < count; ++b)
      {
        this->SeedCell(middle, Cell{ present[a], present[b] }, seeds);
        for (int c = b + 1; c < count; ++c)
        {
          this->SeedCell(middle, Cell{ present[a], present[b], present[c] }, seeds);
          for (int d = c + 1; d < count; ++d)
          {
            this->SeedCell(middle, Cell{ present[a], present[b], present[c], present[d] }, seeds);
          }
        }
      }
    }
  }

  void
  SeedCell(Vector x, const Cell & cell, std::vector<Seed> & seeds) const
  {
    const bool isMeshed = std::any_of(
      cell.begin(), cell.end(), [&](Material m) { return int(m) != m_Exterior && !m_Indicators.IsPlane(m); });
    if (isMeshed && m_Indicators.ProjectWhereMaximal(cell, x, m_Reach, Parameters::MaximalityTolerance))
    {
      seeds.push_back({ x, cell.count == 2 ? m_Indicators.Normal(cell, x) : Vector::Zero(), cell, 0 });
    }
  }

  const SeedCubes &    m_Cubes;
  const IndicatorSet & m_Indicators;
  const int            m_Exterior;
  const double         m_Reach;
};

/** The cubes that have one of some places as a corner, each once. */
std::vector<Index>
CubesAround(const std::vector<Index> & places)
{
  std::vector<Index> cubes;
  for (const Index & at : places)
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      cubes.push_back({ { at[0] - (corner & 1), at[1] - ((corner >> 1) & 1), at[2] - (corner >> 2) } });
    }
  }
  MakeUnique(cubes);
  return cubes;
}

/** Adds those seeds that are far enough from all particles before them: those of lower cells first, then at random. */
std::size_t
AddThinned(const IndicatorSet & indicators,
           const SizingField &  sizing,
           std::uint64_t        seed,
           std::vector<Seed>    seeds,
           ParticleSet &        particles)
{
  for (std::size_t s = 0; s < seeds.size(); ++s)
  {
    seeds[s].order = Hash(seed ^ Hash(s));
  }
  std::sort(seeds.begin(), seeds.end(), [](const Seed & a, const Seed & b) {
    return a.cell.count != b.cell.count ? a.cell.count > b.cell.count : a.order < b.order;
  });
  const std::size_t                       before = particles.Size();
  CellNumbers                             numbers(particles.cellTable);
  PointBins                               binning(indicators.GetGrid());
  std::vector<std::vector<std::uint32_t>> bins(binning.NumberOfBins());
  for (std::size_t p = 0; p < before; ++p)
  {
    bins[binning.BinAt(particles.positions[p])].push_back(std::uint32_t(p));
  }
  std::vector<Vector> normals(before, Vector::Zero());
  ParallelFor(before, 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
    {
      if (particles.CellOf(p).count == 2)
      {
        normals[p] = indicators.Normal(particles.CellOf(p), particles.positions[p]);
      }
    }
  });
  for (const Seed & candidate : seeds)
  {
    const double h = sizing(candidate.position);
    const double reach = Parameters::ThinningDistance * h;
    bool         free = true;
    binning.VisitBins(candidate.position, reach, [&](std::size_t bin) {
      for (const auto p : bins[bin])
      {
        if (!free)
        {
          return;
        }
        const Cell & other = particles.CellOf(p);
        if (other.Includes(candidate.cell) &&
            (particles.positions[p] - candidate.position).squaredNorm() < reach * reach)
        {
          // the other side of a thin gap does not count
          free = candidate.cell.count == 2 && other == candidate.cell && normals[p].dot(candidate.normal) <= 0.0;
        }
      }
    });
    if (free)
    {
      bins[binning.BinAt(candidate.position)].push_back(std::uint32_t(particles.Size()));
      particles.positions.push_back(candidate.position);
      particles.cells.push_back(numbers(candidate.cell));
      normals.push_back(candidate.normal);
    }
  }
  return particles.Size() - before;
}
} // namespace

ParticleSet
SeedParticles(const IndicatorSet & indicators, const SizingField & sizing, int exterior, std::uint64_t seed)
{
  // a cube for each node, and one before the first node of an axis
  Grid grid = indicators.GetGrid();
  for (int & size : grid.size)
  {
    ++size;
  }
  const NodeCubes cubes(indicators);
  ParticleSet     particles;
  const auto      seeds = CubeSeeder(cubes, exterior).Collect(grid.NumberOfNodes(), [&](std::size_t n) {
    const Index at = grid.IndexAt(n);
    return Index{ { at[0] - 1, at[1] - 1, at[2] - 1 } };
  });
  AddThinned(indicators, sizing, seed, seeds, particles);
  SortInSpace(particles);
  return particles;
}

std::size_t
SeedParticlesAround(const SeedCubes &          cubes,
                    const std::vector<Index> & places,
                    const SizingField &        sizing,
                    int                        exterior,
                    std::uint64_t              seed,
                    ParticleSet &              particles)
{
  const auto around = CubesAround(places);
  const auto seeds = CubeSeeder(cubes, exterior).Collect(around.size(), [&](std::size_t n) { return around[n]; });
  return AddThinned(cubes.GetIndicators(), sizing, seed, seeds, particles);
}
} // namespace mmm
