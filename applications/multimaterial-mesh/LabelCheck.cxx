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
  const std::string intensities = mmm::DescribeIntensities(&image, counts);
  if (!intensities.empty())
  {
    throw Error(fileName + ": the image " + intensities);
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
