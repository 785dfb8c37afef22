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
#ifndef itkMeditMeshIO_h
#define itkMeditMeshIO_h

#include "itkGroupedMeshIOBase.h"

#include <limits>

namespace itk
{
/** \class MeditMeshIO
 * \brief Reads and writes meshes as Medit files (`.mesh`), which are text, with labels as references.
 *
 * A reference is any int. Labels beyond that, and pairs of labels, are numbered anew; comments in the file say which
 * they are: "# group 2 1: labels 0 2". Cells are written in the order of their shapes: lines, triangles,
 * quadrilaterals, tetrahedra, hexahedra, and of each in the order of the mesh. The format has no vertices as cells. See
 * GroupedMeshIOBase for the rest.
 *
 * \ingroup IOFilters
 * \ingroup MultiMaterialMeshing
 */
class MultiMaterialMeshing_EXPORT MeditMeshIO : public GroupedMeshIOBase
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(MeditMeshIO);

  /** Standard class type aliases. */
  using Self = MeditMeshIO;
  using Superclass = GroupedMeshIOBase;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  /** Method for creation through the object factory. */
  itkNewMacro(Self);

  /** \see LightObject::GetNameOfClass() */
  itkOverrideGetNameOfClassMacro(MeditMeshIO);

protected:
  MeditMeshIO();
  ~MeditMeshIO() override;

  void
  ReadFile(mmm::CellMesh & mesh) override;
  void
  WriteFile(const mmm::CellMesh & mesh) override;

  int
  GetLowestGroup() const override
  {
    return std::numeric_limits<int>::min();
  }

  bool
  HasCellsWithoutGroup() const override
  {
    return false;
  }
};
} // end namespace itk

#endif
