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
#include "run/LabelChanges.h"

#include "console/Errors.h"
#include "console/Warnings.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace cli
{
namespace
{
/** Returns whether the whole text is a label. */
bool
ParseLabel(const std::string & text, int & label)
{
  const auto result = std::from_chars(text.data(), text.data() + text.size(), label);
  return result.ec == std::errc() && result.ptr == text.data() + text.size();
}

/** "3" or "1000..1035" */
bool
ParseLabelRange(const std::string & text, int & first, int & last)
{
  const auto dots = text.find("..");
  return dots == std::string::npos
           ? ParseLabel(text, first) && ParseLabel(text, last)
           : ParseLabel(text.substr(0, dots), first) && ParseLabel(text.substr(dots + 2), last) && first <= last;
}

std::vector<std::string>
Split(const std::string & text, char separator)
{
  std::vector<std::string> parts;
  std::istringstream       stream(text);
  for (std::string part; std::getline(stream, part, separator);)
  {
    parts.push_back(part);
  }
  return parts;
}
} // namespace

LabelChanges::LabelChanges(const Settings & settings)
  : m_Only(settings.onlyLabels.begin(), settings.onlyLabels.end())
  , m_Exterior(settings.exterior)
{
  if (!settings.labelMap.empty())
  {
    this->ReadMap(settings.labelMap);
  }
  for (const std::string & merge : Split(settings.merges, ';'))
  {
    this->ParseMerge(merge);
  }
}

void
LabelChanges::ReadMap(const std::string & fileName)
{
  std::ifstream stream(std::filesystem::u8path(fileName));
  if (!stream)
  {
    throw Error(fileName + ": the file of --map cannot be opened");
  }
  int number = 0;
  for (std::string line; std::getline(stream, line);)
  {
    ++number;
    std::istringstream words(line.substr(0, line.find('#')));
    std::string        from;
    std::string        to;
    if (!(words >> from))
    {
      continue;
    }
    words >> to;
    int label = 0;
    int first = 0;
    int last = 0;
    if (!ParseLabel(to, label) || (from != "*" && !ParseLabelRange(from, first, last)))
    {
      throw Error(fileName + ": line " + std::to_string(number) +
                  " is not OLD NEW, FIRST..LAST NEW or * NEW, with whole numbers as labels");
    }
    if (from == "*")
    {
      m_MapOfOthers = label;
      continue;
    }
    // the last number of a range may be the last that there is
    for (long long old = first; old <= last; ++old)
    {
      const auto [place, isNew] = m_Map.insert({ static_cast<int>(old), label });
      if (!isNew && place->second != label)
      {
        throw Error(fileName + ": line " + std::to_string(number) + " gives label " + std::to_string(old) +
                    " another number than a line before");
      }
    }
  }
}

void
LabelChanges::ParseMerge(const std::string & text)
{
  const auto parts = Split(text, '=');
  int        merged = 0;
  if (parts.size() != 2 || !ParseLabel(parts[0], merged))
  {
    throw UsageError("--merge is '" + text + "'; it has to be NEW=L,L, for instance 9=3,4");
  }
  for (const std::string & part : Split(parts[1], ','))
  {
    int label = 0;
    if (!ParseLabel(part, label))
    {
      throw UsageError("--merge is '" + text + "'; it has to be NEW=L,L, for instance 9=3,4");
    }
    if (!m_Merge.insert({ label, merged }).second)
    {
      throw UsageError("--merge names label " + std::to_string(label) + " twice");
    }
  }
}

int
LabelChanges::operator()(int label) const
{
  const auto mapped = m_Map.find(label);
  label = mapped != m_Map.end() ? mapped->second : m_MapOfOthers.value_or(label);
  const auto merged = m_Merge.find(label);
  label = merged != m_Merge.end() ? merged->second : label;
  const bool isMeshed = m_Only.empty() || m_Only.count(label) != 0;
  const bool isExterior = std::find(m_Exterior.begin(), m_Exterior.end(), label) != m_Exterior.end();
  return isMeshed || isExterior ? label : m_Exterior.front();
}

std::map<int, int>
LabelChanges::Apply(itk::Image<int, 3> & image) const
{
  if (m_Map.empty() && !m_MapOfOthers && m_Merge.empty() && m_Only.empty())
  {
    return {};
  }
  std::map<int, int> known;
  int * const        end = image.GetBufferPointer() + image.GetBufferedRegion().GetNumberOfPixels();
  for (int * label = image.GetBufferPointer(); label != end; ++label)
  {
    auto place = known.find(*label);
    if (place == known.end())
    {
      place = known.insert({ *label, (*this)(*label) }).first;
    }
    *label = place->second;
  }
  std::set<int> mapped;
  std::set<int> merged;
  for (const auto & [old, label] : known)
  {
    const auto place = m_Map.find(old);
    mapped.insert(place != m_Map.end() ? place->second : m_MapOfOthers.value_or(old));
    merged.insert(label);
  }
  for (const auto & entry : m_Merge)
  {
    if (mapped.count(entry.first) == 0)
    {
      Warn("no voxel has the label " + std::to_string(entry.first) + " that --merge names");
    }
  }
  for (const int label : m_Only)
  {
    if (merged.count(label) == 0)
    {
      Warn("no voxel has the label " + std::to_string(label) + " that --labels names");
    }
  }
  return known;
}
} // namespace cli
