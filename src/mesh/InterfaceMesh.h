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
#ifndef mmmInterfaceMesh_h
#define mmmInterfaceMesh_h

#include "mesh/TetrahedronNeighbours.h"

#include <optional>

namespace mmm
{
/** Triangles between different materials: `first` < `second`, the normal (right hand rule) points to `second`. */
struct InterfaceMesh
{
  std::vector<Triangle>                triangles;
  std::vector<std::array<Material, 2>> sides;
};

/** The faces between tetrahedra of different materials. The outside of the mesh has the material `outside`. */
InterfaceMesh
ExtractInterfaces(const TetrahedralMesh & mesh, Material outside);
/** The same where neighbours are known. */
InterfaceMesh
ExtractInterfaces(const TetrahedralMesh & mesh, const TetrahedronNeighbours & neighbours, Material outside);

/** \brief The material of each tetrahedron, from the interfaces that are among the tetrahedra's faces.
 *
 * A face of an interface tells by its orientation which side a tetrahedron lies on; the others follow from their
 * neighbours. What no interface bounds is `outside`. Nothing where a triangle is not a face of any tetrahedron. */
std::optional<std::vector<Material>>
LabelByInterfaces(const InterfaceMesh & interfaces, const std::vector<Tetrahedron> & tetrahedra, Material outside);
} // namespace mmm

#endif
