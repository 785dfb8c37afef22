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
#ifndef mmmTetrahedronAdjacency_h
#define mmmTetrahedronAdjacency_h

#include "mesh/Incidence.h"
#include "mesh/TetrahedronNeighbours.h"

namespace mmm
{
/** \brief Which tetrahedra meet at faces and points. Materials do not matter, so that it stays valid while they change.
 */
struct TetrahedronAdjacency
{
  TetrahedronAdjacency(const std::vector<Tetrahedron> & tetrahedra, std::size_t points)
    : numberOfPoints(points)
    , stars(StarsOfPoints(tetrahedra, points))
    , neighbours(ComputeTetrahedronNeighbours(tetrahedra, points, stars))
  {}

  std::size_t numberOfPoints;
  /** The tetrahedra at each point. */
  Incidence             stars;
  TetrahedronNeighbours neighbours;
};
} // namespace mmm

#endif
