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
#include "itk/Labels.h"

#include "itk/GridGeometry.h"

#include "itkMacro.h"

#include <algorithm>
#include <sstream>

namespace mmm
{
LabelCounts
CountLabels(const LabelImage * image)
{
  LabelCounts counts;
  auto        last = counts.end();
  ForEachRun(image, [&](int label, std::size_t count) {
    if (last == counts.end() || last->first != label)
    {
      last = counts.insert({ label, 0 }).first;
    }
    last->second += count;
  });
  return counts;
}

std::string
DescribeIntensities(const LabelImage * image, const LabelCounts & counts)
{
  // Fewer values than these are a label image, however noisy.
  constexpr std::size_t minimumIntensities = 33;
  // Half of the neighbours on a row differ in an intensity image; one in ten do in a fine atlas.
  constexpr double maximumChangeRate = 0.5;

  if (counts.size() < minimumIntensities)
  {
    return {};
  }
  const auto background =
    std::max_element(counts.begin(), counts.end(), [](const auto & a, const auto & b) { return a.second < b.second; });
  // neighbours along the buffer, but for those in the background
  std::size_t pairs = 0;
  std::size_t changes = 0;
  int         last = background->first;
  ForEachRun(image, [&](int label, std::size_t count) {
    const bool isChange = label != last;
    const bool isBackground = label == background->first;
    pairs += (isChange || !isBackground) + (isBackground ? 0 : count - 1);
    changes += isChange;
    last = label;
  });
  if (static_cast<double>(changes) <= maximumChangeRate * static_cast<double>(pairs))
  {
    return {};
  }
  std::ostringstream text;
  text << "has " << counts.size() << " values, from " << counts.begin()->first << " to " << counts.rbegin()->first
       << " that change from voxel to voxel, and looks like an intensity image; segment it first";
  return text.str();
}

std::vector<int>
LabelsOf(const LabelImage * image)
{
  constexpr std::size_t MostLabels = 65530; // Material has room for six more
  std::vector<int>      labels;
  for (const auto & entry : CountLabels(image))
  {
    labels.push_back(entry.first);
  }
  if (labels.size() < 2)
  {
    itkGenericExceptionMacro("The label image has a single value" << (labels.empty() ? "" : ", ")
                                                                  << (labels.empty() ? "" : std::to_string(labels[0]))
                                                                  << ": there is no interface in it.");
  }
  if (labels.size() > MostLabels)
  {
    itkGenericExceptionMacro("The image has " << labels.size() << " labels. At most " << MostLabels
                                              << " are supported.");
  }
  return labels;
}

MaterialImage
MakeMaterialImage(const LabelImage * image, const std::vector<int> & labels)
{
  MaterialImage materials;
  materials.grid = GridGeometry(image, image->GetLargestPossibleRegion()).GetGrid();
  materials.numberOfMaterials = labels.size();
  materials.materials.reserve(materials.grid.NumberOfNodes());
  ForEachRun(image, [&](int label, std::size_t count) {
    const auto place = std::lower_bound(labels.begin(), labels.end(), label) - labels.begin();
    materials.materials.insert(materials.materials.end(), count, static_cast<Material>(place));
  });
  return materials;
}
} // namespace mmm
