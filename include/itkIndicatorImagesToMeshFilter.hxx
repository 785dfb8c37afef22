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
#ifndef itkIndicatorImagesToMeshFilter_hxx
#define itkIndicatorImagesToMeshFilter_hxx

#include "itkPrintHelper.h"

#include <string>

namespace itk
{
template <typename TIndicatorImage, typename TOutputMesh>
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::IndicatorImagesToMeshFilter()
{
  this->AddRequiredInputName("SizingImage");
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::SetLabels(const LabelsType & labels)
{
  if (m_Labels != labels)
  {
    m_Labels = labels;
    this->Modified();
  }
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::SetSizingImage(const SizingImageType * image)
{
  this->ProcessObject::SetInput("SizingImage", const_cast<SizingImageType *>(image));
}

template <typename TIndicatorImage, typename TOutputMesh>
auto
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::GetSizingImage() const -> const SizingImageType *
{
  return dynamic_cast<const SizingImageType *>(this->ProcessObject::GetInput("SizingImage"));
}

template <typename TIndicatorImage, typename TOutputMesh>
mmm::MeshingInputs
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::GetInputs() const
{
  mmm::MeshingInputs inputs;
  for (std::size_t n = 0; n < this->GetNumberOfIndexedInputs(); ++n)
  {
    inputs.indicators.images.push_back(dynamic_cast<const TIndicatorImage *>(this->ProcessObject::GetInput(n)));
  }
  inputs.indicators.labels = m_Labels;
  inputs.indicators.exterior = m_ExteriorIndex;
  inputs.sizing = this->GetSizingImage();
  inputs.options = this->GetMeshingOptions();
  inputs.outsideLabel = m_OutsideLabel;
  inputs.keepTopology = m_KeepTopology;
  inputs.reference = m_ReferenceImage;
  return inputs;
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::VerifyPreconditions() const
{
  Superclass::VerifyPreconditions();
  const std::string error = mmm::DescribeError(this->GetInputs());
  if (!error.empty())
  {
    itkExceptionMacro(<< error);
  }
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::VerifyInputInformation() const
{
  const std::string error = mmm::DescribeGeometryError(this->GetInputs());
  if (!error.empty())
  {
    itkExceptionMacro(<< error);
  }
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::GenerateData()
{
  mmm::MeshIndicators(
    this,
    this->GetInputs(),
    [this] { this->ReleaseInputs(); }, // where they ask for it
    this->GetMeshingOutputs(),
    this->m_State);
  this->Warn();
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::PrintSelf(std::ostream & os, Indent indent) const
{
  using namespace print_helper;
  Superclass::PrintSelf(os, indent);
  os << indent << "Labels: " << m_Labels << std::endl;
  os << indent << "ExteriorIndex: " << m_ExteriorIndex << std::endl;
  os << indent << "OutsideLabel: " << m_OutsideLabel << std::endl;
  os << indent << "KeepTopology: " << (m_KeepTopology ? "On" : "Off") << std::endl;
  itkPrintSelfObjectMacro(ReferenceImage);
  os << indent << "UsedOutsideLabel: " << this->GetUsedOutsideLabel() << std::endl;
}
} // namespace itk

#endif
