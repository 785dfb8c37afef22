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
#ifndef itkLabelSurfaceMeshFilter_h
#define itkLabelSurfaceMeshFilter_h

#include "itkMultiMaterialMeshCompatibility.h"
#include "itkMultiMaterialMeshTypes.h"
#include "MultiMaterialMeshingExport.h"

#include "itkMeshToMeshFilter.h"

#include <vector>

namespace itk
{
/** \class LabelSurfaceMeshFilter
 * \brief The closed surface of one label or of several as one, from the triangles between all labels.
 *
 * The label inside is the first of the output's cell data, and normals point away from it. Triangles between the labels
 * that count as one are left out, and so are points without triangles.
 *
 * \sa LabelHullMeshFilter
 *
 * \ingroup MultiMaterialMeshing
 */
class MultiMaterialMeshing_EXPORT LabelSurfaceMeshFilter
  : public MeshToMeshFilter<LabelInterfaceMesh, LabelInterfaceMesh>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(LabelSurfaceMeshFilter);

  using Self = LabelSurfaceMeshFilter;
  using Superclass = MeshToMeshFilter<LabelInterfaceMesh, LabelInterfaceMesh>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;
  using LabelsType = std::vector<int>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(LabelSurfaceMeshFilter);

  /** Whose surface to take. Default {1}. */
  void
  SetLabels(const LabelsType & labels);
  const LabelsType &
  GetLabels() const
  {
    return m_Labels;
  }
  void
  SetLabel(int label)
  {
    this->SetLabels({ label });
  }

  /** The labels that have a surface, sorted, but for that of what is not meshed. */
  static LabelsType
  FindLabels(const LabelInterfaceMesh * surface, int outsideLabel);

protected:
  LabelSurfaceMeshFilter() = default;
  ~LabelSurfaceMeshFilter() override = default;

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  LabelsType m_Labels{ 1 };
};
} // end namespace itk

#endif
