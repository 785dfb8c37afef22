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
#include "itkGmshMeshIOFactory.h"
#include "itkGmshMeshIO.h"

#include "itkVersion.h"

namespace itk
{
GmshMeshIOFactory::GmshMeshIOFactory()
{
  this->RegisterOverride(
    "itkMeshIOBase", "itkGmshMeshIO", "Gmsh mesh IO", true, CreateObjectFunction<GmshMeshIO>::New());
}

GmshMeshIOFactory::~GmshMeshIOFactory() = default;

const char *
GmshMeshIOFactory::GetITKSourceVersion() const
{
  return ITK_SOURCE_VERSION;
}

const char *
GmshMeshIOFactory::GetDescription() const
{
  return "Gmsh MeshIO Factory, allows the loading of Gmsh meshes into insight";
}

// Undocumented API used to register during static initialization.
// DO NOT CALL DIRECTLY.
void MultiMaterialMeshing_EXPORT
GmshMeshIOFactoryRegister__Private()
{
  static bool isRegistered = false;
  if (!isRegistered)
  {
    isRegistered = true;
    GmshMeshIOFactory::RegisterOneFactory();
  }
}
} // end namespace itk
