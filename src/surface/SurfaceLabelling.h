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
#ifndef mmmSurfaceLabelling_h
#define mmmSurfaceLabelling_h

#include "particles/Particles.h"
#include "mesh/TetrahedralMesh.h"

namespace mmm
{
/** \brief Gives each tetrahedron of a Delaunay tetrahedralization of the particles its material.
 *
 * A tetrahedron lies in a material that all of its corners' cells have in common; among several, in the one whose
 * indicator is the largest over the tetrahedron. Where the cells have none in common the indicators decide alone. A
 * flat one whose corners are all of one interface goes to the side on which the centre of the sphere through them lies:
 * so the interface's triangles are those of the restricted Delaunay triangulation of its samples, whatever the noise of
 * the indicators along it. Exterior and planes give `exterior`, which is the number of materials if no material is
 * exterior. */
std::vector<Material>
LabelTetrahedra(const IndicatorSet &             indicators,
                const ParticleSet &              particles,
                const std::vector<Tetrahedron> & tetrahedra,
                Material                         exterior);
} // namespace mmm

#endif
