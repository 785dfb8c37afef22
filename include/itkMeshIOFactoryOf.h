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
#ifndef itkMeshIOFactoryOf_h
#define itkMeshIOFactoryOf_h

#include "itkObjectFactoryBase.h"
#include "itkVersion.h"

namespace itk
{
/** \class MeshIOFactoryOf
 * \brief What the factories of mesh IOs have in common: they make TMeshIO objects for itk::MeshFileReader and
 * itk::MeshFileWriter.
 *
 * \ingroup MultiMaterialMeshing
 */
template <typename TMeshIO>
class MeshIOFactoryOf : public ObjectFactoryBase
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(MeshIOFactoryOf);

  const char *
  GetITKSourceVersion() const override
  {
    return ITK_SOURCE_VERSION;
  }

  const char *
  GetDescription() const override
  {
    return "Mesh IOs of MultiMaterialMeshing";
  }

protected:
  /** With the name of the class TMeshIO, "itk" in front. */
  explicit MeshIOFactoryOf(const char * name)
  {
    this->RegisterOverride("itkMeshIOBase", name, "Mesh IO with labels", true, CreateObjectFunction<TMeshIO>::New());
  }
  ~MeshIOFactoryOf() override = default;
};
} // end namespace itk

#endif
