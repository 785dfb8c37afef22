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
#include "pipeline/Mesher.h"

#include "base/FreedMemory.h"
#include "delaunay/ConformingDelaunay.h"
#include "delaunay/Enclosure.h"
#include "delaunay/TetGen.h"
#include "mesh/MeshInvariants.h"
#include "mesh/MeshTopology.h"
#include "mesh/Renumber.h"
#include "optimize/EdgeCurving.h"
#include "optimize/IndicatorConstraint.h"
#include "optimize/InterfaceFit.h"
#include "optimize/MeshCoarsening.h"
#include "particles/InteriorParticles.h"
#include "particles/SpatialOrder.h"
#include "surface/Sampling.h"
#include "topology/TopologyComparison.h"

#include "itkMacro.h"

#include <algorithm>
#include <cassert>
#include <string>

namespace mmm
{
namespace
{
const char * const RelaxationNames[] = { "",
                                         "relaxation of 1-cells",
                                         "relaxation of 2-cells",
                                         "relaxation of the interior" };

/** Smoothing takes over what relaxation has not settled in the interior. */
constexpr int InteriorSweeps = 12;

/** Puts the points of the interfaces first, those of them that are particles before the others, and drops the points
 * that no tetrahedron uses. Optimization may have collapsed particles and taken some off the interfaces. */
void
SortPoints(MeshingResult & result)
{
  enum Kind : std::uint8_t
  {
    Particle,
    OnInterface,
    Interior,
    Unused
  };
  std::vector<std::uint8_t> kinds(result.points.size(), Unused);
  for (const auto & t : result.tetrahedra.tetrahedra)
  {
    for (const auto corner : t)
    {
      kinds[corner] = Interior;
    }
  }
  ParticleSet & particles = result.particles;
  for (const auto & triangle : result.interfaces.triangles)
  {
    for (const auto corner : triangle)
    {
      kinds[corner] = corner < particles.Size() ? Particle : OnInterface;
    }
  }
  std::vector<PointId> number(result.points.size(), 0);
  std::vector<Vector>  points;
  ParticleSet          kept;
  kept.cellTable = particles.cellTable;
  points.reserve(result.points.size());
  for (const Kind kind : { Particle, OnInterface, Interior })
  {
    for (std::size_t p = 0; p < kinds.size(); ++p)
    {
      if (kinds[p] == kind)
      {
        number[p] = PointId(points.size());
        points.push_back(result.points[p]);
        if (kind == Particle)
        {
          kept.positions.push_back(particles.positions[p]);
          kept.cells.push_back(particles.cells[p]);
        }
      }
    }
    if (kind == OnInterface)
    {
      result.numberOfSurfacePoints = points.size();
    }
  }
  Renumber(number, result.tetrahedra.tetrahedra);
  Renumber(number, result.interfaces.triangles);
  for (CurvedEdge & edge : result.curvedEdges)
  {
    const auto ends = std::minmax(number[edge.ends[0]], number[edge.ends[1]]);
    edge.ends = { { ends.first, ends.second } };
  }
  std::sort(result.curvedEdges.begin(), result.curvedEdges.end());
  result.points.swap(points);
  particles = std::move(kept);
}

/** Says which material each tetrahedron has. Returns false where triangles are no faces of tetrahedra. */
bool
LabelTetrahedra(Material exterior, MeshingResult & result)
{
  auto materials = LabelByInterfaces(result.interfaces, result.tetrahedra.tetrahedra, exterior);
  if (materials)
  {
    result.tetrahedra.materials = std::move(*materials);
  }
  return materials.has_value();
}

/** The tetrahedra between the points that have the triangles among their faces, and their materials. The points after
 * the fixed ones may be left out. */
void
Tetrahedralize(const Grid & grid, std::size_t numberOfFixedPoints, Material exterior, MeshingResult & result)
{
  const auto &      triangles = result.interfaces.triangles;
  auto &            tetrahedra = result.tetrahedra.tetrahedra;
  const std::size_t numberOfPoints = result.points.size();
  bool              isLabelled = false;
  try
  {
    result.report.pointsLeftOut =
      ConformingTetrahedralization(grid, numberOfFixedPoints, triangles, result.points, tetrahedra);
    isLabelled = LabelTetrahedra(exterior, result);
  }
  catch (const TetGenFailure &)
  {
    isLabelled = false;
  }
  if (!isLabelled)
  {
    result.report.pointsLeftOut = 0;
    result.points.resize(numberOfPoints);
    try
    {
      tetrahedra = ConstrainedTetrahedralization(result.points, triangles);
      isLabelled = LabelTetrahedra(exterior, result); // TetGen 1.5.0 does not always say so
    }
    catch (const TetGenFailure &)
    {
      isLabelled = false;
    }
  }
  result.report.steinerPoints = isLabelled ? result.points.size() - numberOfPoints : 0;
  if (!isLabelled)
  {
    // the triangles come from the Delaunay tetrahedra of the fixed points
    result.report.pointsLeftOut = numberOfPoints - numberOfFixedPoints;
    result.points.resize(numberOfFixedPoints);
    tetrahedra = DelaunayTetrahedralization(result.points);
    if (!LabelTetrahedra(exterior, result))
    {
      throw TetGenFailure(__FILE__, __LINE__, "TetGen lost triangles of the surface.", "");
    }
    result.report.warnings.push_back(
      "TetGen could not recover the interfaces, so that all points of the interior were left out: elements there are "
      "larger than was asked for.");
  }
}

/** Where only the surface is wanted, tetrahedra are there to keep it free of intersections while its triangles improve:
 * none but the flattest are worked on. */
OptimizationParameters
ForSurface(OptimizationParameters parameters)
{
  constexpr double Angle = 5.0;
  constexpr int    Rounds = 3;
  parameters.poorAngle = Angle;
  parameters.flipAngle = Angle;
  parameters.angleToKeep = Angle;
  parameters.angleToKeepBesideTriangles = Angle;
  parameters.tetrahedronWeight = 0.0;
  parameters.rounds = std::min(parameters.rounds, Rounds);
  return parameters;
}

/** Whether a mesh has the Betti numbers that it had when it was compared. */
bool
HasTopologyOf(const TopologyReport &      report,
              std::size_t                 numberOfMaterials,
              const std::vector<Vector> & points,
              const TetrahedralMesh &     mesh)
{
  const auto topology = ComputeMeshTopology(points, mesh, numberOfMaterials);
  return std::all_of(report.labels.begin(), report.labels.end(), [&](const LabelTopology & entry) {
    return topology.regions[entry.label].betti == entry.mesh;
  });
}

/** The flat triangles need not stand for the curved interfaces: the edges between them are curved instead, as far as
 * the tetrahedra have room for that. */
void
CurveInterfaces(const IndicatorSet &    indicators,
                Material                exterior,
                const TetrahedralMesh & tetrahedra,
                Monitor &               monitor,
                MeshingResult &         result)
{
  CurvingReport & report = result.report.curving;
  result.curvedEdges = CurveEdges(indicators, exterior, tetrahedra, result.interfaces, result.points, monitor, report);
  if (report.withoutPlace + report.inverting > 0)
  {
    result.report.warnings.push_back(
      std::to_string(report.withoutPlace + report.inverting) + " of " + std::to_string(report.edges) +
      " edges on interfaces are straight in the second-order mesh: " + std::to_string(report.withoutPlace) +
      " whose interface is not close to their middle, " + std::to_string(report.inverting) +
      " that would turn a tetrahedron inside out, or nearly so.");
  }
}

/** What else there is to say of the surface once it is final. */
void
DescribeSurface(const IndicatorSet & indicators, const SizingField & sizing, Material exterior, MeshingResult & result)
{
  result.junctions = ExtractJunctions(
    result.interfaces, result.points, indicators.GetGrid(), indicators.GetNumberOfMaterials(), exterior);
  result.report.sampling = MeasureSampling(sizing, result.interfaces, result.points);
  result.report.residualsAfterOptimization = MeasureResiduals(indicators, result.particles);
}
} // namespace

void
BuildMesh(const IndicatorSet &      indicators,
          const SizingField &       wantedSizing,
          const MeshingParameters & parameters,
          Monitor &                 monitor,
          MeshingResult &           result)
{
  const Material  exterior = parameters.ExteriorOf(indicators);
  MeshingReport & report = result.report;
  ParticleSet &   particles = result.particles;

  SizingField sizing = wantedSizing; // the surface takes smaller ones where it would miss something

  monitor.BeginStage("seeding of particles");
  particles = SeedParticles(indicators, sizing, parameters.exterior, parameters.seed);
  monitor.Report(1.0);
  for (int dimension = 1; dimension <= 2; ++dimension)
  {
    monitor.BeginStage(RelaxationNames[dimension]);
    report.relaxation[dimension] =
      RelaxParticles(indicators, sizing, dimension, parameters.relaxation, particles, monitor);
  }

  monitor.BeginStage("surface");
  if (particles.Size() < 4)
  {
    itkGenericExceptionMacro(
      "There is no interface to mesh: "
      << particles.Size()
      << " particles found a place on one. The image needs at least one voxel of a label that is "
         "not exterior.");
  }
  result.interfaces = BuildSurface(indicators, parameters, sizing, particles, monitor, report);
  result.points = particles.positions;
  result.numberOfSurfacePoints = result.points.size();
  monitor.Report(1.0);

  ParticleSet all = particles;
  if (!parameters.surfaceOnly)
  {
    monitor.BeginStage("seeding of the interior");
    SeedInteriorParticles(indicators, sizing, parameters.exterior, parameters.seed, all);
    monitor.Report(1.0);
    monitor.BeginStage(RelaxationNames[3]);
    RelaxationParameters interior = parameters.relaxation;
    interior.maximumSweeps = std::min(interior.maximumSweeps, InteriorSweeps);
    report.relaxation[3] = RelaxParticles(indicators, sizing, 3, interior, all, monitor);
    SortInSpace(all, particles.Size());
    report.particles[3] = all.Size() - particles.Size();
  }

  monitor.BeginStage("constrained tetrahedralization");
  ReturnFreedMemory(); // TetGen needs most of all stages
  const auto corners = EnclosingCorners(indicators.GetGrid());
  result.points.insert(result.points.end(), corners.begin(), corners.end());
  const std::size_t numberOfFixedPoints = result.points.size();
  result.points.insert(result.points.end(), all.positions.begin() + particles.Size(), all.positions.end());
  try
  {
    Tetrahedralize(indicators.GetGrid(), numberOfFixedPoints, exterior, result);
  }
  catch (TetGenFailure & error)
  {
    if (!parameters.surfaceOnly)
    {
      error.SetDescription(error.GetDescription() + DescribeIntersections(result.points, result.interfaces.triangles));
      throw;
    }
    // the surface stands without being improved
    result.report.warnings.push_back("TetGen could not recover the interfaces, so the surface was not improved: its "
                                     "triangles are as they were sampled.");
    result.points.resize(result.numberOfSurfacePoints);
    DescribeSurface(indicators, wantedSizing, exterior, result);
    return;
  }
  assert(ArePositive(result.points, result.tetrahedra.tetrahedra, FlatVolume));
  monitor.Report(1.0);

  monitor.BeginStage("optimization");
  const IndicatorConstraint    constraint(indicators, exterior, particles);
  TetrahedralComplex           complex(result.tetrahedra, result.points.size());
  const OptimizationParameters optimization =
    parameters.surfaceOnly ? ForSurface(parameters.optimization) : parameters.optimization;
  report.optimization = OptimizeMesh(constraint, exterior, optimization, result.points, complex, monitor);
  if (parameters.numberOfTetrahedra > 0)
  {
    monitor.BeginStage("coarsening");
    CoarsenMesh(constraint,
                exterior,
                optimization,
                wantedSizing,
                parameters.numberOfTetrahedra,
                result.points,
                complex,
                report.optimization,
                monitor);
  }
  std::copy_n(result.points.begin(), particles.Size(), particles.positions.begin());
  result.tetrahedra = complex.GetMesh();
  assert(ArePositive(result.points, result.tetrahedra.tetrahedra));
  DropMaterial(exterior, result.tetrahedra);
  result.interfaces = ExtractInterfaces(result.tetrahedra, exterior);
  assert(AreClosed(result.interfaces));
  if (parameters.compareTopology &&
      !HasTopologyOf(report.topology, indicators.GetNumberOfMaterials(), result.points, result.tetrahedra))
  {
    const TetrahedronAdjacency adjacency(result.tetrahedra.tetrahedra, result.points.size());
    report.topology = TopologyComparison(indicators, exterior, SampleLattice::RefinementFor(parameters.keepTopology))
                        .Compare(result.points, result.tetrahedra, adjacency);
  }
  monitor.BeginStage("fit of the interfaces");
  if (parameters.secondOrder)
  {
    // those that are there for the surface alone do not stay
    CurveInterfaces(
      indicators, exterior, parameters.surfaceOnly ? TetrahedralMesh() : result.tetrahedra, monitor, result);
  }
  else
  {
    FitInterfaces(indicators, constraint, exterior, optimization, complex, result.points, monitor);
  }
  assert(ArePositive(result.points, result.tetrahedra.tetrahedra));
  if (parameters.surfaceOnly)
  {
    result.tetrahedra = TetrahedralMesh();
  }
  SortPoints(result);
  DescribeSurface(indicators, wantedSizing, exterior, result);
}
} // namespace mmm
