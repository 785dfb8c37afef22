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
#ifndef mmmBoundarySheets_h
#define mmmBoundarySheets_h

#include "base/DisjointSets.h"
#include "mesh/KeyedRuns.h"
#include "mesh/MeshTopology.h"

namespace mmm
{
/** Joins the faces of a region's boundary at one of its edges by the wedges of complement between them. The run has the
 * faces, by their numbers. */
void
JoinSheets(const std::vector<Vector> &          points,
           const std::vector<Tetrahedron> &     tetrahedra,
           const std::vector<BoundaryFace> &    faces,
           const std::array<std::uint32_t, 2> & edge,
           const std::array<const Keyed *, 2> & run,
           DisjointSets &                       sheets);
} // namespace mmm

#endif
