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
#ifndef mmmConnectivityImprover_h
#define mmmConnectivityImprover_h

#include "optimize/OptimizerState.h"

namespace mmm
{
/** \brief Changes the connectivity around tetrahedra below a quality, worst first; returns the number of changes.
 *
 * Each change keeps the space that is filled and the topology of the interfaces, and makes the worst tetrahedron that
 * it touches better. Tetrahedra that are not below `poorQuality` get flips within their material only. The result does
 * not depend on the number of threads. */
std::size_t
ImproveTetrahedra(OptimizerState & state, double quality, double poorQuality);

/** \brief Changes the connectivity around triangles of interfaces below a radius ratio, likewise.
 *
 * The worst triangle gets better, and tetrahedra stay good enough, see OptimizerState::EnoughBesideTriangles(). */
std::size_t
ImproveTriangles(OptimizerState & state, double radiusRatio);
} // namespace mmm

#endif
