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
#include "itk/LabelDomain.h"

#include "itk/ImageRegions.h"
#include "sizing/SizeRule.h"

#include "itkImageRegionConstIterator.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
LabelDomain::LabelDomain(const LabelMeshingInputs & inputs)
  : m_Options(inputs.options)
  , m_Image(inputs.labels)
  , m_Counts(CountLabels(m_Image))
{
  this->VerifyLabels();
  const std::string intensities = DescribeIntensities(m_Image, m_Counts);
  if (!intensities.empty() && !inputs.acceptIntensities)
  {
    itkGenericExceptionMacro("The image " << intensities << '.');
  }
  this->VerifyRegionOfInterest(inputs.sizing.region);
  if (!std::isnan(m_Options.airMargin))
  {
    this->Extend(inputs.meshing.maximumMemory);
  }
  this->VerifyElectrodes(inputs.electrodes);
  this->VerifyLabelSizes(inputs.sizing.options.labelSizes);
}

void
LabelDomain::VerifyLabels() const
{
  if (m_Counts.size() < 2)
  {
    itkGenericExceptionMacro("The label image has a single value"
                             << (m_Counts.empty() ? "" : ", ")
                             << (m_Counts.empty() ? "" : std::to_string(m_Counts.begin()->first))
                             << ": there is nothing to mesh.");
  }
  if (std::all_of(m_Counts.begin(), m_Counts.end(), [this](const LabelCounts::value_type & entry) {
        return this->IsExterior(entry.first);
      }))
  {
    itkGenericExceptionMacro("All labels of the image are exterior: there is nothing to mesh.");
  }
}

void
LabelDomain::VerifyElectrodes(const Electrodes & electrodes) const
{
  for (const auto & entry : NamesOf(electrodes))
  {
    if (m_Counts.count(entry.first) == 0)
    {
      itkGenericExceptionMacro("The electrode of label " << entry.first
                                                         << " is covered by later ones; put it after them.");
    }
  }
}

void
LabelDomain::VerifyLabelSizes(const LabelSizeRules & sizes) const
{
  std::vector<int> labels;
  for (const auto & entry : m_Counts)
  {
    if (!this->IsExterior(entry.first) || entry.first == this->GetExteriorLabel())
    {
      labels.push_back(entry.first);
    }
  }
  const std::string error = DescribeUnknownLabels(sizes, labels);
  if (!error.empty())
  {
    itkGenericExceptionMacro(<< error);
  }
}

void
LabelDomain::VerifyRegionOfInterest(const MaskImage * mask) const
{
  if (mask == nullptr)
  {
    return;
  }
  // electrodes may have made the image larger
  const auto &                              region = mask->GetLargestPossibleRegion();
  itk::ImageRegionConstIterator<LabelImage> label(m_Image, region);
  itk::ImageRegionConstIterator<MaskImage>  inRegion(mask, region);
  for (; !label.IsAtEnd(); ++label, ++inRegion)
  {
    if (inRegion.Get() != 0 && (IsFilled(m_Options) || !this->IsExterior(label.Get())))
    {
      return;
    }
  }
  itkGenericExceptionMacro("No voxel of the region of interest is in what is meshed.");
}

bool
LabelDomain::IsExterior(int label) const
{
  return Contains(m_Options.exteriorLabels, label);
}

int
LabelDomain::GetExteriorLabel() const
{
  const auto & labels = m_Options.exteriorLabels;
  const auto   first = std::find_if(labels.begin(), labels.end(), [this](int label) { return m_Counts.count(label); });
  return first == labels.end() ? labels.front() : *first;
}

void
LabelDomain::Extend(double largestMemory)
{
  const auto box = BoxOf(m_Image.GetPointer(), [this](int label) { return !this->IsExterior(label); });
  const auto region = GrowRegion(box, m_Image->GetSpacing(), m_Options.airMargin);
  this->VerifyMemory(region, largestMemory);
  if (region != m_Image->GetLargestPossibleRegion())
  {
    m_Image = CopyRegion(m_Image.GetPointer(), region, this->GetExteriorLabel());
    m_Counts = CountLabels(m_Image);
  }
}

void
LabelDomain::VerifyMemory(const itk::ImageRegion<3> & region, double limit) const
{
  double voxels = 1.0;
  for (const auto length : region.GetSize())
  {
    voxels *= static_cast<double>(length);
  }
  const double gigabytes = LeastMemory(voxels);
  if (gigabytes > limit)
  {
    itkGenericExceptionMacro("With an air margin of " << m_Options.airMargin << " mm, the image has "
                                                      << DescribeCount(voxels) << " voxels and takes at least "
                                                      << gigabytes << " GB, more than the limit of " << limit
                                                      << " GB. A smaller margin helps.");
  }
}

double
LeastMemory(double voxels)
{
  // labels twice, sizes, distances and materials
  constexpr double bytesPerVoxel = 2 * sizeof(int) + 12;
  return voxels * bytesPerVoxel / (1024.0 * 1024.0 * 1024.0);
}

bool
IsFilled(const LabelOptions & options)
{
  return options.fillExterior || !std::isnan(options.airMargin);
}

bool
Contains(const std::vector<int> & labels, int label)
{
  return std::find(labels.begin(), labels.end(), label) != labels.end();
}
} // namespace mmm
