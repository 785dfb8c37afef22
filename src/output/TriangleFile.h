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
#ifndef mmmTriangleFile_h
#define mmmTriangleFile_h

#include "itkMultiMaterialMeshTypes.h"

#include <string>

namespace mmm
{
/** \brief Write triangles without labels, in formats that have none. Throw itk::ExceptionObject; no incomplete file is
 * left behind.
 *
 * STL (binary) and OBJ tell 3D Slicer whether points are in LPS or RAS, in a comment. */
void
WriteSTL(const itk::LabelInterfaceMesh * mesh, const std::string & fileName, bool ras);
void
WriteOBJ(const itk::LabelInterfaceMesh * mesh, const std::string & fileName, bool ras);
void
WriteOFF(const itk::LabelInterfaceMesh * mesh, const std::string & fileName, bool ras);
/** FreeSurfer's binary format, whose points are in RAS. */
void
WriteFreeSurfer(const itk::LabelInterfaceMesh * mesh, const std::string & fileName);
} // namespace mmm

#endif
