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
#include "image/Threads.h"

#include "base/DisjointSets.h"
#include "base/IndexBox.h"

#include <algorithm>
#include <map>
#include <set>

namespace mmm
{
namespace
{
/** A label that would lose more than this share of its voxels is thin all over. */
constexpr double LargestLoss = 0.05;
/** Voxels of a thread for each of its length, at most; what has more is a sheet. */
constexpr std::size_t Thickness = 2;

/** Islands that touch each other. */
struct Chain
{
  Index       lower;
  Index       upper;
  std::size_t voxels{ 0 };
  /** A larger part of the label that it touches. */
  std::uint32_t end{ 0 };
  bool          hasEnd{ false };
  bool          isLink{ false };

  void
  Touch(std::uint32_t part)
  {
    isLink = isLink || (hasEnd && part != end);
    end = part;
    hasEnd = true;
  }

  std::size_t
  Length() const
  {
    const Index sides = IndexBox{ lower, upper }.Size();
    return std::size_t(*std::max_element(sides.begin(), sides.end()));
  }
};

/** The labels that would lose many of their voxels. */
std::set<int>
FindThinLabels(const std::vector<LabelComponent> & components, const std::vector<char> & isIsland)
{
  std::map<int, std::size_t> voxels;
  std::map<int, std::size_t> lost;
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    voxels[components[c].label] += components[c].voxels;
    lost[components[c].label] += isIsland[c] ? components[c].voxels : 0;
  }
  std::set<int> thin;
  for (const auto & [label, count] : lost)
  {
    if (double(count) > LargestLoss * double(voxels[label]))
    {
      thin.insert(label);
    }
  }
  return thin;
}
} // namespace

void
KeepThreads(const Index &                       size,
            const std::uint32_t *               numbers,
            const std::vector<LabelComponent> & components,
            std::size_t                         minimumSize,
            std::vector<char> &                 isIsland)
{
  const auto numberAt = [&](const Index & at) {
    return numbers[(std::size_t(at[2]) * size[1] + at[1]) * size[0] + at[0]];
  };
  const auto         isSmall = [&](std::uint32_t number) { return components[number].voxels < minimumSize; };
  std::vector<Index> voxels;
  IndexBox::Of(size).Visit([&](const Index & at) {
    if (isSmall(numberAt(at)))
    {
      voxels.push_back(at);
    }
  });
  const auto visitTouching = [&](const Index & at, const auto & body) {
    const auto own = numberAt(at);
    IndexBox{ at, at }.Grown(1, size).Visit([&](const Index & near) {
      const auto other = numberAt(near);
      if (other != own && components[other].label == components[own].label)
      {
        body(other);
      }
    });
  };

  DisjointSets sets(components.size());
  for (const Index & at : voxels)
  {
    visitTouching(at, [&](std::uint32_t other) {
      if (isSmall(other))
      {
        sets.Unite(numberAt(at), other);
      }
    });
  }
  std::map<std::uint32_t, Chain> chains;
  for (const Index & at : voxels)
  {
    Chain & chain = chains.insert({ sets.Find(numberAt(at)), Chain{ at, at } }).first->second;
    ++chain.voxels;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      chain.lower[axis] = std::min(chain.lower[axis], at[axis]);
      chain.upper[axis] = std::max(chain.upper[axis], at[axis]);
    }
    visitTouching(at, [&](std::uint32_t other) {
      if (!isSmall(other))
      {
        chain.Touch(other);
      }
    });
  }
  const std::set<int> thinLabels = FindThinLabels(components, isIsland);
  const auto          isThread = [&](const Chain & chain, int label) {
    const bool isLong = chain.Length() >= minimumSize;
    return thinLabels.count(label) != 0 ? isLong || chain.isLink : isLong && chain.voxels <= Thickness * chain.Length();
  };
  for (std::uint32_t c = 0; c < isIsland.size(); ++c)
  {
    const auto found = isIsland[c] ? chains.find(sets.Find(c)) : chains.end();
    if (found != chains.end() && isThread(found->second, components[c].label))
    {
      isIsland[c] = 0;
    }
  }
}
} // namespace mmm
