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
#ifndef LabelSurface_h
#define LabelSurface_h

#include "itkMultiMaterialMeshTypes.h"

#include <vector>

namespace cli
{
/** The labels of the tissues that the triangles enclose: all but the outside, ascending. */
std::vector<int>
EnclosedLabels(const itk::LabelInterfaceMesh * surface, int outside);

/** \brief The closed surface of one label: all triangles around it.
 *
 * Normals point outward. The cell data are the label itself and the one on the other side. */
itk::LabelInterfaceMesh::Pointer
ExtractLabelSurface(const itk::LabelInterfaceMesh * surface, int label);
} // namespace cli

#endif
