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
#ifndef mmmCellUpdate_h
#define mmmCellUpdate_h

#include "indicators/IndicatorSet.h"
#include "particles/Particles.h"
#include "mesh/TetrahedronAdjacency.h"

namespace mmm
{
/** \brief Gives particles the cell of the materials that meet at them in a labelled mesh, where that is another one and
 * lies nearby. Particles do not move. What lies beyond the mesh has the material `outside`. */
void
UpdateCells(const IndicatorSet &         indicators,
            const TetrahedralMesh &      mesh,
            const TetrahedronAdjacency & adjacency,
            Material                     outside,
            ParticleSet &                particles);
} // namespace mmm

#endif
