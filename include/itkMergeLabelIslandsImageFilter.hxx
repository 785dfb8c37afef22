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
#ifndef itkMergeLabelIslandsImageFilter_hxx
#define itkMergeLabelIslandsImageFilter_hxx

#include "image/Islands.h"
#include "itk/Labels.h"

#include "itkConnectedComponentFunctorImageFilter.h"
#include "itkPrintHelper.h"
#include "itkProgressAccumulator.h"

#include <algorithm>
#include <cstdint>
#include <set>

namespace itk
{
namespace Functor
{
/** Whether two voxels have the same label. Functor::SimilarPixelsFunctor computes a difference, which overflows. */
template <typename TLabel>
class SameLabel
{
public:
  bool
  operator==(const SameLabel &) const
  {
    return true;
  }
  bool
  operator!=(const SameLabel &) const
  {
    return false;
  }
  bool
  operator()(const TLabel & a, const TLabel & b) const
  {
    return a == b;
  }
};
} // namespace Functor

template <typename TLabelImage>
void
MergeLabelIslandsImageFilter<TLabelImage>::SetExteriorLabels(const LabelsType & labels)
{
  if (m_ExteriorLabels != labels)
  {
    m_ExteriorLabels = labels;
    this->Modified();
  }
}

template <typename TLabelImage>
void
MergeLabelIslandsImageFilter<TLabelImage>::GenerateInputRequestedRegion()
{
  Superclass::GenerateInputRequestedRegion();
  if (auto * input = const_cast<TLabelImage *>(this->GetInput()))
  {
    input->SetRequestedRegionToLargestPossibleRegion();
  }
}

template <typename TLabelImage>
void
MergeLabelIslandsImageFilter<TLabelImage>::EnlargeOutputRequestedRegion(DataObject * output)
{
  Superclass::EnlargeOutputRequestedRegion(output);
  output->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TLabelImage>
void
MergeLabelIslandsImageFilter<TLabelImage>::GenerateData()
{
  m_Records.clear();
  m_AbsentExteriorLabels.clear();
  this->AllocateOutputs();
  this->MergeExteriorLabels();
  if (m_MinimumIslandSize > 1)
  {
    this->MergeSmallComponents();
  }
  mmm::ForEachRun(this->GetOutput(), [this](int label, std::size_t count) { m_Records[label].voxelsAfter += count; });
}

template <typename TLabelImage>
void
MergeLabelIslandsImageFilter<TLabelImage>::MergeExteriorLabels()
{
  for (const auto & entry : mmm::CountLabels(this->GetInput()))
  {
    m_Records[entry.first].voxelsBefore = entry.second;
  }
  LabelsType present;
  for (const auto label : m_ExteriorLabels)
  {
    (m_Records.count(label) ? present : m_AbsentExteriorLabels).push_back(label);
  }
  const std::set<LabelType> merged(present.begin(), present.end());
  auto *                    out = this->GetOutput()->GetBufferPointer();
  mmm::ForEachRun(this->GetInput(), [&](int label, std::size_t count) {
    const LabelType newLabel = merged.count(label) ? present.front() : label;
    out = std::fill_n(out, count, static_cast<typename TLabelImage::PixelType>(newLabel));
  });
}

template <typename TLabelImage>
void
MergeLabelIslandsImageFilter<TLabelImage>::MergeSmallComponents()
{
  using NumberImageType = Image<std::uint32_t, 3>;
  using PixelType = typename TLabelImage::PixelType;
  using ComponentFilterType =
    ConnectedComponentFunctorImageFilter<TLabelImage, NumberImageType, Functor::SameLabel<PixelType>>;

  // a copy that is not connected to this filter, with the same pixels
  TLabelImage * output = this->GetOutput();
  const auto    merged = TLabelImage::New();
  merged->Graft(output);

  const auto progress = ProgressAccumulator::New();
  progress->SetMiniPipelineFilter(this);
  const auto componentFilter = ComponentFilterType::New();
  componentFilter->SetInput(merged);
  progress->RegisterInternalFilter(componentFilter, 1.0f);
  componentFilter->Update();
  const auto * numbers = componentFilter->GetOutput()->GetBufferPointer();
  const auto   voxels = output->GetLargestPossibleRegion().GetNumberOfPixels();

  std::vector<mmm::LabelComponent> components(std::size_t(*std::max_element(numbers, numbers + voxels)) + 1);
  auto *                           pixels = output->GetBufferPointer();
  for (SizeValueType voxel = 0; voxel < voxels; ++voxel)
  {
    auto & component = components[numbers[voxel]];
    component.label = static_cast<int>(pixels[voxel]);
    ++component.voxels;
  }
  const auto &     size = output->GetLargestPossibleRegion().GetSize();
  const mmm::Index gridSize{ { static_cast<int>(size[0]), static_cast<int>(size[1]), static_cast<int>(size[2]) } };
  const auto       labels = mmm::MergeIslands(gridSize, numbers, components, m_MinimumIslandSize);

  for (std::size_t c = 0; c < components.size(); ++c)
  {
    if (labels[c] != components[c].label)
    {
      auto & record = m_Records[components[c].label];
      ++record.components;
      record.voxels += components[c].voxels;
      record.destinations[labels[c]] += components[c].voxels;
    }
  }
  for (SizeValueType voxel = 0; voxel < voxels; ++voxel)
  {
    pixels[voxel] = static_cast<PixelType>(labels[numbers[voxel]]);
  }
}

template <typename TLabelImage>
void
MergeLabelIslandsImageFilter<TLabelImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  using namespace print_helper;
  Superclass::PrintSelf(os, indent);
  os << indent << "ExteriorLabels: " << m_ExteriorLabels << std::endl;
  os << indent << "MinimumIslandSize: " << m_MinimumIslandSize << std::endl;
  os << indent << "Records:" << std::endl;
  for (const auto & entry : m_Records)
  {
    os << indent.GetNextIndent() << "label " << entry.first << ": " << entry.second.components << " components of "
       << entry.second.voxels << " voxels merged, " << entry.second.voxelsBefore << " voxels before, "
       << entry.second.voxelsAfter << " after" << std::endl;
  }
  os << indent << "AbsentExteriorLabels: " << m_AbsentExteriorLabels << std::endl;
}
} // namespace itk

#endif
