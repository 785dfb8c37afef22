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
#ifndef itkMeditMeshIOFactory_h
#define itkMeditMeshIOFactory_h

#include "itkMeditMeshIO.h"
#include "itkMeshIOFactoryOf.h"

namespace itk
{
/** \class MeditMeshIOFactory
 * \brief Creates MeditMeshIO objects, so that itk::MeshFileReader and itk::MeshFileWriter know `.mesh`.
 *
 * \ingroup MultiMaterialMeshing
 */
class MultiMaterialMeshing_EXPORT MeditMeshIOFactory : public MeshIOFactoryOf<MeditMeshIO>
{
public:
  /** Standard class type aliases. */
  using Self = MeditMeshIOFactory;
  using Superclass = MeshIOFactoryOf<MeditMeshIO>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  /** Method for class instantiation. */
  itkFactorylessNewMacro(Self);

  /** \see LightObject::GetNameOfClass() */
  itkOverrideGetNameOfClassMacro(MeditMeshIOFactory);

  /** Register one factory of this type. */
  static void
  RegisterOneFactory()
  {
    ObjectFactoryBase::RegisterFactoryInternal(Self::New());
  }

protected:
  MeditMeshIOFactory()
    : Superclass("itkMeditMeshIO")
  {}
  ~MeditMeshIOFactory() override = default;
};
} // end namespace itk

#endif
