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
#include "run/LabelNames.h"

#include "console/Errors.h"
#include "console/StreamCapture.h"
#include "console/Warnings.h"
#include "itkLabelTableReader.h"

namespace cli
{
namespace
{
mmm::LabelTable
ReadTable(const std::string & fileName)
{
  // what libraries have to say of an image was said when it was read
  const StreamCapture capture;
  const auto          reader = itk::LabelTableReader::New();
  reader->SetFileName(fileName);
  reader->Read();
  return reader->GetLabelTable();
}

std::string
FindTable(const std::string & imageName)
{
  const StreamCapture capture;
  return itk::LabelTableReader::FindFileFor(imageName);
}

/** Moves the entries to the labels that those of the image have become. */
mmm::LabelTable
Follow(const mmm::LabelTable & table, const std::map<int, int> & changes)
{
  mmm::LabelTable moved;
  std::set<int>   ambiguous;
  for (const auto & [old, label] : changes)
  {
    const auto entry = table.find(old);
    const auto known = moved.insert({ label, entry == table.end() ? mmm::LabelEntry() : entry->second });
    if (!known.second && known.first->second.name != (entry == table.end() ? "" : entry->second.name))
    {
      ambiguous.insert(label);
    }
  }
  for (const int label : ambiguous)
  {
    moved.erase(label);
  }
  return moved;
}

LabelNames
FindNames(const Settings & settings, const std::map<int, int> & changes)
{
  LabelNames names;
  try
  {
    names.file = FindTable(settings.labels);
    if (!names.file.empty())
    {
      names.table = ReadTable(names.file);
    }
  }
  catch (const std::exception &)
  {
    Warn("labels have no names: " + DescribeCurrentException());
    return {};
  }
  if (!changes.empty())
  {
    names.table = Follow(names.table, changes);
  }
  return names;
}

void
WarnOfLabelsWithoutName(const LabelNames & names, const std::set<int> & meshed, bool areChanged)
{
  constexpr int most = 10;
  std::string   list;
  int           count = 0;
  for (const int label : meshed)
  {
    if (names.NameOf(label).empty() && count++ < most)
    {
      list += (list.empty() ? "" : ", ") + std::to_string(label);
    }
  }
  if (count > 0)
  {
    Warn(names.file + " has no name for label" + (count == 1 ? " " : "s ") + list +
         (count > most ? " and " + std::to_string(count - most) + " more" : "") +
         (areChanged ? "; --names FILE names what --map and --merge join" : ""));
  }
}
} // namespace

std::string
LabelNames::NameOf(int label) const
{
  const auto entry = table.find(label);
  return entry == table.end() ? "" : entry->second.name;
}

std::string
LabelNames::Describe(int label) const
{
  const std::string name = this->NameOf(label);
  return "label " + std::to_string(label) + (name.empty() ? "" : " (" + name + ')');
}

LabelNames
ReadLabelNames(const Settings &           settings,
               const std::map<int, int> & changes,
               const std::set<int> &      meshed,
               const mmm::LabelTable &    own)
{
  const bool isFound = settings.names.empty();
  LabelNames names;
  if (settings.names == "none")
  {
    return names;
  }
  if (isFound && settings.labels.empty())
  {
    names.table = own;
    return names;
  }
  if (isFound)
  {
    names = FindNames(settings, changes);
  }
  else
  {
    names = { settings.names, ReadTable(settings.names) };
  }
  // what a table says of electrodes comes before what they say themselves
  for (const auto & entry : own)
  {
    if (!entry.second.name.empty())
    {
      names.table.insert(entry);
    }
  }
  if (!names.file.empty())
  {
    WarnOfLabelsWithoutName(names, meshed, isFound && !changes.empty());
  }
  return names;
}
} // namespace cli
