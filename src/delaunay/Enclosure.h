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
#ifndef mmmEnclosure_h
#define mmmEnclosure_h

#include "base/Grid.h"
#include "mesh/TetrahedralMesh.h"

namespace mmm
{
/** The corners of a box far outside the image. Where they are among the points of a tetrahedralization, its convex hull
 * touches no interface, and the exterior is filled with tetrahedra of some depth. */
std::array<Vector, 8>
EnclosingCorners(const Grid & grid);

/** The Delaunay tetrahedralization of points of the image and of the enclosing corners, less the tetrahedra that the
 * corners belong to. */
std::vector<Tetrahedron>
TetrahedralizeWithin(const Grid & grid, const std::vector<Vector> & points);
} // namespace mmm

#endif
