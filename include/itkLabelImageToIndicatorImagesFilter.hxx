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
#ifndef itkLabelImageToIndicatorImagesFilter_hxx
#define itkLabelImageToIndicatorImagesFilter_hxx

#include "itkPrintHelper.h"

#include <algorithm>
#include <cmath>

namespace itk
{
template <typename TLabelImage, typename TIndicatorImage>
TIndicatorImage *
LabelImageToIndicatorImagesFilter<TLabelImage, TIndicatorImage>::GetOutputForLabel(LabelType label)
{
  const auto place = std::lower_bound(m_Labels.begin(), m_Labels.end(), label);
  if (place == m_Labels.end() || *place != label)
  {
    itkExceptionMacro("The image has no label " << label << '.');
  }
  return this->GetOutput(static_cast<unsigned int>(place - m_Labels.begin()));
}

template <typename TLabelImage, typename TIndicatorImage>
void
LabelImageToIndicatorImagesFilter<TLabelImage, TIndicatorImage>::VerifyPreconditions() const
{
  Superclass::VerifyPreconditions();
  if (m_Radius < 0.0 || std::isinf(m_Radius))
  {
    itkExceptionMacro("The radius is " << m_Radius << " mm. It must be finite and not negative.");
  }
}

template <typename TLabelImage, typename TIndicatorImage>
void
LabelImageToIndicatorImagesFilter<TLabelImage, TIndicatorImage>::GenerateOutputInformation()
{
  const TLabelImage * input = this->GetInput();
  if (input == nullptr)
  {
    return;
  }
  m_BandWidth = mmm::IndicatorBandWidthOf(input);
  const bool areRegionsKnown = m_CropToBand && m_RegionsTime > std::max(input->GetMTime(), input->GetPipelineMTime());
  for (unsigned int n = 0; n < this->GetNumberOfIndexedOutputs(); ++n)
  {
    TIndicatorImage * output = this->GetOutput(n);
    output->CopyInformation(input);
    if (areRegionsKnown && n < m_Regions.size())
    {
      output->SetLargestPossibleRegion(m_Regions[n]);
    }
  }
}

template <typename TLabelImage, typename TIndicatorImage>
void
LabelImageToIndicatorImagesFilter<TLabelImage, TIndicatorImage>::GenerateOutputRequestedRegion(DataObject *)
{
  for (std::size_t n = 0; n < this->GetNumberOfIndexedOutputs(); ++n)
  {
    this->ProcessObject::GetOutput(n)->SetRequestedRegionToLargestPossibleRegion();
  }
}

template <typename TLabelImage, typename TIndicatorImage>
void
LabelImageToIndicatorImagesFilter<TLabelImage, TIndicatorImage>::EnlargeOutputRequestedRegion(DataObject * output)
{
  Superclass::EnlargeOutputRequestedRegion(output);
  output->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TLabelImage, typename TIndicatorImage>
void
LabelImageToIndicatorImagesFilter<TLabelImage, TIndicatorImage>::GenerateInputRequestedRegion()
{
  // not that of the superclass: the outputs' regions are not the input's
  if (auto * input = const_cast<TLabelImage *>(this->GetInput()))
  {
    input->SetRequestedRegionToLargestPossibleRegion();
  }
}

template <typename TLabelImage, typename TIndicatorImage>
void
LabelImageToIndicatorImagesFilter<TLabelImage, TIndicatorImage>::GenerateData()
{
  const auto indicators =
    mmm::ComputeIndicatorImages(this, { m_Radius, m_KeepContacts, m_CropToBand }, ToIntegers(this->GetInput()));
  m_Labels = indicators.labels;
  m_Regions.clear();
  this->SetNumberOfIndexedOutputs(m_Labels.size());
  for (std::size_t n = 0; n < m_Labels.size(); ++n)
  {
    if (this->ProcessObject::GetOutput(n) == nullptr)
    {
      this->SetNthOutput(n, this->MakeOutput(n));
    }
    FromFloats(indicators.images[n].GetPointer(), this->GetOutput(static_cast<unsigned int>(n)));
    m_Regions.push_back(indicators.images[n]->GetLargestPossibleRegion());
  }
  m_RegionsTime.Modified();
}

template <typename TLabelImage, typename TIndicatorImage>
void
LabelImageToIndicatorImagesFilter<TLabelImage, TIndicatorImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  using namespace print_helper;
  Superclass::PrintSelf(os, indent);
  os << indent << "Radius: " << m_Radius << std::endl;
  os << indent << "KeepContacts: " << (m_KeepContacts ? "On" : "Off") << std::endl;
  os << indent << "CropToBand: " << (m_CropToBand ? "On" : "Off") << std::endl;
  os << indent << "Labels: " << m_Labels << std::endl;
  os << indent << "BandWidth: " << m_BandWidth << std::endl;
}
} // namespace itk

#endif
