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
#ifndef mmmParticleMerging_h
#define mmmParticleMerging_h

#include "particles/Particles.h"

namespace mmm
{
/** \brief Joins particles that lie too close together for good triangles.
 *
 * On one sheet that is a part of h; between sheets and junctions, which h does not keep apart, a part of the smallest
 * voxel spacing. The particle of the lowest cell stays and belongs to the materials of all that it took in: two
 * junctions closer than this are one point, and a layer thinner than this is pinched. Returns how many particles are
 * gone. */
std::size_t
MergeCloseParticles(const IndicatorSet & indicators, const SizingField & sizing, ParticleSet & particles);
} // namespace mmm

#endif
