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
#ifndef mmmSurfaceRelaxation_h
#define mmmSurfaceRelaxation_h

#include "particles/Particles.h"
#include "mesh/InterfaceMesh.h"

namespace mmm
{
/** \brief Evens out the particles of 2-cells once it is known how triangles connect them.
 *
 * Repulsion leaves defects that only the connectivity shows. `sweeps` times, edges are flipped so that six triangles
 * meet at most particles, and each particle moves to the centroid of the triangles around it (Lloyd's relaxation), in
 * its tangent plane, and is projected on its cell. Then, with `adapt`, particles are added in the middle of edges
 * longer than 1.45 h and removed from edges shorter than 0.65 h. Only the particles are the result: tetrahedralize
 * again, and Delaunay's triangles will be nearly those that the flips led to. Returns how many particles were added and
 * removed. */
std::size_t
RelaxOnSurface(const IndicatorSet &  indicators,
               const SizingField &   sizing,
               const InterfaceMesh & interfaces,
               int                   sweeps,
               bool                  adapt,
               ParticleSet &         particles);
} // namespace mmm

#endif
