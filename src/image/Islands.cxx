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
#include "image/Islands.h"

#include "image/Threads.h"

#include <algorithm>
#include <map>

namespace mmm
{
namespace
{
/** A face between a voxel of an island and one of another label. */
struct Vote
{
  std::uint32_t island;
  int           label;

  friend bool
  operator<(const Vote & a, const Vote & b)
  {
    return a.island != b.island ? a.island < b.island : a.label < b.label;
  }
};

/** Per label the component that stays. */
std::map<int, std::uint32_t>
FindLargest(std::size_t voxels, const std::uint32_t * numbers, const std::vector<LabelComponent> & components)
{
  std::map<int, std::uint32_t> largest;
  std::vector<char>            isSeen(components.size(), 0);
  for (std::size_t voxel = 0; voxel < voxels; ++voxel)
  {
    const auto number = numbers[voxel];
    if (!isSeen[number])
    {
      isSeen[number] = 1;
      const auto entry = largest.insert({ components[number].label, number });
      if (components[number].voxels > components[entry.first->second].voxels)
      {
        entry.first->second = number;
      }
    }
  }
  return largest;
}

std::vector<Vote>
CollectVotes(const Index &                       size,
             const std::uint32_t *               numbers,
             const std::vector<LabelComponent> & components,
             const std::vector<char> &           isIsland)
{
  const std::ptrdiff_t strides[3] = { 1, size[0], std::ptrdiff_t(size[0]) * size[1] };
  std::vector<Vote>    votes;
  std::size_t          voxel = 0;
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i, ++voxel)
      {
        const auto number = numbers[voxel];
        if (!isIsland[number])
        {
          continue;
        }
        const int at[3] = { i, j, k };
        for (int axis = 0; axis < 3; ++axis)
        {
          for (const int step : { -1, 1 })
          {
            if (at[axis] + step >= 0 && at[axis] + step < size[axis])
            {
              const int label = components[numbers[std::ptrdiff_t(voxel) + step * strides[axis]]].label;
              if (label != components[number].label)
              {
                votes.push_back({ number, label });
              }
            }
          }
        }
      }
    }
  }
  std::sort(votes.begin(), votes.end());
  return votes;
}
} // namespace

std::vector<int>
MergeIslands(const Index &                       size,
             const std::uint32_t *               numbers,
             const std::vector<LabelComponent> & components,
             std::size_t                         minimumSize)
{
  std::vector<int>  labels(components.size());
  std::vector<char> isIsland(components.size());
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    labels[c] = components[c].label;
    isIsland[c] = components[c].voxels < minimumSize;
  }
  const std::size_t voxels = std::size_t(size[0]) * size[1] * size[2];
  for (const auto & entry : FindLargest(voxels, numbers, components))
  {
    isIsland[entry.second] = 0;
  }
  KeepThreads(size, numbers, components, minimumSize, isIsland);

  const auto votes = CollectVotes(size, numbers, components, isIsland);
  for (auto first = votes.begin(); first != votes.end();)
  {
    const auto     island = first->island;
    std::ptrdiff_t most = 0;
    while (first != votes.end() && first->island == island)
    {
      const auto last = std::upper_bound(first, votes.end(), *first);
      if (last - first > most)
      {
        most = last - first;
        labels[island] = first->label;
      }
      first = last;
    }
  }
  return labels;
}
} // namespace mmm
