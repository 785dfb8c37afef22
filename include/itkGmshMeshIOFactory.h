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
#ifndef itkGmshMeshIOFactory_h
#define itkGmshMeshIOFactory_h

#include "itkGmshMeshIO.h"
#include "itkMeshIOFactoryOf.h"

namespace itk
{
/** \class GmshMeshIOFactory
 * \brief Creates GmshMeshIO objects, so that itk::MeshFileReader and itk::MeshFileWriter know `.msh`.
 *
 * \ingroup MultiMaterialMeshing
 */
class MultiMaterialMeshing_EXPORT GmshMeshIOFactory : public MeshIOFactoryOf<GmshMeshIO>
{
public:
  /** Standard class type aliases. */
  using Self = GmshMeshIOFactory;
  using Superclass = MeshIOFactoryOf<GmshMeshIO>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  /** Method for class instantiation. */
  itkFactorylessNewMacro(Self);

  /** \see LightObject::GetNameOfClass() */
  itkOverrideGetNameOfClassMacro(GmshMeshIOFactory);

  /** Register one factory of this type. */
  static void
  RegisterOneFactory()
  {
    ObjectFactoryBase::RegisterFactoryInternal(Self::New());
  }

protected:
  GmshMeshIOFactory()
    : Superclass("itkGmshMeshIO")
  {}
  ~GmshMeshIOFactory() override = default;
};
} // end namespace itk

#endif
