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
#ifndef mmmSpatialOrder_h
#define mmmSpatialOrder_h

#include "particles/Particles.h"
#include "mesh/TetrahedralMesh.h"

#include <cstddef>
#include <vector>

namespace mmm
{
/** The points from number `first` on in an order in which neighbors in space mostly are neighbors in memory: along a
 * Z-order curve (Morton, 1966) through their bounding box. */
std::vector<PointId>
SpatialOrder(const std::vector<Vector> & points, std::size_t first = 0);

/** Sorts the particles from number `first` on in this way. */
void
SortInSpace(ParticleSet & particles, std::size_t first = 0);
} // namespace mmm

#endif
