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
#ifndef mmmSurfaceDescription_h
#define mmmSurfaceDescription_h

#include "MultiMaterialMeshingReports.h"
#include "mesh/InterfaceMesh.h"
#include "particles/Particles.h"
#include "surface/LinkRepair.h"

namespace mmm
{
/** Lists the interface triangles of which a corner is not on a cell with both of their materials, by their centres. */
std::vector<MeshingPlace>
FindInconsistentTriangles(const IndicatorSet &  indicators,
                          const ParticleSet &   particles,
                          const InterfaceMesh & interfaces,
                          Material              exterior);

/** Tells of how the materials around points meet. The cells that were updated are not known here. */
LinkReport
DescribeLinks(const LinkRepairReport & repair, const ParticleSet & particles);

/** Drops the particles that no triangle uses and renumbers the triangles. Returns how many were dropped. */
std::size_t
DropUnusedParticles(ParticleSet & particles, InterfaceMesh & interfaces);
} // namespace mmm

#endif
