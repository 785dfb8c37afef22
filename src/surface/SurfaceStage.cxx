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

#include "base/IndexBox.h"
#include "base/MakeUnique.h"
#include "delaunay/Enclosure.h"
#include "mesh/MeshInvariants.h"
#include "particles/ParticleMerging.h"
#include "particles/SpatialOrder.h"
#include "surface/CellUpdate.h"
#include "surface/FlatTetrahedra.h"
#include "surface/LinkRepair.h"
#include "surface/LostNodes.h"
#include "surface/MissingSamples.h"
#include "surface/Sampling.h"
#include "surface/SurfaceDescription.h"
#include "surface/SurfaceLabelling.h"
#include "surface/SurfaceParameters.h"
#include "surface/SurfaceRelaxation.h"
#include "topology/TopologyComparison.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <string>

namespace mmm
{
namespace
{
using Parameters = SurfaceRoundParameters;

constexpr std::size_t AnyNumber = std::size_t(-1);

/** What a detector found: places that particles are missing at, and the size to sample them at. */
struct SparsePlaces
{
  const SeedCubes &  cubes; // that seeds start from
  std::vector<Index> places;
  double             size;
};

/** Adds the samples of places, if they do not have more than `most`. */
void
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

/** The particles, the sizes that they follow, and their labelled Delaunay tetrahedralization. */
class SurfaceBuilder
{
public:
  SurfaceBuilder(const IndicatorSet &      indicators,
                 const SurfaceParameters & parameters,
                 SizingField &             sizing,
                 ParticleSet &             particles)
    : m_Indicators(indicators)
    , m_ExteriorIndex(parameters.exterior)
    , m_Exterior(parameters.ExteriorOf(indicators))
    , m_Seed(parameters.seed)
    , m_MendingRounds(parameters.keepTopology ? Parameters::MendingRounds : 0)
    , m_Topology(indicators, m_Exterior, SampleLattice::RefinementFor(parameters.keepTopology))
    , m_NodeCubes(indicators)
    , m_SampleCubes(m_Topology.GetLattice(), m_Topology.GetPartition())
    , m_Sizing(sizing)
    , m_Particles(particles)
  {}

  void
  Build(Monitor & monitor)
  {
    SortInSpace(m_Particles);
    int        done = 0;
    const auto tell = [&]() { monitor.Report(double(++done) / (Parameters::Rounds + m_MendingRounds + 1)); };
    for (int round = 0; round < Parameters::Rounds; ++round)
    {
      this->Triangulate();
      tell();
      this->Relax(round + 1 == Parameters::Rounds);
    }
    int consistencyRound = 0;
    for (int round = 0;;)
    {
      this->Triangulate();
      this->AddMissing();
      tell();
      this->MendLinks();
      if (!this->Mend(round) && !this->MendInconsistent(consistencyRound))
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
    UpdateCells(m_Indicators, m_Labelled, *m_Adjacency, m_Exterior, m_Particles);
    report.links = DescribeLinks(m_Repair, m_Particles);
    InterfaceMesh interfaces = this->Interfaces();
    report.inconsistentTriangles = FindInconsistentTriangles(m_Indicators, m_Particles, interfaces, m_Exterior);
    if (!report.inconsistentTriangles.empty())
    {
      report.warnings.push_back("Where labels meet in ways that no surface follows, " +
                                std::to_string(report.inconsistentTriangles.size()) + " of " +
                                std::to_string(interfaces.triangles.size()) +
                                " triangles may be off their interface by about their size; the report has the "
                                "places, and a smaller epsilon may help.");
    }
    return interfaces;
  }

  TopologyReport
  CompareTopology()
  {
    return m_Topology.Compare(m_Particles.positions, m_Labelled, *m_Adjacency);
  }

private:
  void
  Triangulate()
  {
    m_Labelled.tetrahedra = TetrahedralizeWithin(m_Indicators.GetGrid(), m_Particles.positions);
    m_Labelled.materials = LabelTetrahedra(m_Indicators, m_Particles, m_Labelled.tetrahedra, m_Exterior);
    m_Adjacency.emplace(m_Labelled.tetrahedra, m_Particles.Size());
    assert(ArePositive(m_Particles.positions, m_Labelled.tetrahedra, FlatVolume));
    assert(AreAdjacent(m_Labelled.tetrahedra, m_Adjacency->neighbours));
  }

  MissingSamples
  FindMissing()
  {
    return FindMissingSamples(m_Indicators, m_Labelled, m_Adjacency->neighbours, m_Exterior, m_Particles);
  }

  /** Adds the samples that tetrahedra lack, and triangulates again, as long as there are any. */
  void
  AddMissing()
  {
    for (int round = 0; round < MissingSampleParameters::Rounds; ++round)
    {
      const auto missing = this->FindMissing();
      if (missing.completedCells + AddMissingSamples(m_Indicators, m_Sizing, missing.samples, m_Particles) == 0)
      {
        return;
      }
      this->Triangulate();
    }
  }

  InterfaceMesh
  Interfaces() const
  {
    InterfaceMesh interfaces = ExtractInterfaces(m_Labelled, m_Adjacency->neighbours, m_Exterior);
    assert(AreClosed(interfaces));
    return interfaces;
  }

  void
  MendLinks()
  {
    m_Repair = RepairLinks(m_Indicators, m_Particles, *m_Adjacency, m_Exterior, m_Labelled);
    TurnFlatTetrahedra(m_Indicators, m_Particles, *m_Adjacency, m_Exterior, m_Labelled);
  }

  /** Relaxes the particles on the surface, and samples what it missed; the last time also what connects otherwise. */
  void
  Relax(bool isLast)
  {
    const InterfaceMesh       interfaces = this->Interfaces();
    std::vector<SparsePlaces> missed;
    missed.push_back(this->FindLost());
    if (isLast)
    {
      this->MendLinks();
      missed.push_back(this->FindOtherTopology());
    }
    const auto missing = this->FindMissing();
    RelaxOnSurface(m_Indicators, m_Sizing, interfaces, Parameters::SweepsPerRound, !isLast, m_Particles);
    AddMissingSamples(m_Indicators, m_Sizing, missing.samples, m_Particles);
    MergeCloseParticles(m_Indicators, m_Sizing, m_Particles);
    for (const SparsePlaces & sparse : missed)
    {
      this->Sample(sparse);
    }
    SortInSpace(m_Particles); // some have been added at the end
  }

  /** The nodes that the tetrahedra missed. */
  SparsePlaces
  FindLost() const
  {
    const Grid &       grid = m_Indicators.GetGrid();
    const auto         lost = FindLostNodes(m_Indicators, m_Particles.positions, m_Labelled, m_Exterior);
    std::vector<Index> nodes;
    for (const auto n : lost.parts)
    {
      nodes.push_back(grid.IndexAt(n));
    }
    for (const auto n : lost.corners)
    {
      const Index node = grid.IndexAt(n);
      if (m_Sizing.AtNode(node) < Parameters::CoarseSize)
      {
        nodes.push_back(node);
      }
    }
    return { m_NodeCubes, std::move(nodes), Parameters::RecoverySize };
  }

  /** The samples at which the topology of the tetrahedra is not that of the partition. */
  SparsePlaces
  FindOtherTopology()
  {
    const bool         keeps = m_MendingRounds > 0;
    const auto         found = this->FindDifferences();
    std::vector<Index> samples;
    AddSamplesOf(found.places, keeps ? AnyNumber : Parameters::LargestPlace, samples);
    if (keeps)
    {
      AddSamplesOf(found.cancelling, AnyNumber, samples);
    }
    return { m_SampleCubes, std::move(samples), Parameters::RecoverySize };
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
    if (double(samples.size()) > Parameters::ShareOfNoise * double(m_Topology.GetLattice().NumberOfKept()))
    {
      return false;
    }
    const bool isFew = samples.size() <= Parameters::MostSamplesToGrow;
    AddSamplesOf(found.cancelling, AnyNumber, samples);
    std::size_t added = 0;
    for (; round < m_MendingRounds && added == 0 && !samples.empty(); ++round)
    {
      const double      size = Parameters::RecoverySize * std::pow(Parameters::MendingShrinkage, round);
      const int         reach = isFew ? std::max(0, round + 1 - Parameters::MendingRoundsInPlace) : 0;
      const SizingField before = m_Sizing;
      added = this->Sample({ m_SampleCubes, this->Around(samples, reach), size });
      if (added == 0)
      {
        m_Sizing = before; // nothing follows the new ones
      }
    }
    return added > 0;
  }

  /** Adds particles where triangles are between other materials than meet at their corners: there was no place for a
   * sheet between particles that are too far apart. Returns whether there is another triangulation to make. */
  bool
  MendInconsistent(int & round)
  {
    if (round++ >= Parameters::ConsistencyRounds)
    {
      return false;
    }
    ParticleSet particles = m_Particles;
    UpdateCells(m_Indicators, m_Labelled, *m_Adjacency, m_Exterior, particles);
    const InterfaceMesh interfaces = this->Interfaces();
    const auto          places = FindInconsistentTriangles(m_Indicators, particles, interfaces, m_Exterior);
    const double        share = double(places.size()) / double(std::max<std::size_t>(interfaces.triangles.size(), 1));
    if (share <= Parameters::ConsistentEnough || share > Parameters::ShareOfNoise)
    {
      return false;
    }
    std::vector<Index> samples;
    for (const MeshingPlace & place : places)
    {
      const Vector x(place.position[0], place.position[1], place.position[2]);
      if (m_Sizing(x) < Parameters::CoarseSize)
      {
        samples.push_back(m_Topology.GetLattice().NearestTo(x));
      }
    }
    MakeUnique(samples);
    return this->Sample(
             { m_SampleCubes, this->Around(samples, Parameters::ConsistencyReach), Parameters::ConsistencySize }) > 0;
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
    return m_Topology.FindDifferences(m_Particles.positions, m_Labelled, *m_Adjacency);
  }

  /** Makes sizes small at some places, and adds particles there. Returns how many. */
  std::size_t
  Sample(const SparsePlaces & sparse)
  {
    std::vector<Vector> positions;
    for (const Index & place : sparse.places)
    {
      positions.push_back(sparse.cubes.Position(place));
    }
    m_Sizing.Lower(positions, sparse.size, Parameters::RecoveryGrowth, Parameters::RecoveryReach);
    return SeedParticlesAround(sparse.cubes, sparse.places, m_Sizing, m_ExteriorIndex, m_Seed, m_Particles);
  }

  const IndicatorSet &                m_Indicators;
  const int                           m_ExteriorIndex;
  const Material                      m_Exterior;
  const std::uint64_t                 m_Seed;
  const int                           m_MendingRounds;
  TopologyComparison                  m_Topology;
  const NodeCubes                     m_NodeCubes;
  const SampleCubes                   m_SampleCubes;
  SizingField &                       m_Sizing;
  ParticleSet &                       m_Particles;
  TetrahedralMesh                     m_Labelled;
  std::optional<TetrahedronAdjacency> m_Adjacency;
  LinkRepairReport                    m_Repair;
};
} // namespace

InterfaceMesh
BuildSurface(const IndicatorSet &      indicators,
             const SurfaceParameters & parameters,
             SizingField &             sizing,
             ParticleSet &             particles,
             Monitor &                 monitor,
             MeshingReport &           report)
{
  SurfaceBuilder builder(indicators, parameters, sizing, particles);
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
