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
#ifndef mmmConformingDelaunay_h
#define mmmConformingDelaunay_h

#include "mesh/TetrahedralMesh.h"

#include <optional>

namespace mmm
{
/** \brief Delaunay tetrahedra that have given triangles among their faces, for where the recovery of the triangles
 * fails.
 *
 * The triangles come from the Delaunay tetrahedralization of the first `numberOfSurfacePoints` points. In that of all
 * points most of them are still there; where one is not, points in its way are left out, in the end all others. Points
 * keep their numbers. Returns how many were left out; nothing if some triangles are missing even so. */
std::optional<std::size_t>
ConformingTetrahedralization(const std::vector<Vector> &   points,
                             std::size_t                   numberOfSurfacePoints,
                             const std::vector<Triangle> & triangles,
                             std::vector<Tetrahedron> &    tetrahedra);
} // namespace mmm

#endif
