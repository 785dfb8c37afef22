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
#ifndef mmmEncroachingPoints_h
#define mmmEncroachingPoints_h

#include "mesh/TetrahedralMesh.h"

#include <vector>

namespace mmm
{
/** \brief Marks the points in the way of triangles that would be faces of the Delaunay tetrahedra without them.
 *
 * A triangle is a face if there is a ball with its corners on the sphere and no point inside: the centres of balls
 * through the corners are on a line, and each point forbids a part of it. The triangles are faces of the Delaunay
 * tetrahedralization of the first points, so that each has a ball that is empty of these. Where all points leave it
 * none, the others in the smallest ball that it has among the first ones encroach upon it. Where that one is huge, as
 * where four points are nearly on a circle, the smallest one through the corners stands for it, and the triangle may be
 * missing even without what is marked. */
std::vector<char>
FindEncroachingPoints(const Grid &                  grid,
                      std::size_t                   numberOfFirst,
                      const std::vector<Triangle> & triangles,
                      const std::vector<Vector> &   points);
} // namespace mmm

#endif
