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

#include "itk/GridGeometry.h"
#include "itk/Labels.h"
#include "base/OutOfMemory.h"
#include "indicators/PassageWidening.h"
#include "indicators/VolumeCorrection.h"

#include "itkPrintHelper.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <string>
#include <vector>

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
LabelImageToIndicatorImagesFilter<TLabelImage, TIndicatorImage>::ReadInput()
{
  constexpr std::size_t maximumNumberOfLabels = 65530; // mmm::Material has room for six more

  const TLabelImage * input = this->GetInput();
  m_Labels.clear();
  for (const auto & entry : mmm::CountLabels(input))
  {
    m_Labels.push_back(entry.first);
  }
  if (m_Labels.size() < 2)
  {
    itkExceptionMacro("The label image has a single value" << (m_Labels.empty() ? "" : ", ")
                                                           << (m_Labels.empty() ? "" : std::to_string(m_Labels[0]))
                                                           << ": there is no interface in it.");
  }
  if (m_Labels.size() > maximumNumberOfLabels)
  {
    itkExceptionMacro("The image has " << m_Labels.size() << " labels. At most " << maximumNumberOfLabels
                                       << " are supported.");
  }
  m_Materials = mmm::MakeMaterialImage(input, m_Labels);
  m_Boxes = mmm::ComputeMaterialBoxes(m_Materials);
}

template <typename TLabelImage, typename TIndicatorImage>
void
LabelImageToIndicatorImagesFilter<TLabelImage, TIndicatorImage>::GenerateOutputInformation()
{
  auto * input = const_cast<TLabelImage *>(this->GetInput());
  if (input == nullptr)
  {
    return;
  }
  // the labels and their boxes depend on the pixels
  input->SetRequestedRegionToLargestPossibleRegion();
  input->Update();
  this->ReadInput();
  m_BandWidth = mmm::IndicatorBandWidth * mmm::GridGeometry(input, input->GetLargestPossibleRegion()).GetUnit();

  this->SetNumberOfIndexedOutputs(m_Labels.size());
  const auto & start = input->GetLargestPossibleRegion().GetIndex();
  for (std::size_t n = 0; n < m_Labels.size(); ++n)
  {
    if (this->GetOutput(static_cast<unsigned int>(n)) == nullptr)
    {
      this->SetNthOutput(n, this->MakeOutput(n));
    }
    auto * output = this->GetOutput(static_cast<unsigned int>(n));
    output->CopyInformation(input);
    if (m_CropToBand)
    {
      const auto box = mmm::ComputeIndicatorBox(m_Materials.grid, m_Boxes[n]);
      RegionType region;
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        region.SetIndex(axis, start[axis] + box.lower[axis]);
        region.SetSize(axis, static_cast<SizeValueType>(box.size[axis]));
      }
      output->SetLargestPossibleRegion(region);
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
try
{
  const TLabelImage * input = this->GetInput();
  if (m_Materials.materials.empty())
  {
    this->ReadInput();
  }
  const mmm::GridGeometry geometry(input, input->GetLargestPossibleRegion());
  const double            radius = std::isnan(m_Radius) ? 0.5 : geometry.ToGridUnit(m_Radius);

  mmm::StageLog      log;
  mmm::FilterMonitor monitor(this, log, { { "indicators", 1.0 } });
  monitor.BeginStage("indicators");
  std::vector<mmm::Block<float>> blocks(m_Labels.size());
  for (std::size_t n = 0; n < m_Labels.size(); ++n)
  {
    blocks[n] = mmm::ComputeSmoothIndicator(m_Materials, static_cast<mmm::Material>(n), m_Boxes[n], radius);
    monitor.Report(static_cast<double>(n + 1) / (m_Labels.size() + 1));
  }
  if (radius > 0.0)
  {
    // what comes last has its way: volumes, unless it is contacts
    if (!m_KeepContacts)
    {
      mmm::WidenPassages(m_Materials.grid, m_KeepContacts, blocks);
    }
    mmm::CorrectVolumes(m_Materials, blocks);
    monitor.Report((m_Labels.size() + 0.5) / (m_Labels.size() + 1));
    if (m_KeepContacts)
    {
      mmm::WidenPassages(m_Materials.grid, m_KeepContacts, blocks);
    }
  }
  for (std::size_t n = 0; n < m_Labels.size(); ++n)
  {
    this->FillOutput(blocks[n], geometry.GetUnit(), this->GetOutput(static_cast<unsigned int>(n)));
    blocks[n] = mmm::Block<float>();
  }
  monitor.Report(1.0);
  m_Materials = mmm::MaterialImage();
  m_Boxes.clear();
}
catch (const std::bad_alloc &)
{
  mmm::ThrowOutOfMemory(std::string(this->GetNameOfClass()));
}

template <typename TLabelImage, typename TIndicatorImage>
void
LabelImageToIndicatorImagesFilter<TLabelImage, TIndicatorImage>::FillOutput(const mmm::Block<float> & block,
                                                                            double                    unit,
                                                                            TIndicatorImage *         output) const
{
  output->SetBufferedRegion(output->GetLargestPossibleRegion());
  output->Allocate();
  if (!m_CropToBand)
  {
    output->FillBuffer(static_cast<float>(-m_BandWidth));
  }
  const auto & start = this->GetInput()->GetLargestPossibleRegion().GetIndex();
  auto         value = block.values.begin();
  for (int k = 0; k < block.size[2]; ++k)
  {
    for (int j = 0; j < block.size[1]; ++j)
    {
      const typename TIndicatorImage::IndexType rowStart{
        { start[0] + block.lower[0], start[1] + block.lower[1] + j, start[2] + block.lower[2] + k }
      };
      float * row = output->GetBufferPointer() + output->ComputeOffset(rowStart);
      for (int i = 0; i < block.size[0]; ++i)
      {
        *row++ = static_cast<float>(*value++ * unit);
      }
    }
  }
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
