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

#include "MeshFormat.h"
#include "itkMultiMaterialMeshTypes.h"
#include "itkLabelImageStages.h"

#include <string>

namespace cli
{
/** \brief Writes meshes in the format of the file name's extension. Throws an exception; no incomplete file is left
 * behind.
 *
 * The meshes are not to be updated by their pipeline: disconnect them before. Formats that number groups of cells get
 * tetrahedra and the triangles between them in one file. */
void
WriteVolume(const itk::LabelTetrahedralMesh * tetrahedra,
            const itk::LabelInterfaceMesh *   surface,
            const std::string &               fileName,
            const MeshStyle &                 style);
void
WriteSurface(const itk::LabelInterfaceMesh * surface, const std::string & fileName, const MeshStyle & style);
void
WriteParticles(const itk::LabelParticleMesh * particles, const std::string & fileName);
void
WriteJunctions(const itk::LabelJunctionMesh * junctions, const std::string & fileName);

/** Throws Error if the meshes of the image's labels cannot be written as asked for. */
void
CheckLabelsFit(const Settings & settings, const mmm::LabelCounts & voxels);
} // namespace cli

#endif
