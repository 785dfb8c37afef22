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

#include "MultiMaterialMeshingReports.h"
#include "mesh/CurvedEdges.h"
#include "mesh/InterfaceMesh.h"
#include "mesh/Junctions.h"
#include "optimize/MeshOptimizer.h"
#include "particles/Particles.h"
#include "surface/SurfaceStage.h"

namespace mmm
{
struct MeshingParameters : SurfaceParameters
{
  OptimizationParameters optimization;
  /** Leave only the surface: no particles of the interior, no tetrahedra in the end. */
  bool surfaceOnly{ false };
  /** If the mesh has more tetrahedra, it is coarsened until it has so many; 0 is no limit. */
  std::size_t numberOfTetrahedra{ 0 };
  /** Leave the points of interfaces on the interfaces, and curve the edges between them. */
  bool secondOrder{ false };
};

/** Points, and the places of the report, are in the frame of Grid, and labels of the report are numbers of materials;
 * `exterior` stands for what is not meshed in `interfaces`. */
struct MeshingResult
{
  std::vector<Vector> points;
  InterfaceMesh       interfaces;
  TetrahedralMesh     tetrahedra;
  /** Only where they were asked for; they are edges of `interfaces`. */
  CurvedEdges curvedEdges;
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
void
BuildMesh(const IndicatorSet &      indicators,
          const SizingField &       sizing,
          const MeshingParameters & parameters,
          Monitor &                 monitor,
          MeshingResult &           result);
} // namespace mmm

#endif
