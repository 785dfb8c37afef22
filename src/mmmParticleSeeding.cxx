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
#include "mmmCellNumbers.h"
#include "mmmHash.h"
#include "mmmParallel.h"
#include "mmmParticles.h"
#include "mmmPointBins.h"

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
    constexpr int Most = 8 + 6; // a material a corner, and the planes
    Material      present[Most];
    int           count = 0;
    for (int corner = 0; corner < 8; ++corner)
    {
      const Index node{ { lower[0] + (corner & 1), lower[1] + ((corner >> 1) & 1), lower[2] + (corner >> 2) } };
      this->AddMaterials(node, present, count);
    }
    if (count < 2)
    {
      return;
    }
    std::sort(present, present + std::min(count, Most));
    for (int a = 0; a < count; ++a)
    {
      for (int b = a + 1; b < count; ++b)
      {
        this->SeedCell(lower, Cell{ present[a], present[b] }, seeds);
        for (int c = b + 1; c < count; ++c)
        {
          this->SeedCell(lower, Cell{ present[a], present[b], present[c] }, seeds);
          for (int d = c + 1; d < count; ++d)
          {
            this->SeedCell(lower, Cell{ present[a], present[b], present[c], present[d] }, seeds);
          }
        }
      }
    }
  }

private:
  /** A node beyond the border stands for all the planes that it lies behind. */
  void
  AddMaterials(const Index & node, Material * present, int & count) const
  {
    const Grid & grid = m_Indicators.GetGrid();
    const auto   add = [&](Material m) {
      if (std::find(present, present + count, m) == present + count)
      {
        present[count++] = m;
      }
    };
    bool within = true;
    for (int a = 0; a < 3; ++a)
    {
      if (node[a] < 0 || node[a] >= grid.size[a])
      {
        add(Material(m_Indicators.GetNumberOfMaterials() + 2 * a + (node[a] < 0 ? 0 : 1)));
        within = false;
      }
    }
    if (within)
    {
      add(m_Indicators.MaterialAtNode(grid.Offset(node)));
    }
  }

  void
  SeedCell(const Index & lower, const Cell & cell, std::vector<Seed> & seeds) const
  {
    const bool meshed = std::any_of(
      cell.begin(), cell.end(), [&](Material m) { return int(m) != m_Exterior && !m_Indicators.IsPlane(m); });
    if (!meshed)
    {
      return;
    }
    const Grid & grid = m_Indicators.GetGrid();
    Vector       x;
    for (int a = 0; a < 3; ++a)
    {
      x[a] = (lower[a] + 0.5) * grid.spacing[a];
    }
    const double reach = SeedReach * grid.spacing.maxCoeff();
    if (m_Indicators.ProjectWhereMaximal(cell, x, reach, MaximalityTolerance))
    {
      seeds.push_back({ x, cell.count == 2 ? m_Indicators.Normal(cell, x) : Vector::Zero(), cell, 0 });
    }
  }

  const IndicatorSet & m_Indicators;
  const int            m_Exterior;
};

/** Seeds from `count` cubes in their order; cubeAt(n) is the lowest node of one. */
template <typename TCubeAt>
std::vector<Seed>
CollectSeeds(const IndicatorSet & indicators, int exterior, std::size_t count, const TCubeAt & cubeAt)
{
  constexpr std::size_t          Grain = 256;
  const CubeSeeder               seeder(indicators, exterior);
  std::vector<std::vector<Seed>> parts((count + Grain - 1) / Grain);
  ParallelFor(count, Grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c)
    {
      seeder.SeedCube(cubeAt(c), parts[begin / Grain]);
    }
  });
  std::vector<Seed> seeds;
  for (auto & part : parts)
  {
    seeds.insert(seeds.end(), part.begin(), part.end());
    std::vector<Seed>().swap(part);
  }
  return seeds;
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
  const auto cubeAt = [&cubes](std::size_t n) {
    const Index at = cubes.IndexAt(n);
    return Index{ { at[0] - 1, at[1] - 1, at[2] - 1 } };
  };
  ParticleSet particles;
  AddThinned(indicators, sizing, seed, CollectSeeds(indicators, exterior, cubes.NumberOfNodes(), cubeAt), particles);
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
  std::vector<Index> cubes;
  for (const auto n : nodes)
  {
    const Index at = indicators.GetGrid().IndexAt(n);
    for (int corner = 0; corner < 8; ++corner)
    {
      cubes.push_back(Index{ { at[0] - (corner & 1), at[1] - ((corner >> 1) & 1), at[2] - (corner >> 2) } });
    }
  }
  std::sort(cubes.begin(), cubes.end());
  cubes.erase(std::unique(cubes.begin(), cubes.end()), cubes.end());
  const auto cubeAt = [&cubes](std::size_t n) { return cubes[n]; };
  return AddThinned(indicators, sizing, seed, CollectSeeds(indicators, exterior, cubes.size(), cubeAt), particles);
}
} // namespace mmm
