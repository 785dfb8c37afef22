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
#ifndef mmmTetrahedronNeighbours_h
#define mmmTetrahedronNeighbours_h

#include "mesh/Incidence.h"
#include "mesh/TetrahedralMesh.h"

namespace mmm
{
/** Per tetrahedron the one beyond each of its faces (face f is opposite corner f), or NoTetrahedron. */
using TetrahedronNeighbours = std::vector<std::array<std::uint32_t, 4>>;

TetrahedronNeighbours
ComputeTetrahedronNeighbours(const std::vector<Tetrahedron> & tetrahedra);

/** The tetrahedra at each point. */
inline Incidence
StarsOfPoints(const std::vector<Tetrahedron> & tetrahedra, std::size_t points)
{
  return Incidence(points, tetrahedra.size(), [&](std::size_t t) -> const Tetrahedron & { return tetrahedra[t]; });
}

/** The same where these are known. */
TetrahedronNeighbours
ComputeTetrahedronNeighbours(const std::vector<Tetrahedron> & tetrahedra, std::size_t points, const Incidence & stars);
} // namespace mmm

#endif
