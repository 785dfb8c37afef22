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
#include "surface/SurfaceStage.h"

#include "surface/CellUpdate.h"
#include "delaunay/Enclosure.h"
#include "surface/FlatTetrahedra.h"
#include "base/IndexBox.h"
#include "surface/LinkRepair.h"
#include "surface/LostNodes.h"
#include "surface/Sampling.h"
#include "base/MakeUnique.h"
#include "base/Parallel.h"
#include "base/Points.h"
#include "particles/ParticleMerging.h"
#include "particles/SpatialOrder.h"
#include "surface/SurfaceLabelling.h"
#include "surface/SurfaceRelaxation.h"
#include "topology/TopologyComparison.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace mmm
{
namespace
{
/** Triangulations of the surface that are followed by sweeps of its particles. The last of them is compared with the
 * partition of the indicators: where its topology is another one, particles are added. */
constexpr int SurfaceRounds = 5;
constexpr int SurfaceSweeps = 2;
/** Where it need not be kept, places with more samples than this stay as they are: the sizes do not resolve them. */
constexpr std::size_t LargestPlace = 80;
constexpr std::size_t AnyNumber = std::size_t(-1);
/** Triangulations after the sweeps that add such particles where the topology is to be kept, at most. */
constexpr int MendingRounds = 6;
/** After this number of them, particles are also added further around, by one sample more each time. */
constexpr int MendingRoundsInPlace = 2;
/** Not around more samples than this. */
constexpr std::size_t MostSamplesToGrow = 2000;
/** There are no more of these rounds where the places that differ have more than this share of the samples that are
 * kept: that is noise, which particles do not follow. */
constexpr double ShareOfNoise = 0.05;
/** In each of these rounds the distance is smaller by this factor: an eighth of a voxel in the last one. */
constexpr double MendingShrinkage = 0.75;
/** After each round, parts that it missed are sampled more finely: at this distance, in units of the smallest voxel
 * spacing, which grows around them at this rate and has met the usual sizes at this distance. */
constexpr double RecoverySize = 0.5;
constexpr double RecoveryGrowth = 0.5;
constexpr double RecoveryReach = 6.0;
/** Corners of small labels are not worth it where sizes are this large, which is by someone's wish. */
constexpr float CoarseSize = 1.75f;

/** Makes sizes small at some places, and so around them that they grow with distance no faster than usual. */
void
RefineSizes(const Grid & grid, const std::vector<Vector> & places, double smallest, std::vector<float> & sizes)
{
  constexpr std::size_t LayersPerRange = 4;
  ParallelFor(grid.size[2], LayersPerRange, [&](std::size_t begin, std::size_t end) {
    for (const Vector & place : places)
    {
      IndexBox box;
      for (int a = 0; a < 3; ++a)
      {
        const int centre = int(std::floor(place[a] / grid.spacing[a] + 0.5));
        const int reach = int(RecoveryReach / grid.spacing[a]);
        box.lower[a] = std::max(centre - reach, a == 2 ? int(begin) : 0);
        box.upper[a] = std::min(centre + reach, (a == 2 ? int(end) : grid.size[a]) - 1);
      }
      box.Visit([&](const Index & at) {
        const double distance = (grid.Position(at) - place).norm();
        float &      size = sizes[grid.Offset(at)];
        size = std::min(size, float(smallest + RecoveryGrowth * distance));
      });
    }
  });
}

/** The same for grid nodes, at the usual distance. */
void
RefineSizes(const Grid & grid, const std::vector<std::size_t> & nodes, std::vector<float> & sizes)
{
  std::vector<Vector> places;
  for (const auto n : nodes)
  {
    places.push_back(grid.Position(grid.IndexAt(n)));
  }
  RefineSizes(grid, places, RecoverySize, sizes);
}

/** The nodes to sample more finely because the tetrahedra missed them. */
std::vector<std::size_t>
FindNodesToSample(const IndicatorSet &       indicators,
                  const std::vector<float> & sizes,
                  const ParticleSet &        particles,
                  const TetrahedralMesh &    labelled,
                  Material                   exterior)
{
  const auto lost = FindLostNodes(indicators, particles.positions, labelled, exterior);
  auto       nodes = lost.parts;
  std::copy_if(lost.corners.begin(), lost.corners.end(), std::back_inserter(nodes), [&](std::size_t n) {
    return sizes[n] < CoarseSize;
  });
  return nodes;
}

/** Drops the particles that no triangle uses and renumbers the triangles. Returns how many were dropped. */
std::size_t
DropUnusedParticles(ParticleSet & particles, InterfaceMesh & interfaces)
{
  std::vector<PointId> number(particles.Size(), 0);
  for (const auto & triangle : interfaces.triangles)
  {
    for (const auto corner : triangle)
    {
      number[corner] = 1;
    }
  }
  PointId kept = 0;
  for (std::size_t p = 0; p < number.size(); ++p)
  {
    if (number[p])
    {
      particles.positions[kept] = particles.positions[p];
      particles.cells[kept] = particles.cells[p];
      number[p] = kept++;
    }
  }
  const std::size_t dropped = particles.Size() - kept;
  particles.positions.resize(kept);
  particles.cells.resize(kept);
  for (auto & triangle : interfaces.triangles)
  {
    for (auto & corner : triangle)
    {
      corner = number[corner];
    }
  }
  return dropped;
}

/** Lists the interface triangles of which a corner is not on a cell with both of their materials, by their centres. */
std::vector<MeshingPlace>
FindInconsistentTriangles(const IndicatorSet &  indicators,
                          const ParticleSet &   particles,
                          const InterfaceMesh & interfaces,
                          Material              exterior)
{
  const auto lies = [&](PointId corner, Material side) {
    const Cell & cell = particles.CellOf(corner);
    return cell.Has(side) || (side == exterior &&
                              std::any_of(cell.begin(), cell.end(), [&](Material m) { return indicators.IsPlane(m); }));
  };
  std::vector<MeshingPlace> places;
  for (std::size_t t = 0; t < interfaces.triangles.size(); ++t)
  {
    const auto & sides = interfaces.sides[t];
    const auto & corners = interfaces.triangles[t];
    if (!std::all_of(corners.begin(), corners.end(), [&](PointId corner) {
          return lies(corner, sides[0]) && lies(corner, sides[1]);
        }))
    {
      const auto & x = particles.positions;
      places.push_back({ ToPoint((x[corners[0]] + x[corners[1]] + x[corners[2]]) / 3.0), { sides[0], sides[1] } });
    }
  }
  return places;
}

/** Tells of how the materials around points meet. */
void
DescribeLinks(const LinkRepairReport & repair, const ParticleSet & particles, LinkReport & report)
{
  report.edges = repair.found.edges.size();
  report.points = repair.found.points.size();
  report.relabelled = repair.relabelled;
  const auto add = [&](const Vector & x, PointId p) {
    const Cell & cell = particles.CellOf(p);
    report.left.push_back({ ToPoint(x), std::vector<int>(cell.begin(), cell.end()) });
  };
  for (const PointId p : repair.left.points)
  {
    add(particles.positions[p], p);
  }
  for (const auto & edge : repair.left.edges)
  {
    add(0.5 * (particles.positions[edge[0]] + particles.positions[edge[1]]), edge[0]);
  }
}

/** The particles, the sizes that they follow, and their labelled Delaunay tetrahedralization. */
class SurfaceBuilder
{
public:
  SurfaceBuilder(const IndicatorSet &      indicators,
                 const SizingField &       sizing,
                 const SurfaceParameters & parameters,
                 std::vector<float> &      sizes,
                 ParticleSet &             particles)
    : m_Indicators(indicators)
    , m_Sizing(sizing)
    , m_ExteriorIndex(parameters.exterior)
    , m_Exterior(parameters.ExteriorOf(indicators))
    , m_Seed(parameters.seed)
    , m_MendingRounds(parameters.keepTopology ? MendingRounds : 0)
    , m_Topology(indicators, m_Exterior, SampleLattice::RefinementFor(parameters.keepTopology))
    , m_Sizes(sizes)
    , m_Particles(particles)
  {}

  void
  Build(Monitor & monitor)
  {
    SortInSpace(m_Particles);
    int        done = 0;
    const auto tell = [&]() { monitor.Report(double(++done) / (SurfaceRounds + m_MendingRounds + 1)); };
    for (int round = 0; round < SurfaceRounds; ++round)
    {
      this->Triangulate();
      tell();
      this->Relax(round + 1 == SurfaceRounds);
    }
    for (int round = 0;;)
    {
      this->Triangulate();
      tell();
      this->MendLinks();
      if (!this->Mend(round))
      {
        break;
      }
    }
  }

  /** The interfaces, and how they came about. */
  InterfaceMesh
  Describe(MeshingReport & report)
  {
    report.residualsOfParticles = MeasureResiduals(m_Indicators, m_Particles);
    m_Repair.left = FindLinkDefects(m_Labelled, *m_Adjacency, m_Exterior);
    report.links.updatedCells = UpdateCells(m_Indicators, m_Labelled, *m_Adjacency, m_Exterior, m_Particles);
    DescribeLinks(m_Repair, m_Particles, report.links);
    InterfaceMesh interfaces = this->Interfaces();
    report.inconsistentTriangles = FindInconsistentTriangles(m_Indicators, m_Particles, interfaces, m_Exterior);
    return interfaces;
  }

  TopologyReport
  CompareTopology()
  {
    return m_Topology.Compare(m_Particles.positions, m_Labelled);
  }

private:
  void
  Triangulate()
  {
    m_Labelled.tetrahedra = TetrahedralizeWithin(m_Indicators.GetGrid(), m_Particles.positions);
    m_Labelled.materials = LabelTetrahedra(m_Indicators, m_Particles, m_Labelled.tetrahedra, m_Exterior);
    m_Adjacency.emplace(m_Labelled.tetrahedra, m_Particles.Size());
  }

  InterfaceMesh
  Interfaces() const
  {
    return ExtractInterfaces(m_Labelled, m_Adjacency->neighbours, m_Exterior);
  }

  void
  MendLinks()
  {
    m_Repair = RepairLinks(m_Indicators, m_Particles.positions, *m_Adjacency, m_Exterior, m_Labelled);
    TurnFlatTetrahedra(m_Indicators, m_Particles.positions, *m_Adjacency, m_Exterior, m_Labelled);
  }

  /** Relaxes the particles on the surface, and samples what it missed; the last time also what connects otherwise. */
  void
  Relax(bool isLast)
  {
    const InterfaceMesh interfaces = this->Interfaces();
    const auto          lost = FindNodesToSample(m_Indicators, m_Sizes, m_Particles, m_Labelled, m_Exterior);
    std::vector<Index>  differing;
    if (isLast)
    {
      this->MendLinks();
      const auto found = this->FindDifferences();
      AddSamplesOf(found.places, m_MendingRounds > 0 ? AnyNumber : LargestPlace, differing);
      if (m_MendingRounds > 0)
      {
        AddSamplesOf(found.cancelling, AnyNumber, differing);
      }
    }
    RelaxOnSurface(m_Indicators, m_Sizing, interfaces, SurfaceSweeps, !isLast, m_Particles);
    MergeCloseParticles(m_Indicators, m_Sizing, m_Particles);
    RefineSizes(m_Indicators.GetGrid(), lost, m_Sizes);
    SeedParticlesAround(m_Indicators, m_Sizing, m_ExteriorIndex, m_Seed, lost, m_Particles);
    this->SampleFinely(differing, RecoverySize);
    SortInSpace(m_Particles); // some have been added at the end
  }

  /** Adds particles where the topology is not that of the partition, or differences cancel out, in later rounds more
   * closely and further around. Rounds in which there is no room for one are left out. Returns whether there is another
   * triangulation to make. */
  bool
  Mend(int & round)
  {
    if (round >= m_MendingRounds)
    {
      return false;
    }
    const auto         found = this->FindDifferences();
    std::vector<Index> samples;
    AddSamplesOf(found.places, AnyNumber, samples);
    if (double(samples.size()) > ShareOfNoise * double(m_Topology.GetLattice().NumberOfKept()))
    {
      return false;
    }
    const bool isFew = samples.size() <= MostSamplesToGrow;
    AddSamplesOf(found.cancelling, AnyNumber, samples);
    std::size_t added = 0;
    for (; round < m_MendingRounds && added == 0 && !samples.empty(); ++round)
    {
      const double             distance = RecoverySize * std::pow(MendingShrinkage, round);
      const int                reach = isFew ? std::max(0, round + 1 - MendingRoundsInPlace) : 0;
      const std::vector<float> sizes = m_Sizes;
      added = this->SampleFinely(this->Around(samples, reach), distance);
      if (added == 0)
      {
        m_Sizes = sizes; // nothing follows the new ones
      }
    }
    return added > 0;
  }

  /** Samples, and those around them. */
  std::vector<Index>
  Around(const std::vector<Index> & samples, int reach) const
  {
    std::vector<Index> around;
    for (const Index & sample : samples)
    {
      IndexBox{ sample, sample }.Grown(reach, m_Topology.GetLattice().GetSize()).Visit([&](const Index & at) {
        around.push_back(at);
      });
    }
    MakeUnique(around);
    return around;
  }

  /** Where the topology of the tetrahedra is not that of the partition. */
  TopologyDifferences
  FindDifferences()
  {
    return m_Topology.FindDifferences(m_Particles.positions, m_Labelled);
  }

  /** Adds the samples of places, if they do not have more than `most`. */
  static void
  AddSamplesOf(const std::vector<TopologyDifference> & places, std::size_t most, std::vector<Index> & samples)
  {
    for (const auto & place : places)
    {
      if (place.samples.size() <= most)
      {
        samples.insert(samples.end(), place.samples.begin(), place.samples.end());
      }
    }
    MakeUnique(samples);
  }

  /** Adds particles around samples, at a distance. Returns how many. */
  std::size_t
  SampleFinely(const std::vector<Index> & samples, double distance)
  {
    std::vector<Vector> places;
    for (const Index & sample : samples)
    {
      places.push_back(m_Topology.GetLattice().Position(sample));
    }
    RefineSizes(m_Indicators.GetGrid(), places, distance, m_Sizes);
    return SeedParticlesAround(
      m_Topology.GetLattice(), m_Topology.GetPartition(), samples, m_Sizing, m_ExteriorIndex, m_Seed, m_Particles);
  }

  const IndicatorSet &                m_Indicators;
  const SizingField &                 m_Sizing;
  const int                           m_ExteriorIndex;
  const Material                      m_Exterior;
  const std::uint64_t                 m_Seed;
  const int                           m_MendingRounds;
  TopologyComparison                  m_Topology;
  std::vector<float> &                m_Sizes;
  ParticleSet &                       m_Particles;
  TetrahedralMesh                     m_Labelled;
  std::optional<TetrahedronAdjacency> m_Adjacency;
  LinkRepairReport                    m_Repair;
};
} // namespace

InterfaceMesh
BuildSurface(const IndicatorSet &      indicators,
             const SizingField &       sizing,
             const SurfaceParameters & parameters,
             std::vector<float> &      sizes,
             ParticleSet &             particles,
             Monitor &                 monitor,
             MeshingReport &           report)
{
  SurfaceBuilder builder(indicators, sizing, parameters, sizes, particles);
  builder.Build(monitor);
  InterfaceMesh interfaces = builder.Describe(report);
  if (parameters.compareTopology)
  {
    // no later stage changes it, or else it is compared again
    monitor.Report(1.0);
    monitor.BeginStage("topology");
    report.topology = builder.CompareTopology();
  }
  report.unusedParticles = DropUnusedParticles(particles, interfaces);
  for (std::size_t p = 0; p < particles.Size(); ++p)
  {
    ++report.particles[particles.CellOf(p).Dimension()];
  }
  return interfaces;
}
} // namespace mmm
