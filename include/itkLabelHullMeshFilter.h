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
#ifndef itkLabelHullMeshFilter_h
#define itkLabelHullMeshFilter_h

#include "itkMultiMaterialMeshCompatibility.h"
#include "itkMultiMaterialMeshTypes.h"
#include "MultiMaterialMeshingExport.h"

#include "itkMeshToMeshFilter.h"

#include <vector>

namespace itk
{
/** \class LabelHullMeshFilter
 * \brief The outer surface of several labels together, from the triangles between all labels: for boundary elements.
 *
 * The hull is the closed surface around the largest part of what the labels fill. Cavities in it, and whatever is in
 * these, are left out; so are the triangles between the labels. Other parts beside the largest one are left out as
 * well, and counted. Normals point outward; the first of the output's cell data is the label inside.
 *
 * Counts tell whether the hull is a manifold, and how many handles it has. It is made of the input's triangles, so that
 * hulls of labels within others touch only where the labels do.
 *
 * \sa LabelSurfaceMeshFilter
 * \ingroup MultiMaterialMeshing
 */
class MultiMaterialMeshing_EXPORT LabelHullMeshFilter : public MeshToMeshFilter<LabelInterfaceMesh, LabelInterfaceMesh>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(LabelHullMeshFilter);

  using Self = LabelHullMeshFilter;
  using Superclass = MeshToMeshFilter<LabelInterfaceMesh, LabelInterfaceMesh>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;
  using LabelsType = std::vector<int>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(LabelHullMeshFilter);

  /** What is inside. Default {1}. */
  void
  SetLabels(const LabelsType & labels);
  const LabelsType &
  GetLabels() const
  {
    return m_Labels;
  }

  /** Parts of the labels that are left out, as they lie beside the hull. */
  itkGetConstMacro(NumberOfOtherParts, SizeValueType);

  /** Edges of the hull with more than two triangles. */
  itkGetConstMacro(NumberOfPinchedEdges, SizeValueType);

  /** Points of the hull whose triangles do not all hang together by edges. */
  itkGetConstMacro(NumberOfPinchedPoints, SizeValueType);

  /** A ring has one handle, a ball none. Not counted (0) where there are pinched edges or points. */
  itkGetConstMacro(NumberOfHandles, SizeValueType);

protected:
  LabelHullMeshFilter() = default;
  ~LabelHullMeshFilter() override = default;

  /** Throws an ExceptionObject if none of the labels has a surface. */
  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  LabelsType    m_Labels{ 1 };
  SizeValueType m_NumberOfOtherParts{ 0 };
  SizeValueType m_NumberOfPinchedEdges{ 0 };
  SizeValueType m_NumberOfPinchedPoints{ 0 };
  SizeValueType m_NumberOfHandles{ 0 };
};
} // end namespace itk

#endif
