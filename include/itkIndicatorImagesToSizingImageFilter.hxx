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
#ifndef itkIndicatorImagesToSizingImageFilter_hxx
#define itkIndicatorImagesToSizingImageFilter_hxx

#include "itkPrintHelper.h"

#include <numeric>
#include <string>

namespace itk
{
template <typename TIndicatorImage, typename TSizingImage>
void
IndicatorImagesToSizingImageFilter<TIndicatorImage, TSizingImage>::SetLabels(const LabelsType & labels)
{
  if (m_Labels != labels)
  {
    m_Labels = labels;
    this->Modified();
  }
}

template <typename TIndicatorImage, typename TSizingImage>
mmm::IndicatorInputs
IndicatorImagesToSizingImageFilter<TIndicatorImage, TSizingImage>::GetIndicatorInputs() const
{
  mmm::IndicatorInputs inputs;
  for (unsigned int n = 0; n < this->GetNumberOfIndexedInputs(); ++n)
  {
    inputs.images.push_back(this->GetInput(n));
  }
  inputs.labels = m_Labels;
  if (m_Labels.empty())
  {
    inputs.labels.resize(inputs.images.size());
    std::iota(inputs.labels.begin(), inputs.labels.end(), 0);
  }
  inputs.exterior = m_ExteriorIndex;
  return inputs;
}

template <typename TIndicatorImage, typename TSizingImage>
void
IndicatorImagesToSizingImageFilter<TIndicatorImage, TSizingImage>::VerifyPreconditions() const
{
  Superclass::VerifyPreconditions();
  const std::string error = mmm::DescribeError(this->GetIndicatorInputs(), this->GetSizingInputs());
  if (!error.empty())
  {
    itkExceptionMacro(<< error);
  }
}

template <typename TIndicatorImage, typename TSizingImage>
void
IndicatorImagesToSizingImageFilter<TIndicatorImage, TSizingImage>::VerifyInputInformation() const
{
  Superclass::VerifyInputInformation();
  const std::string error = mmm::DescribeGeometryError(this->GetIndicatorInputs(), this->GetSizingInputs());
  if (!error.empty())
  {
    itkExceptionMacro(<< error);
  }
}

template <typename TIndicatorImage, typename TSizingImage>
void
IndicatorImagesToSizingImageFilter<TIndicatorImage, TSizingImage>::GenerateOutputInformation()
{
  Superclass::GenerateOutputInformation();
  this->GetOutput()->SetLargestPossibleRegion(mmm::UnionOfRegions(this->GetIndicatorInputs().images));
}

template <typename TIndicatorImage, typename TSizingImage>
void
IndicatorImagesToSizingImageFilter<TIndicatorImage, TSizingImage>::EnlargeOutputRequestedRegion(DataObject * output)
{
  Superclass::EnlargeOutputRequestedRegion(output);
  output->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TIndicatorImage, typename TSizingImage>
void
IndicatorImagesToSizingImageFilter<TIndicatorImage, TSizingImage>::GenerateInputRequestedRegion()
{
  // not that of the superclass: the inputs' regions are not the output's
  for (const auto & name : this->GetInputNames())
  {
    if (auto * input = this->ProcessObject::GetInput(name))
    {
      input->SetRequestedRegionToLargestPossibleRegion();
    }
  }
}

template <typename TIndicatorImage, typename TSizingImage>
void
IndicatorImagesToSizingImageFilter<TIndicatorImage, TSizingImage>::GenerateData()
{
  const auto sizes = mmm::ComputeSizingImage(this, this->GetIndicatorInputs(), this->GetSizingInputs());
  FromFloats(sizes.GetPointer(), this->GetOutput());
}

template <typename TIndicatorImage, typename TSizingImage>
void
IndicatorImagesToSizingImageFilter<TIndicatorImage, TSizingImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  using namespace print_helper;
  Superclass::PrintSelf(os, indent);
  os << indent << "Labels: " << m_Labels << std::endl;
  os << indent << "ExteriorIndex: " << m_ExteriorIndex << std::endl;
}
} // namespace itk

#endif
