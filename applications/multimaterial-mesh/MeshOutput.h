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
#ifndef MeshOutput_h
#define MeshOutput_h

#include "itkMultiMaterialMeshTypes.h"

#include <string>

namespace cli
{
/** \brief Writes a mesh as compressed .vtu. Throws Error; no incomplete file is left behind.
 *
 * The mesh is not to be updated by its pipeline: disconnect it before. */
void
WriteMesh(const itk::LabelTetrahedralMesh * mesh, const std::string & fileName);
void
WriteMesh(const itk::LabelInterfaceMesh * mesh, const std::string & fileName);
void
WriteMesh(const itk::LabelParticleMesh * mesh, const std::string & fileName);
} // namespace cli

#endif
