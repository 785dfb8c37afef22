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
#ifndef itkIndicatorImagesToLabelImageFilter_hxx
#define itkIndicatorImagesToLabelImageFilter_hxx

#include "itkPrintHelper.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace itk
{
template <typename TIndicatorImage, typename TLabelImage>
void
IndicatorImagesToLabelImageFilter<TIndicatorImage, TLabelImage>::SetIndicatorLabels(const LabelsType & labels)
{
  if (m_IndicatorLabels != labels)
  {
    m_IndicatorLabels = labels;
    this->Modified();
  }
}

template <typename TIndicatorImage, typename TLabelImage>
void
IndicatorImagesToLabelImageFilter<TIndicatorImage, TLabelImage>::SetExteriorLabels(const LabelsType & labels)
{
  if (m_ExteriorLabels != labels)
  {
    m_ExteriorLabels = labels;
    this->Modified();
  }
}

template <typename TIndicatorImage, typename TLabelImage>
auto
IndicatorImagesToLabelImageFilter<TIndicatorImage, TLabelImage>::GetUsedLabels() const -> LabelsType
{
  LabelsType labels = m_IndicatorLabels;
  if (labels.empty())
  {
    labels.resize(this->GetNumberOfIndexedInputs());
    std::iota(labels.begin(), labels.end(), 1);
  }
  return labels;
}

template <typename TIndicatorImage, typename TLabelImage>
bool
IndicatorImagesToLabelImageFilter<TIndicatorImage, TLabelImage>::IsExterior(LabelType label) const
{
  return std::find(m_ExteriorLabels.begin(), m_ExteriorLabels.end(), label) != m_ExteriorLabels.end();
}

template <typename TIndicatorImage, typename TLabelImage>
bool
IndicatorImagesToLabelImageFilter<TIndicatorImage, TLabelImage>::IsExteriorImplicit() const
{
  const auto labels = this->GetUsedLabels();
  return !m_ExteriorLabels.empty() &&
         std::none_of(labels.begin(), labels.end(), [this](LabelType label) { return this->IsExterior(label); });
}

template <typename TIndicatorImage, typename TLabelImage>
mmm::IndicatorInputs
IndicatorImagesToLabelImageFilter<TIndicatorImage, TLabelImage>::GetFunctions() const
{
  mmm::IndicatorInputs functions;
  for (std::size_t n = 0; n < this->GetNumberOfIndexedInputs(); ++n)
  {
    functions.images.push_back(dynamic_cast<const TIndicatorImage *>(this->ProcessObject::GetInput(n)));
  }
  functions.labels = this->GetUsedLabels();
  return functions;
}

template <typename TIndicatorImage, typename TLabelImage>
std::string
IndicatorImagesToLabelImageFilter<TIndicatorImage, TLabelImage>::NameOf(std::size_t number) const
{
  const auto * const image = this->ProcessObject::GetInput(number);
  const std::string  name = image == nullptr ? "" : image->GetObjectName();
  return "Indicator image " + std::to_string(number + 1) + (name.empty() ? "" : " (" + name + ")");
}

template <typename TIndicatorImage, typename TLabelImage>
void
IndicatorImagesToLabelImageFilter<TIndicatorImage, TLabelImage>::VerifyPreconditions() const
{
  Superclass::VerifyPreconditions();
  const auto images = this->GetFunctions().images;
  for (std::size_t n = 0; n < images.size(); ++n)
  {
    if (images[n] == nullptr)
    {
      itkExceptionMacro(<< this->NameOf(n) << " of " << images.size() << " is missing.");
    }
  }
  const auto labels = this->GetUsedLabels();
  if (labels.size() != images.size())
  {
    itkExceptionMacro("There are " << labels.size() << " labels for " << images.size() << " indicator images.");
  }
  using Limits = NumericTraits<typename TLabelImage::PixelType>;
  std::set<LabelType> distinct;
  for (const auto label : labels)
  {
    if (!distinct.insert(label).second)
    {
      itkExceptionMacro("The label " << label << " is given to more than one indicator image.");
    }
    if (static_cast<double>(label) < static_cast<double>(Limits::NonpositiveMin()) ||
        static_cast<double>(label) > static_cast<double>(Limits::max()))
    {
      itkExceptionMacro("The label " << label << " is beyond the range of the label image's pixels.");
    }
  }
  if (images.size() == 1 && !this->IsExteriorImplicit())
  {
    itkExceptionMacro("There is one indicator image only, and no exterior: nothing borders on anything. Give more "
                      "images, or an exterior label that the image does not have.");
  }
  if (std::all_of(labels.begin(), labels.end(), [this](LabelType label) { return this->IsExterior(label); }))
  {
    itkExceptionMacro("All indicator images are exterior: there is nothing to mesh.");
  }
}

template <typename TIndicatorImage, typename TLabelImage>
void
IndicatorImagesToLabelImageFilter<TIndicatorImage, TLabelImage>::VerifyInputInformation() const
{
  const auto images = this->GetFunctions().images;
  const auto region = images[0]->GetLargestPossibleRegion();
  for (std::size_t n = 1; n < images.size(); ++n)
  {
    if (images[n]->GetLargestPossibleRegion() != region)
    {
      itkExceptionMacro(<< this->NameOf(n) << " has " << images[n]->GetLargestPossibleRegion().GetSize()
                        << " voxels and the first one " << region.GetSize()
                        << ". They must be on the same grid: resample them.");
    }
    if (!mmm::HaveSameGeometry(images[0], images[n]))
    {
      itkExceptionMacro(<< this->NameOf(n)
                        << " differs from the first one in origin, spacing or direction. They must be on the same "
                           "grid: resample them.");
    }
  }
}

template <typename TIndicatorImage, typename TLabelImage>
void
IndicatorImagesToLabelImageFilter<TIndicatorImage, TLabelImage>::GenerateInputRequestedRegion()
{
  for (const auto & name : this->GetInputNames())
  {
    if (auto * input = this->ProcessObject::GetInput(name))
    {
      input->SetRequestedRegionToLargestPossibleRegion();
    }
  }
}

template <typename TIndicatorImage, typename TLabelImage>
void
IndicatorImagesToLabelImageFilter<TIndicatorImage, TLabelImage>::EnlargeOutputRequestedRegion(DataObject * output)
{
  Superclass::EnlargeOutputRequestedRegion(output);
  output->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TIndicatorImage, typename TLabelImage>
void
IndicatorImagesToLabelImageFilter<TIndicatorImage, TLabelImage>::GenerateData()
{
  const auto               functions = this->GetFunctions();
  std::vector<std::string> names;
  for (std::size_t n = 0; n < functions.images.size(); ++n)
  {
    names.push_back(this->NameOf(n));
  }
  const auto labels = mmm::LargestFunctions(functions, m_ExteriorLabels, names);
  this->AllocateOutputs();
  std::transform(labels.begin(), labels.end(), this->GetOutput()->GetBufferPointer(), [](LabelType label) {
    return static_cast<typename TLabelImage::PixelType>(label);
  });
}

template <typename TIndicatorImage, typename TLabelImage>
void
IndicatorImagesToLabelImageFilter<TIndicatorImage, TLabelImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  using namespace print_helper;
  Superclass::PrintSelf(os, indent);
  os << indent << "IndicatorLabels: " << m_IndicatorLabels << std::endl;
  os << indent << "ExteriorLabels: " << m_ExteriorLabels << std::endl;
}
} // namespace itk

#endif
