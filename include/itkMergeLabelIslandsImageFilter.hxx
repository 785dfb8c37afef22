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

#include "itkImageAlgorithm.h"
#include "itkPrintHelper.h"

namespace itk
{
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
  const auto labels = CopyToIntegers(this->GetInput());
  mmm::MergeLabelIslands(this, m_ExteriorLabels, m_MinimumIslandSize, labels, m_Records, m_AbsentExteriorLabels);
  this->AllocateOutputs();
  const auto & region = labels->GetBufferedRegion();
  ImageAlgorithm::Copy(labels.GetPointer(), this->GetOutput(), region, region);
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
