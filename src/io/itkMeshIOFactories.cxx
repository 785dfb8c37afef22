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
#include "itkMeditMeshIOFactory.h"
#include "itkVTUMeshIOFactory.h"

namespace itk
{
namespace
{
template <typename TFactory>
bool
Register()
{
  TFactory::RegisterOneFactory();
  return true;
}
} // namespace

// Undocumented API used to register during static initialization, once each.
// DO NOT CALL DIRECTLY.
void MultiMaterialMeshing_EXPORT
GmshMeshIOFactoryRegister__Private()
{
  static const bool isRegistered = Register<GmshMeshIOFactory>();
  (void)isRegistered;
}

void MultiMaterialMeshing_EXPORT
MeditMeshIOFactoryRegister__Private()
{
  static const bool isRegistered = Register<MeditMeshIOFactory>();
  (void)isRegistered;
}

void MultiMaterialMeshing_EXPORT
VTUMeshIOFactoryRegister__Private()
{
  static const bool isRegistered = Register<VTUMeshIOFactory>();
  (void)isRegistered;
}
} // end namespace itk
