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
#ifndef mmmGroupedMesh_h
#define mmmGroupedMesh_h

#include "MultiMaterialMeshingLabels.h"
#include "itkGroupedMeshIOBase.h"
#include "itkMultiMaterialMeshTypes.h"

namespace mmm
{
/** \brief Triangles between labels and tetrahedra as the cells of one mesh, for formats that number groups of cells.
 *
 * A tetrahedron's number is its label. The triangles between two labels have a number of their own, above 1000 and
 * above all labels; the name of their group tells the labels. Labels that have a name give it to their groups. */
struct GroupedMesh
{
  itk::LabelTetrahedralMesh::Pointer     mesh;
  itk::GroupedMeshIOBase::GroupNamesType names;
};

/** There may be no tetrahedra (null). The surface's points have to be the first ones of the tetrahedra's. */
GroupedMesh
MakeGroupedMesh(const itk::LabelTetrahedralMesh * tetrahedra,
                const itk::LabelInterfaceMesh *   surface,
                const LabelTable &                names);

/** With the numbers of SimNIBS: 1000 and the label of the tissue whose surface it is. Of two tissues, that is the one
 * that SimNIBS lists first: 1 (white matter), 2 (gray matter), 9, 3 (CSF), 4 (bone), 8, 7, 6, 10, 5 (scalp), all
 * others. The normal points away from it. */
GroupedMesh
MakeGroupedMeshForSimNIBS(const itk::LabelTetrahedralMesh * tetrahedra,
                          const itk::LabelInterfaceMesh *   surface,
                          int                               outside);
} // namespace mmm

#endif
