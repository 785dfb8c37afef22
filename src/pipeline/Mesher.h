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
#ifndef mmmMesher_h
#define mmmMesher_h

#include "MultiMaterialMeshingExport.h"
#include "mesh/InterfaceMesh.h"
#include "mesh/Junctions.h"
#include "sizing/MeshEstimate.h"
#include "optimize/MeshOptimizer.h"
#include "mesh/MeshingPlace.h"
#include "particles/Particles.h"
#include "surface/Sampling.h"
#include "topology/TopologyComparison.h"

#include <string>

namespace mmm
{
struct MeshingParameters
{
  /** The number of the material that is not meshed, or -1. */
  int                    exterior{ -1 };
  std::uint64_t          seed{ 1 };
  RelaxationParameters   relaxation;
  OptimizationParameters optimization;
  /** Leave only the surface: no particles of the interior, no tetrahedra in the end. */
  bool surfaceOnly{ false };
  /** Add particles until the topology of the surface is that of the indicators, as far as possible. */
  bool keepTopology{ false };
  /** Compare the Betti numbers of the mesh with those of the indicators' partition. */
  bool compareTopology{ false };

  /** The number of what is not meshed: that of its material, or one that no material has. */
  Material
  ExteriorOf(const IndicatorSet & indicators) const
  {
    return Material(exterior >= 0 ? std::size_t(exterior) : indicators.GetNumberOfMaterials());
  }
};

/** \brief How the materials meet around the points of interfaces, see FindLinkDefects(). */
struct LinkReport
{
  /** Defects that labelling left. */
  std::size_t edges{ 0 };
  std::size_t points{ 0 };
  /** Tetrahedra that were given to another material to mend them. */
  std::size_t relabelled{ 0 };
  /** Particles that got the cell of the materials that meet there. */
  std::size_t updatedCells{ 0 };
  /** What could not be mended. */
  std::vector<MeshingPlace> left;
};

/** What became of the particles, and of the surface. */
struct MeshingReport
{
  /** What was expected before the work began. */
  MeshEstimate                    estimate;
  std::array<std::size_t, 4>      particles{ { 0, 0, 0, 0 } };
  std::array<RelaxationReport, 4> relaxation;
  LinkReport                      links;
  /** Interface triangles of which a corner does not lie on a cell with both of the triangle's materials: their centres.
   */
  std::vector<MeshingPlace> inconsistentTriangles;
  /** Only if it was asked for. */
  TopologyReport topology;
  /** Particles that no interface triangle uses; they are dropped. */
  std::size_t unusedParticles{ 0 };
  /** Points that TetGen added to the interior to recover the interfaces. */
  std::size_t steinerPoints{ 0 };
  /** Whether TetGen could not recover the interfaces, and points of the interior that were in the way were left out. */
  bool               recoveryFailed{ false };
  OptimizationReport optimization;
  /** Of the final surface, against the sizes that were asked for. */
  SamplingReport sampling;
  /** Of the particles between which the surface was found, against the cells that they were put on. */
  ResidualReports residualsOfParticles;
  /** Where the optimizer left those that the surface uses, against the cells of the materials that meet at them in the
   * mesh, before the fit of the interfaces. Where there was nothing to optimize, the same particles as they were. */
  ResidualReports residualsAfterOptimization;
};

/** Points are in the frame of Grid; `exterior` stands for what is not meshed in `interfaces`. */
struct MeshingResult
{
  std::vector<Vector> points;
  InterfaceMesh       interfaces;
  TetrahedralMesh     tetrahedra;
  /** How many of `points`, the first, belong to the interfaces. */
  std::size_t numberOfSurfacePoints{ 0 };
  /** The particles on 0-, 1- and 2-cells. They are the first of `points`, in this order; there, those of curved
   * surfaces have left their cell a little for the sake of the volumes. */
  ParticleSet particles;
  /** Where three and more materials meet, and the edges and corners of cuts. */
  Junctions     junctions;
  MeshingReport report;
};

/** \brief From indicators and a sizing field to the surface and the tetrahedra.
 *
 * Particles on 0-, 1- and 2-cells are seeded and relaxed, lower cells first; their Delaunay tetrahedralization is
 * labelled by the indicators, which gives the interfaces; particles of the interior follow, relaxed like the others;
 * the constrained tetrahedralization of all is improved. `result` is filled stage by stage: where a later stage throws,
 * it holds what the stages before it made. */
MultiMaterialMeshing_EXPORT void
BuildMesh(const IndicatorSet &      indicators,
          const SizingField &       sizing,
          const MeshingParameters & parameters,
          Monitor &                 monitor,
          MeshingResult &           result);
} // namespace mmm

#endif
