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

#include "pipeline/Mesher.h"

namespace mmm
{
/** \brief The interfaces: triangles between particles, which all are corners of one.
 *
 * Rounds of labelled Delaunay tetrahedralization and of relaxation of the particles on the triangles between the
 * materials; parts that a round missed are sampled more finely, for which `sizes`, the values of `sizing`, become
 * smaller there. Links are mended, see RepairLinks(). Where the topology is not that of the indicators, particles are
 * added, too; with `keepTopology` in more rounds, and looking more closely. With `compareTopology`, what is left of
 * that goes to the report, in a stage "topology" of its own. */
InterfaceMesh
BuildSurface(const IndicatorSet &      indicators,
             const SizingField &       sizing,
             const MeshingParameters & parameters,
             std::vector<float> &      sizes,
             ParticleSet &             particles,
             Monitor &                 monitor,
             MeshingReport &           report);
} // namespace mmm

#endif
