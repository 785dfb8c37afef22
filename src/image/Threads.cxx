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

namespace mmm
{
namespace
{
/** Islands that touch each other. */
struct Chain
{
  Index lower;
  Index upper;
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
  for (std::uint32_t c = 0; c < isIsland.size(); ++c)
  {
    const auto found = isIsland[c] ? chains.find(sets.Find(c)) : chains.end();
    if (found != chains.end() && (found->second.isLink || found->second.Length() >= minimumSize))
    {
      isIsland[c] = 0;
    }
  }
}
} // namespace mmm
