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
#ifndef mmmLinkDefects_h
#define mmmLinkDefects_h

#include "mesh/TetrahedronAdjacency.h"

namespace mmm
{
/** \brief Where the materials around a point do not meet as they do on a cell. */
struct LinkDefects
{
  /** Around the edge, a material appears in more than one place. */
  std::vector<std::array<PointId, 2>> edges;
  /** Around the point, a material is in several parts, or encircles others. */
  std::vector<PointId> points;
};

/** Checks the links of all points and edges of interfaces: the tetrahedra of each material at a point form one part,
 * which is a disk of the sphere around it, and those at an edge one sector. On 2-, 1- and 0-cells that means two disks,
 * three half-disks, and four triangles. What lies beyond the mesh has the material `outside`. Both lists are ascending.
 * The adjacency is that of the mesh. */
LinkDefects
FindLinkDefects(const TetrahedralMesh & mesh, const TetrahedronAdjacency & adjacency, Material outside);

/** The same for some points, ascending, and the edges at them. */
LinkDefects
FindLinkDefects(const TetrahedralMesh &      mesh,
                const TetrahedronAdjacency & adjacency,
                Material                     outside,
                const std::vector<PointId> & points);
} // namespace mmm

#endif
