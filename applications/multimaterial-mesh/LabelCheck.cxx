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
#include "LabelCheck.h"

#include "Errors.h"

#include <algorithm>
#include <sstream>

namespace cli
{
namespace
{
/** No atlas in use has so many labels. */
constexpr std::size_t MaximumLabels = 1000;
/** Fewer values than these are a label image, however noisy. */
constexpr std::size_t MinimumIntensities = 33;
/** Half of the neighbours on a row differ in an intensity image; one in ten do in a fine atlas. */
constexpr double MaximumChangeRate = 0.5;

/** The fraction of neighbours that differ, those in the background left out. */
double
ChangeRate(const LabelImage & image, int background)
{
  const int * const values = image.GetBufferPointer();
  const std::size_t count = image.GetBufferedRegion().GetNumberOfPixels();
  std::size_t       pairs = 0;
  std::size_t       changes = 0;
  for (std::size_t v = 1; v < count; ++v)
  {
    pairs += values[v] != background || values[v - 1] != background;
    changes += values[v] != values[v - 1];
  }
  return pairs > 0 ? double(changes) / double(pairs) : 0.0;
}
} // namespace

mmm::LabelCounts
CheckLabels(const std::string & fileName, const LabelImage & image)
{
  const mmm::LabelCounts counts = mmm::CountLabels(&image);
  if (counts.size() == 1)
  {
    std::ostringstream message;
    message << fileName << ": all voxels have the value " << counts.begin()->first
            << "; a label image needs at least two labels";
    throw Error(message.str());
  }
  if (counts.size() >= MinimumIntensities)
  {
    const auto background = std::max_element(
      counts.begin(), counts.end(), [](const auto & a, const auto & b) { return a.second < b.second; });
    if (counts.size() > MaximumLabels || ChangeRate(image, background->first) > MaximumChangeRate)
    {
      std::ostringstream message;
      message << fileName << ": the image has " << counts.size() << " values, from " << counts.begin()->first << " to "
              << counts.rbegin()->first
              << ", and looks like an intensity image; segment it first, or map its values to at most " << MaximumLabels
              << " labels";
      throw Error(message.str());
    }
  }
  return counts;
}

std::optional<int>
LabelOfAir(const Settings & settings, const mmm::LabelCounts & voxels)
{
  if (!settings.IsFilled())
  {
    return std::nullopt;
  }
  const auto isThere = [&](int label) { return voxels.count(label) != 0; };
  const auto first = std::find_if(settings.exterior.begin(), settings.exterior.end(), isThere);
  if (first != settings.exterior.end())
  {
    return *first;
  }
  return settings.airMargin > 0.0 ? std::optional<int>(settings.exterior.front()) : std::nullopt;
}
} // namespace cli
