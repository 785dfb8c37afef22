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
#ifndef mmmFlatTetrahedra_h
#define mmmFlatTetrahedra_h

#include "indicators/IndicatorSet.h"
#include "mesh/TetrahedronAdjacency.h"
#include "particles/Particles.h"

namespace mmm
{
/** \brief Gives flat tetrahedra that lie on an interface to the material on its other side, where that makes triangles
 * better.
 *
 * All four corners of such a tetrahedron are samples of the interface, which runs on either side of it alike: it is
 * chance which two of its faces, or one or three, become triangles of the interface. Here those of the better radius
 * ratio do, worst first, as long as links have no more defects than before, all points stay on interfaces, and the
 * indicators do not mind by more than a quarter of a voxel. Returns how many tetrahedra changed. */
std::size_t
TurnFlatTetrahedra(const IndicatorSet &         indicators,
                   const ParticleSet &          particles,
                   const TetrahedronAdjacency & adjacency,
                   Material                     outside,
                   TetrahedralMesh &            mesh);
} // namespace mmm

#endif
