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
#include "mmmSurfaceStage.h"

#include "mmmCellUpdate.h"
#include "mmmEnclosure.h"
#include "mmmFlatTetrahedra.h"
#include "mmmLinkRepair.h"
#include "mmmLostNodes.h"
#include "mmmParticleMerging.h"
#include "mmmStuckTetrahedra.h"
#include "mmmSurfaceLabelling.h"
#include "mmmSurfaceRelaxation.h"
#include "mmmTopologyDifferences.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace mmm
{
namespace
{
/** Triangulations of the surface, each followed by sweeps of its particles, before the last one. */
constexpr int SurfaceRounds = 5;
constexpr int SurfaceSweeps = 2;
/** The first triangulation that is compared with the partition of the indicators. Where its topology is another one,
 * particles are added. */
constexpr int FirstComparison = SurfaceRounds - 1;
/** Triangulations after the sweeps that add such particles where the topology is to be kept, at most. */
constexpr int MendingRounds = 6;
/** In each of these rounds the distance is smaller by this factor, down to this one: what is smaller gets flat
 * elements. */
constexpr double MendingShrinkage = 0.75;
constexpr double SmallestMendingSize = 0.25;
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
  Index reach;
  for (int a = 0; a < 3; ++a)
  {
    reach[a] = int(RecoveryReach / grid.spacing[a]);
  }
  for (const Vector & place : places)
  {
    Index centre;
    for (int a = 0; a < 3; ++a)
    {
      centre[a] = int(std::floor(place[a] / grid.spacing[a] + 0.5));
    }
    for (int k = -reach[2]; k <= reach[2]; ++k)
    {
      for (int j = -reach[1]; j <= reach[1]; ++j)
      {
        for (int i = -reach[0]; i <= reach[0]; ++i)
        {
          const Index at{ { centre[0] + i, centre[1] + j, centre[2] + k } };
          if (grid.Contains(at))
          {
            const double distance = (grid.Position(at) - place).norm();
            float &      size = sizes[grid.Offset(at)];
            size = std::min(size, float(smallest + RecoveryGrowth * distance));
          }
        }
      }
    }
  }
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
      places.push_back({ (x[corners[0]] + x[corners[1]] + x[corners[2]]) / 3.0, { sides[0], sides[1] } });
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
    report.left.push_back({ x, std::vector<int>(cell.begin(), cell.end()) });
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

/** The places where the topology of the tetrahedra is not that of the partition: samples. With `finely`, also what lies
 * between samples, and some places where it is right. */
std::vector<Index>
FindDifferingSamples(const SampleLattice &        lattice,
                     const SampledMaterials &     partition,
                     const ParticleSet &          particles,
                     const TetrahedralMesh &      labelled,
                     const TetrahedronAdjacency & adjacency,
                     Material                     exterior,
                     bool                         finely)
{
  const auto &       x = particles.positions;
  std::vector<Index> samples;
  for (const auto & difference :
       FindTopologyDifferences(lattice, partition, lattice.SampleMesh(x, labelled, exterior, partition)))
  {
    for (const auto place : difference.samples)
    {
      samples.push_back(lattice.SampleAt(place));
    }
  }
  if (finely)
  {
    for (const auto t : FindStuckTetrahedra(lattice.GetIndicators(), x, adjacency, exterior, labelled))
    {
      const auto & c = labelled.tetrahedra[t];
      samples.push_back(lattice.SampleNear(0.25 * (x[c[0]] + x[c[1]] + x[c[2]] + x[c[3]])));
    }
  }
  return samples;
}

/** Adds particles around samples, at a distance that is smaller in later rounds. Returns how many. */
std::size_t
SampleFinely(const SampleLattice &      lattice,
             const SampledMaterials &   partition,
             const std::vector<Index> & samples,
             double                     distance,
             const SizingField &        sizing,
             int                        exteriorIndex,
             std::uint64_t              seed,
             std::vector<float> &       sizes,
             ParticleSet &              particles)
{
  std::vector<Vector> places;
  for (const Index & sample : samples)
  {
    places.push_back(lattice.Position(sample));
  }
  RefineSizes(lattice.GetIndicators().GetGrid(), places, distance, sizes);
  return SeedParticlesAround(lattice, partition, samples, sizing, exteriorIndex, seed, particles);
}
} // namespace

InterfaceMesh
BuildSurface(const IndicatorSet & indicators,
             const SizingField &  sizing,
             int                  exteriorIndex,
             std::uint64_t        seed,
             bool                 keepTopology,
             std::vector<float> & sizes,
             ParticleSet &        particles,
             Monitor &            monitor,
             MeshingReport &      report)
{
  const auto   exterior = Material(exteriorIndex >= 0 ? std::size_t(exteriorIndex) : indicators.GetNumberOfMaterials());
  const Grid & grid = indicators.GetGrid();
  const SampleLattice                 lattice(indicators, SampleLattice::RefinementFor(keepTopology));
  const SampledMaterials              partition = lattice.SamplePartition(exterior);
  TetrahedralMesh                     labelled;
  std::optional<TetrahedronAdjacency> adjacency;
  LinkRepairReport                    repair;
  const int                           lastRound = SurfaceRounds + (keepTopology ? MendingRounds : 0);
  for (int round = 0;; ++round)
  {
    labelled.tetrahedra = TetrahedralizeWithin(grid, particles.positions);
    labelled.materials = LabelTetrahedra(indicators, particles, labelled.tetrahedra, exterior);
    monitor.Report(double(round + 1) / (lastRound + 1));
    const bool               isRelaxed = round < SurfaceRounds;
    InterfaceMesh            interfaces;
    std::vector<std::size_t> lost;
    std::vector<Index>       differing;
    if (isRelaxed)
    {
      interfaces = ExtractInterfaces(labelled, exterior);
      lost = FindNodesToSample(indicators, sizes, particles, labelled, exterior);
    }
    if (round >= FirstComparison)
    {
      adjacency.emplace(labelled.tetrahedra, particles.Size());
      repair = RepairLinks(indicators, particles.positions, *adjacency, exterior, labelled);
      TurnFlatTetrahedra(indicators, particles.positions, *adjacency, exterior, labelled);
    }
    if (round == lastRound)
    {
      break;
    }
    if (round >= FirstComparison)
    {
      const bool finely = keepTopology && round > SurfaceRounds;
      differing = FindDifferingSamples(lattice, partition, particles, labelled, *adjacency, exterior, finely);
    }
    if (isRelaxed)
    {
      RelaxOnSurface(indicators, sizing, interfaces, SurfaceSweeps, round + 1 < SurfaceRounds, particles);
      MergeCloseParticles(indicators, sizing, particles);
      RefineSizes(grid, lost, sizes);
      SeedParticlesAround(indicators, sizing, exteriorIndex, seed, lost, particles);
    }
    const double distance =
      std::max(SmallestMendingSize, RecoverySize * std::pow(MendingShrinkage, std::max(0, round - SurfaceRounds)));
    const auto added =
      SampleFinely(lattice, partition, differing, distance, sizing, exteriorIndex, seed, sizes, particles);
    if (round > SurfaceRounds && added == 0)
    {
      break;
    }
  }
  repair.left = FindLinkDefects(labelled, *adjacency, exterior);
  report.links.updatedCells = UpdateCells(indicators, labelled, *adjacency, exterior, particles);
  DescribeLinks(repair, particles, report.links);
  InterfaceMesh interfaces = ExtractInterfaces(labelled, exterior);
  report.inconsistentTriangles = FindInconsistentTriangles(indicators, particles, interfaces, exterior);
  report.unusedParticles = DropUnusedParticles(particles, interfaces);
  for (std::size_t p = 0; p < particles.Size(); ++p)
  {
    ++report.particles[particles.CellOf(p).Dimension()];
  }
  return interfaces;
}
} // namespace mmm
