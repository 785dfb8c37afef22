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

#include "base/Grid.h"
#include "mesh/TetrahedralMesh.h"

#include <cstddef>
#include <vector>

namespace mmm
{
/** \brief Delaunay tetrahedra that have given triangles among their faces.
 *
 * The triangles come from the Delaunay tetrahedralization of the first `numberOfFixedPoints` points. Those of the
 * others that encroach upon a triangle are left out; points keep their numbers. What is missing even so is recovered
 * locally, where points may be added at the end. Returns how many were left out.
 * \throw TetGenFailure where that is not possible */
std::size_t
ConformingTetrahedralization(const Grid &                  grid,
                             std::size_t                   numberOfFixedPoints,
                             const std::vector<Triangle> & triangles,
                             std::vector<Vector> &         points,
                             std::vector<Tetrahedron> &    tetrahedra);
} // namespace mmm

#endif
