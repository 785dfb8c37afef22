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
#ifndef mmmMissingSamples_h
#define mmmMissingSamples_h

#include "mesh/TetrahedronNeighbours.h"
#include "surface/SampleFinder.h"

namespace mmm
{
struct MissingSamples
{
  /** In an order that depends on the mesh only. */
  std::vector<MissingSample> samples;
  /** Particles that turned out to lie on a cell of more materials, and now are there. */
  std::size_t completedCells{ 0 };
};

/** \brief Finds where the particles are too far apart to tell the materials of the tetrahedra between them.
 *
 * The corners of a tetrahedron of one material all lie on cells of that material. Where there is no material that they
 * have in common, an interface passes through an edge whose ends have none, a 1-cell through such a face, or a 0-cell
 * through the tetrahedron: there a sample is missing. Or a corner all but touches another material, which its cell gets
 * then. Only tetrahedra at interfaces are looked at; what lies beyond the mesh has the material `exterior`. */
MissingSamples
FindMissingSamples(const IndicatorSet &          indicators,
                   const TetrahedralMesh &       mesh,
                   const TetrahedronNeighbours & neighbours,
                   Material                      exterior,
                   ParticleSet &                 particles);

/** Adds particles at these places. Those of surfaces that such a particle crowds leave; one that is there already, of
 * fewer materials, gets those that it lacks. Returns how many were added or changed. */
std::size_t
AddMissingSamples(const IndicatorSet &               indicators,
                  const SizingField &                sizing,
                  const std::vector<MissingSample> & samples,
                  ParticleSet &                      particles);
} // namespace mmm

#endif
