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
#ifndef mmmSecondOrder_h
#define mmmSecondOrder_h

#include "itkMultiMaterialMeshTypes.h"

namespace mmm
{
/** \brief Second-order cells of a mesh's triangles and tetrahedra: of six nodes (ITK's quadratic triangle) and of ten.
 *
 * Those of ten are tetrahedra by their type. Their mid-nodes are in the order of VTK: of the edges 0-1, 1-2, 2-0, then
 * 0-3, 1-3, 2-3. The nodes follow the mesh's points, one for each edge, halfway where it is not among the mid-nodes.
 *
 * \throw itk::ExceptionObject if a cell is of another kind, or if no cell has the edge of a mid-node: it is one of
 * another mesh. */
template <typename TMesh>
typename TMesh::Pointer
MakeSecondOrder(const TMesh * mesh, const itk::LabelMidNodeMesh * midNodes);

extern template itk::LabelTetrahedralMesh::Pointer
MakeSecondOrder(const itk::LabelTetrahedralMesh * mesh, const itk::LabelMidNodeMesh * midNodes);
extern template itk::LabelInterfaceMesh::Pointer
MakeSecondOrder(const itk::LabelInterfaceMesh * mesh, const itk::LabelMidNodeMesh * midNodes);
} // namespace mmm

#endif
