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

#include "itk/FilterMonitor.h"
#include "itk/IndicatorImages.h"
#include "base/OutOfMemory.h"
#include "itk/SizingImage.h"

#include "itkPrintHelper.h"

#include <algorithm>
#include <new>
#include <numeric>
#include <string>

namespace itk
{
template <typename TIndicatorImage, typename TSizingImage>
IndicatorImagesToSizingImageFilter<TIndicatorImage, TSizingImage>::IndicatorImagesToSizingImageFilter()
{
  this->AddOptionalInputName("SizingImage");
  this->AddOptionalInputName("RegionOfInterest");
}

template <typename TIndicatorImage, typename TSizingImage>
void
IndicatorImagesToSizingImageFilter<TIndicatorImage, TSizingImage>::SetSizingImage(const TSizingImage * image)
{
  this->ProcessObject::SetInput("SizingImage", const_cast<TSizingImage *>(image));
}

template <typename TIndicatorImage, typename TSizingImage>
const TSizingImage *
IndicatorImagesToSizingImageFilter<TIndicatorImage, TSizingImage>::GetSizingImage() const
{
  return dynamic_cast<const TSizingImage *>(this->ProcessObject::GetInput("SizingImage"));
}

template <typename TIndicatorImage, typename TSizingImage>
void
IndicatorImagesToSizingImageFilter<TIndicatorImage, TSizingImage>::SetRegionOfInterest(const MaskImageType * mask)
{
  this->ProcessObject::SetInput("RegionOfInterest", const_cast<MaskImageType *>(mask));
}

template <typename TIndicatorImage, typename TSizingImage>
auto
IndicatorImagesToSizingImageFilter<TIndicatorImage, TSizingImage>::GetRegionOfInterest() const -> const MaskImageType *
{
  return dynamic_cast<const MaskImageType *>(this->ProcessObject::GetInput("RegionOfInterest"));
}

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
void
IndicatorImagesToSizingImageFilter<TIndicatorImage, TSizingImage>::SetLabelSizes(const LabelSizesType & sizes)
{
  m_LabelSizes = sizes;
  this->Modified();
}

template <typename TIndicatorImage, typename TSizingImage>
void
IndicatorImagesToSizingImageFilter<TIndicatorImage, TSizingImage>::SetLabelSizes(const std::string & text)
{
  this->SetLabelSizes(mmm::ParseLabelSizeRules(text));
}

template <typename TIndicatorImage, typename TSizingImage>
mmm::SizingOptions
IndicatorImagesToSizingImageFilter<TIndicatorImage, TSizingImage>::GetOptions() const
{
  mmm::SizingOptions options;
  options.epsilon = m_Epsilon;
  options.chordTolerance = m_ChordTolerance;
  options.gradientLimit = m_GradientLimit;
  options.minimumSize = m_MinimumSize;
  options.maximumSize = m_MaximumSize;
  options.maximumVolume = m_MaximumVolume;
  options.labelSizes = m_LabelSizes;
  options.region.minimumSize = m_RegionMinimumSize;
  options.region.maximumSize = m_RegionMaximumSize;
  return options;
}

template <typename TIndicatorImage, typename TSizingImage>
auto
IndicatorImagesToSizingImageFilter<TIndicatorImage, TSizingImage>::GetInputLabels() const -> LabelsType
{
  LabelsType labels = m_Labels;
  if (labels.empty())
  {
    labels.resize(this->GetNumberOfIndexedInputs());
    std::iota(labels.begin(), labels.end(), 0);
  }
  return labels;
}

template <typename TIndicatorImage, typename TSizingImage>
std::vector<const TIndicatorImage *>
IndicatorImagesToSizingImageFilter<TIndicatorImage, TSizingImage>::GetIndicatorImages() const
{
  std::vector<const TIndicatorImage *> images(this->GetNumberOfIndexedInputs());
  for (std::size_t n = 0; n < images.size(); ++n)
  {
    images[n] = this->GetInput(static_cast<unsigned int>(n));
  }
  return images;
}

template <typename TIndicatorImage, typename TSizingImage>
void
IndicatorImagesToSizingImageFilter<TIndicatorImage, TSizingImage>::VerifyPreconditions() const
{
  Superclass::VerifyPreconditions();
  const auto images = this->GetIndicatorImages();
  for (std::size_t n = 0; n < images.size(); ++n)
  {
    if (images[n] == nullptr)
    {
      itkExceptionMacro("Input " << n << " of " << images.size() << " is missing.");
    }
  }
  if (m_ExteriorIndex < -1 || m_ExteriorIndex >= static_cast<int>(images.size()))
  {
    itkExceptionMacro("ExteriorIndex is " << m_ExteriorIndex << ", but there are " << images.size()
                                          << " indicator images.");
  }
  if (m_ExteriorIndex == 0 && images.size() == 1)
  {
    itkExceptionMacro("There is nothing but exterior.");
  }
  if (!m_Labels.empty() && m_Labels.size() != images.size())
  {
    itkExceptionMacro("There are " << m_Labels.size() << " labels for " << images.size() << " indicator images.");
  }
  if (m_SizingImageReplaces && this->GetSizingImage() == nullptr)
  {
    itkExceptionMacro("There is no sizing image to stand in place of the computed sizes.");
  }
  for (const std::string & error : { mmm::DescribeError(this->GetOptions(), this->GetRegionOfInterest() != nullptr),
                                     mmm::DescribeUnknownLabels(m_LabelSizes, this->GetInputLabels()) })
  {
    if (!error.empty())
    {
      itkExceptionMacro(<< error);
    }
  }
}

template <typename TIndicatorImage, typename TSizingImage>
void
IndicatorImagesToSizingImageFilter<TIndicatorImage, TSizingImage>::VerifyInputInformation() const
{
  Superclass::VerifyInputInformation();
  const mmm::IndicatorImages<TIndicatorImage> indicators(this->GetIndicatorImages());
  const TSizingImage *                        sizes = this->GetSizingImage();
  if (sizes && sizes->GetLargestPossibleRegion() != indicators.GetRegion())
  {
    itkExceptionMacro("The sizing image covers " << sizes->GetLargestPossibleRegion()
                                                 << " and the indicator images together " << indicators.GetRegion()
                                                 << ". They must be the same.");
  }
  const MaskImageType * mask = this->GetRegionOfInterest();
  if (mask && mask->GetLargestPossibleRegion() != indicators.GetRegion())
  {
    itkExceptionMacro("The region of interest covers " << mask->GetLargestPossibleRegion()
                                                       << " and the indicator images together "
                                                       << indicators.GetRegion() << ". They must be the same.");
  }
}

template <typename TIndicatorImage, typename TSizingImage>
void
IndicatorImagesToSizingImageFilter<TIndicatorImage, TSizingImage>::GenerateOutputInformation()
{
  Superclass::GenerateOutputInformation();
  this->GetOutput()->SetLargestPossibleRegion(
    mmm::IndicatorImages<TIndicatorImage>(this->GetIndicatorImages()).GetRegion());
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
try
{
  this->AllocateOutputs();
  const mmm::IndicatorImages<TIndicatorImage> images(this->GetIndicatorImages());
  const mmm::GridGeometry &                   geometry = images.GetGeometry();

  mmm::StageLog      log;
  mmm::FilterMonitor monitor(this, log, { { "sizing", 1.0 } });
  monitor.BeginStage("sizing");
  const mmm::IndicatorSet indicators = images.MakeIndicatorSet();
  const auto              sizing = mmm::ComputeSizing(indicators,
                                         m_ExteriorIndex,
                                         mmm::ToGridUnit(this->GetOptions(), geometry),
                                         this->MakeControl(geometry, indicators),
                                         monitor);

  using SizeType = typename TSizingImage::PixelType;
  std::transform(sizing.begin(), sizing.end(), this->GetOutput()->GetBufferPointer(), [&](float size) {
    return static_cast<SizeType>(size * geometry.GetUnit());
  });
}
catch (const std::bad_alloc &)
{
  mmm::ThrowOutOfMemory(std::string(this->GetNameOfClass()));
}

template <typename TIndicatorImage, typename TSizingImage>
mmm::SizingControl
IndicatorImagesToSizingImageFilter<TIndicatorImage, TSizingImage>::MakeControl(
  const mmm::GridGeometry & geometry,
  const mmm::IndicatorSet & indicators) const
{
  mmm::SizingControl control;
  if (const auto * sizes = this->GetSizingImage())
  {
    control.image = mmm::ReadSizingImage(sizes, geometry);
    control.imageReplaces = m_SizingImageReplaces;
  }
  const auto options = this->GetOptions();
  if (const auto * mask = this->GetRegionOfInterest())
  {
    control.region = mmm::ReadMask(mask);
    control.regionRule = mmm::ToGridUnit(options.region, geometry);
    if (!mmm::IsInMaterials(control.region, indicators, m_ExteriorIndex))
    {
      itkExceptionMacro("No voxel of the region of interest is in what is meshed.");
    }
  }
  if (!m_LabelSizes.empty())
  {
    for (const auto label : this->GetInputLabels())
    {
      const auto rule = m_LabelSizes.find(label);
      control.materials.push_back(rule == m_LabelSizes.end() ? mmm::SizeRule()
                                                             : mmm::ToGridUnit(rule->second, geometry));
    }
  }
  return control;
}

template <typename TIndicatorImage, typename TSizingImage>
void
IndicatorImagesToSizingImageFilter<TIndicatorImage, TSizingImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  using namespace print_helper;
  Superclass::PrintSelf(os, indent);
  os << indent << "Epsilon: " << m_Epsilon << std::endl;
  os << indent << "ChordTolerance: " << m_ChordTolerance << std::endl;
  os << indent << "GradientLimit: " << m_GradientLimit << std::endl;
  os << indent << "MinimumSize: " << m_MinimumSize << std::endl;
  os << indent << "MaximumSize: " << m_MaximumSize << std::endl;
  os << indent << "MaximumVolume: " << m_MaximumVolume << std::endl;
  os << indent << "Labels: " << m_Labels << std::endl;
  os << indent << "LabelSizes: " << mmm::ToText(m_LabelSizes) << std::endl;
  os << indent << "SizingImageReplaces: " << (m_SizingImageReplaces ? "On" : "Off") << std::endl;
  os << indent << "RegionMinimumSize: " << m_RegionMinimumSize << std::endl;
  os << indent << "RegionMaximumSize: " << m_RegionMaximumSize << std::endl;
  os << indent << "ExteriorIndex: " << m_ExteriorIndex << std::endl;
}
} // namespace itk

#endif
