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
#ifndef itkIndicatorImagesToTetrahedralMeshFilter_hxx
#define itkIndicatorImagesToTetrahedralMeshFilter_hxx

#include <cmath>

namespace itk
{
template <typename TIndicatorImage, typename TOutputMesh>
IndicatorImagesToTetrahedralMeshFilter<TIndicatorImage, TOutputMesh>::IndicatorImagesToTetrahedralMeshFilter()
  : m_LabelFilter(LabelFilterType::New())
{
  Superclass::SetInput(m_LabelFilter->GetOutput());
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToTetrahedralMeshFilter<TIndicatorImage, TOutputMesh>::SetInput(unsigned int            number,
                                                                               const TIndicatorImage * image)
{
  m_LabelFilter->SetInput(number, image);
  // input 0 is the label image
  this->ProcessObject::SetNthInput(number + 1, const_cast<TIndicatorImage *>(image));
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToTetrahedralMeshFilter<TIndicatorImage, TOutputMesh>::SetIndicatorLabels(const LabelsType & labels)
{
  m_LabelFilter->SetIndicatorLabels(labels);
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToTetrahedralMeshFilter<TIndicatorImage, TOutputMesh>::SetExteriorLabels(const LabelsType & labels)
{
  Superclass::SetExteriorLabels(labels);
  m_LabelFilter->SetExteriorLabels(labels);
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToTetrahedralMeshFilter<TIndicatorImage, TOutputMesh>::VerifyPreconditions() const
{
  Superclass::VerifyPreconditions();
  if (!std::isnan(this->GetAirMargin()))
  {
    itkExceptionMacro("An air margin of " << this->GetAirMargin()
                                          << " mm would need the indicators beyond their images. FillExterior meshes "
                                             "the exterior up to the faces of the images' box.");
  }
  if (!this->GetSurfaceLabels().empty())
  {
    itkExceptionMacro(
      "Surfaces go on top of a label image. Among indicator images, the signed distance of a surface is "
      "one as well.");
  }
}

template <typename TIndicatorImage, typename TOutputMesh>
mmm::IndicatorInputs
IndicatorImagesToTetrahedralMeshFilter<TIndicatorImage, TOutputMesh>::GetFunctions() const
{
  mmm::IndicatorInputs functions;
  functions.labels = m_LabelFilter->GetUsedLabels();
  for (unsigned int n = 0; n < functions.labels.size(); ++n)
  {
    functions.images.push_back(m_LabelFilter->GetInput(n));
  }
  return functions;
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToTetrahedralMeshFilter<TIndicatorImage, TOutputMesh>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  itkPrintSelfObjectMacro(LabelFilter);
}
} // namespace itk

#endif
