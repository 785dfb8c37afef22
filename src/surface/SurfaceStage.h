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
#ifndef mmmSurfaceStage_h
#define mmmSurfaceStage_h

#include "MultiMaterialMeshingReports.h"
#include "mesh/InterfaceMesh.h"
#include "particles/Particles.h"

#include <cstdint>
#include <vector>

namespace mmm
{
struct SurfaceParameters
{
  /** The number of the material that is not meshed, or -1. */
  int                  exterior{ -1 };
  std::uint64_t        seed{ 1 };
  RelaxationParameters relaxation;
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

/** \brief The interfaces: triangles between particles, which all are corners of one.
 *
 * Rounds of labelled Delaunay tetrahedralization and of relaxation of the particles on the triangles between the
 * materials; parts that a round missed are sampled more finely, for which sizes become smaller there. Samples that
 * tetrahedra lack are added, see FindMissingSamples(); links are mended, see RepairLinks(). Where the topology is not
 * that of the indicators, particles are added, too; with `keepTopology` in more rounds, and looking more closely. With
 * `compareTopology`, what is left of that goes to the report, in a stage "topology" of its own. */
InterfaceMesh
BuildSurface(const IndicatorSet &      indicators,
             const SurfaceParameters & parameters,
             SizingField &             sizing,
             ParticleSet &             particles,
             Monitor &                 monitor,
             MeshingReport &           report);
} // namespace mmm

#endif
