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
#include "particles/Particles.h"
#include "base/PointBins.h"
#include "particles/SpatialOrder.h"

#include <algorithm>

namespace mmm
{
namespace
{
/** Thinning at this distance, in units of h, leaves about as many particles as a hexagonal packing of h has. */
constexpr double ThinningDistance = 0.68;
/** A seed's projection stays within this distance of its cube's centre, in units of the largest voxel
 * spacing. */
constexpr double SeedReach = 1.2;
constexpr double MaximalityTolerance = 1e-3;

struct Seed
{
  Vector        position;
  Vector        normal; // of a 2-cell
  Cell          cell;
  std::uint64_t order;
};

class CubeSeeder
{
public:
  CubeSeeder(const IndicatorSet & indicators, int exterior)
    : m_Indicators(indicators)
    , m_Exterior(exterior)
  {}

  /** `lower` is the cube's lowest node; cubes reach one node beyond the border. */
  void
  SeedCube(const Index & lower, std::vector<Seed> & seeds) const
  {
    Material present[Most];
    int      count = 0;
    for (int corner = 0; corner < 8; ++corner)
    {
      const Index node{ { lower[0] + (corner & 1), lower[1] + ((corner >> 1) & 1), lower[2] + (corner >> 2) } };
      this->AddMaterials(node, present, count);
    }
    const Grid & grid = m_Indicators.GetGrid();
    Vector       centre;
    for (int a = 0; a < 3; ++a)
    {
      centre[a] = (lower[a] + 0.5) * grid.spacing[a];
    }
    this->SeedCells(centre, present, count, seeds);
  }

  /** `lower` is the cube's lowest sample; cubes reach one sample beyond the border. */
  void
  SeedCube(const SampleLattice &    lattice,
           const SampledMaterials & partition,
           const Index &            lower,
           std::vector<Seed> &      seeds) const
  {
    Material present[Most];
    int      count = 0;
    Vector   centre = Vector::Zero();
    for (int corner = 0; corner < 8; ++corner)
    {
      const Index sample{ { lower[0] + (corner & 1), lower[1] + ((corner >> 1) & 1), lower[2] + (corner >> 2) } };
      centre += 0.125 * lattice.Position(sample);
      if (!this->AddPlanes([&](int a) { return lattice.SideOf(a, sample[a]); }, present, count))
      {
        Add(lattice.At(partition, sample), present, count);
      }
    }
    this->SeedCells(centre, present, count, seeds);
  }

private:
  static constexpr int Most = 8 + 6; // a material a corner, and the planes

  static void
  Add(Material material, Material * present, int & count)
  {
    if (std::find(present, present + count, material) == present + count)
    {
      present[count++] = material;
    }
  }

  /** Every pair, triple and quadruple of some materials. */
  void
  SeedCells(const Vector & centre, Material * present, int count, std::vector<Seed> & seeds) const
  {
    std::sort(present, present + count);
    for (int a = 0; a < count; ++a)
    {
      for (int b = a + 1; b < count; ++b)
      {
        this->SeedCell(centre, Cell{ present[a], present[b] }, seeds);
        for (int c = b + 1; c < count; ++c)
        {
          this->SeedCell(centre, Cell{ present[a], present[b], present[c] }, seeds);
          for (int d = c + 1; d < count; ++d)
          {
            this->SeedCell(centre, Cell{ present[a], present[b], present[c], present[d] }, seeds);
          }
        }
      }
    }
  }

  /** What lies beyond the border stands for all the planes that it lies behind. `sideOf(axis)` tells on which side of
   * the box it is: below (-1), within, or above (1). Returns whether there is a plane. */
  template <typename TSideOf>
  bool
  AddPlanes(const TSideOf & sideOf, Material * present, int & count) const
  {
    bool isBeyond = false;
    for (int a = 0; a < 3; ++a)
    {
      const int side = sideOf(a);
      if (side != 0)
      {
        Add(Material(m_Indicators.GetNumberOfMaterials() + 2 * a + (side < 0 ? 0 : 1)), present, count);
        isBeyond = true;
      }
    }
    return isBeyond;
  }

  void
  AddMaterials(const Index & node, Material * present, int & count) const
  {
    const Grid & grid = m_Indicators.GetGrid();
    if (!this->AddPlanes([&](int a) { return node[a] < 0 ? -1 : int(node[a] >= grid.size[a]); }, present, count))
    {
      Add(m_Indicators.MaterialAtNode(grid.Offset(node)), present, count);
    }
  }

  void
  SeedCell(Vector x, const Cell & cell, std::vector<Seed> & seeds) const
  {
    const bool meshed = std::any_of(
      cell.begin(), cell.end(), [&](Material m) { return int(m) != m_Exterior && !m_Indicators.IsPlane(m); });
    if (!meshed)
    {
      return;
    }
    const double reach = SeedReach * m_Indicators.GetGrid().spacing.maxCoeff();
    if (m_Indicators.ProjectWhereMaximal(cell, x, reach, MaximalityTolerance))
    {
      seeds.push_back({ x, cell.count == 2 ? m_Indicators.Normal(cell, x) : Vector::Zero(), cell, 0 });
    }
  }

  const IndicatorSet & m_Indicators;
  const int            m_Exterior;
};

/** Seeds from `count` cubes in their order; seedCube(n, seeds) adds those of one. */
template <typename TSeedCube>
std::vector<Seed>
CollectSeeds(std::size_t count, const TSeedCube & seedCube)
{
  constexpr std::size_t Grain = 256;
  return ParallelCollect<Seed>(count, Grain, seedCube);
}

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
  PointBins                               binning(indicators.GetGrid(), 2.0);
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
    const double reach = ThinningDistance * h;
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
  Grid cubes = indicators.GetGrid();
  for (int & size : cubes.size)
  {
    ++size;
  }
  const CubeSeeder seeder(indicators, exterior);
  const auto       seeds = CollectSeeds(cubes.NumberOfNodes(), [&](std::size_t n, std::vector<Seed> & found) {
    const Index at = cubes.IndexAt(n);
    seeder.SeedCube({ { at[0] - 1, at[1] - 1, at[2] - 1 } }, found);
  });
  ParticleSet      particles;
  AddThinned(indicators, sizing, seed, seeds, particles);
  SortInSpace(particles);
  return particles;
}

std::size_t
SeedParticlesAround(const IndicatorSet &             indicators,
                    const SizingField &              sizing,
                    int                              exterior,
                    std::uint64_t                    seed,
                    const std::vector<std::size_t> & nodes,
                    ParticleSet &                    particles)
{
  std::vector<Index> places;
  for (const auto n : nodes)
  {
    places.push_back(indicators.GetGrid().IndexAt(n));
  }
  const auto       cubes = CubesAround(places);
  const CubeSeeder seeder(indicators, exterior);
  const auto       seeds =
    CollectSeeds(cubes.size(), [&](std::size_t n, std::vector<Seed> & found) { seeder.SeedCube(cubes[n], found); });
  return AddThinned(indicators, sizing, seed, seeds, particles);
}

std::size_t
SeedParticlesAround(const SampleLattice &      lattice,
                    const SampledMaterials &   partition,
                    const std::vector<Index> & samples,
                    const SizingField &        sizing,
                    int                        exterior,
                    std::uint64_t              seed,
                    ParticleSet &              particles)
{
  const auto       cubes = CubesAround(samples);
  const CubeSeeder seeder(lattice.GetIndicators(), exterior);
  const auto       seeds = CollectSeeds(cubes.size(), [&](std::size_t n, std::vector<Seed> & found) {
    seeder.SeedCube(lattice, partition, cubes[n], found);
  });
  return AddThinned(lattice.GetIndicators(), sizing, seed, seeds, particles);
}
} // namespace mmm
