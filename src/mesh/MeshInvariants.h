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
#ifndef mmmMeshInvariants_h
#define mmmMeshInvariants_h

#include "mesh/InterfaceMesh.h"

namespace mmm
{
/** \file
 * What has to hold of meshes after each phase of the work, for assertions: Debug builds check it. */

/** Tetrahedra of TetGen that are flat may be turned over by rounding: those of no larger volume, in units of the
 * smallest voxel spacing. */
constexpr double FlatVolume = 1e-9;

/** Whether all tetrahedra are positively oriented. Those of a volume up to `tolerance` may be of any orientation. */
bool
ArePositive(const std::vector<Vector> & points, const std::vector<Tetrahedron> & tetrahedra, double tolerance = 0.0);

/** Whether neighbours are each other's, and have a face in common. */
bool
AreAdjacent(const std::vector<Tetrahedron> & tetrahedra, const TetrahedronNeighbours & neighbours);

/** Whether the triangles around each material are its closed boundary, all with the normal that their sides say. */
bool
AreClosed(const InterfaceMesh & interfaces);
} // namespace mmm

#endif
