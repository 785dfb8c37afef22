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
#include "itkMeditMeshIOFactory.h"
#include "itkMeditMeshIO.h"

#include "itkVersion.h"

namespace itk
{
MeditMeshIOFactory::MeditMeshIOFactory()
{
  this->RegisterOverride(
    "itkMeshIOBase", "itkMeditMeshIO", "Medit mesh IO", true, CreateObjectFunction<MeditMeshIO>::New());
}

MeditMeshIOFactory::~MeditMeshIOFactory() = default;

const char *
MeditMeshIOFactory::GetITKSourceVersion() const
{
  return ITK_SOURCE_VERSION;
}

const char *
MeditMeshIOFactory::GetDescription() const
{
  return "Medit MeshIO Factory, allows the loading of Medit meshes into insight";
}

// Undocumented API used to register during static initialization.
// DO NOT CALL DIRECTLY.
void MultiMaterialMeshing_EXPORT
MeditMeshIOFactoryRegister__Private()
{
  static bool isRegistered = false;
  if (!isRegistered)
  {
    isRegistered = true;
    MeditMeshIOFactory::RegisterOneFactory();
  }
}
} // end namespace itk
