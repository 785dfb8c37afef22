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
#include "itk/LabelIslands.h"

#include "image/Islands.h"
#include "itk/Labels.h"

#include "itkConnectedComponentFunctorImageFilter.h"

#include <algorithm>
#include <cstdint>
#include <set>

namespace mmm
{
namespace
{
/** Whether two voxels have the same label. itk::Functor::SimilarPixelsFunctor computes a difference, which overflows.
 */
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
  operator()(int a, int b) const
  {
    return a == b;
  }
};

void
MergeExteriorLabels(const std::vector<int> &      exteriorLabels,
                    LabelImage *                  labels,
                    std::map<int, IslandRecord> & records,
                    std::vector<int> &            absentLabels)
{
  for (const auto & entry : CountLabels(labels))
  {
    records[entry.first].voxelsBefore = entry.second;
  }
  std::vector<int> present;
  for (const auto label : exteriorLabels)
  {
    (records.count(label) ? present : absentLabels).push_back(label);
  }
  const std::set<int> merged(present.begin(), present.end());
  int *               out = labels->GetBufferPointer();
  ForEachRun(labels, [&](int label, std::size_t count) {
    out = std::fill_n(out, count, merged.count(label) ? present.front() : label);
  });
}

void
MergeSmallComponents(std::size_t                   minimumSize,
                     LabelImage *                  labels,
                     std::map<int, IslandRecord> & records,
                     FilterMonitor &               monitor)
{
  using NumberImage = itk::Image<std::uint32_t, 3>;
  using ComponentFilter = itk::ConnectedComponentFunctorImageFilter<LabelImage, NumberImage, SameLabel>;

  // not connected to the filter whose output this may be, with the same pixels
  const auto merged = LabelImage::New();
  merged->Graft(labels);
  const auto filter = ComponentFilter::New();
  filter->SetInput(merged);
  monitor.Observe(filter);
  filter->Update();
  const auto * numbers = filter->GetOutput()->GetBufferPointer();
  const auto   voxels = labels->GetLargestPossibleRegion().GetNumberOfPixels();

  std::vector<LabelComponent> components(std::size_t(*std::max_element(numbers, numbers + voxels)) + 1);
  int * const                 pixels = labels->GetBufferPointer();
  for (std::size_t voxel = 0; voxel < voxels; ++voxel)
  {
    auto & component = components[numbers[voxel]];
    component.label = pixels[voxel];
    ++component.voxels;
  }
  const auto & size = labels->GetLargestPossibleRegion().GetSize();
  const Index  gridSize{ { static_cast<int>(size[0]), static_cast<int>(size[1]), static_cast<int>(size[2]) } };
  const auto   newLabels = MergeIslands(gridSize, numbers, components, minimumSize);

  for (std::size_t c = 0; c < components.size(); ++c)
  {
    if (newLabels[c] != components[c].label)
    {
      auto & record = records[components[c].label];
      ++record.components;
      record.voxels += components[c].voxels;
      record.destinations[newLabels[c]] += components[c].voxels;
    }
  }
  for (std::size_t voxel = 0; voxel < voxels; ++voxel)
  {
    pixels[voxel] = newLabels[numbers[voxel]];
  }
}
} // namespace

void
MergeLabelIslands(const std::vector<int> &      exteriorLabels,
                  std::size_t                   minimumIslandSize,
                  LabelImage *                  labels,
                  std::map<int, IslandRecord> & records,
                  std::vector<int> &            absentLabels,
                  FilterMonitor &               monitor)
{
  records.clear();
  absentLabels.clear();
  MergeExteriorLabels(exteriorLabels, labels, records, absentLabels);
  if (minimumIslandSize > 1)
  {
    MergeSmallComponents(minimumIslandSize, labels, records, monitor);
  }
  ForEachRun(labels, [&](int label, std::size_t count) { records[label].voxelsAfter += count; });
}

void
MergeLabelIslands(itk::ProcessObject *          filter,
                  const std::vector<int> &      exteriorLabels,
                  std::size_t                   minimumIslandSize,
                  LabelImage *                  labels,
                  std::map<int, IslandRecord> & records,
                  std::vector<int> &            absentLabels)
{
  RunStage(filter, "merging of islands", [&](FilterMonitor & monitor) {
    MergeLabelIslands(exteriorLabels, minimumIslandSize, labels, records, absentLabels, monitor);
    monitor.Report(1.0);
  });
}
} // namespace mmm
