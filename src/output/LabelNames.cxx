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
#include "output/LabelNames.h"

#include "base/Trimmed.h"

#include <algorithm>
#include <map>

namespace mmm
{
namespace
{
std::string
Cleaned(std::string name)
{
  for (char & character : name)
  {
    const auto code = static_cast<unsigned char>(character);
    character = code < ' ' || code == 127 ? ' ' : character == '"' ? '\'' : character;
  }
  return Trimmed(name);
}

/** Whether files have such a name for another thing: "label 3", "SPACE". */
bool
IsTaken(const std::string & name)
{
  return name.compare(0, 5, "label") == 0 || name == "SPACE";
}
} // namespace

LabelTable
NamesForFiles(const LabelTable & table, const std::set<int> & labels)
{
  LabelTable                 names;
  std::map<std::string, int> counts;
  for (const int label : labels)
  {
    const auto        entry = table.find(label);
    const std::string name = entry == table.end() ? "" : Cleaned(entry->second.name);
    if (!name.empty())
    {
      names[label] = { name, entry->second.color };
      ++counts[name];
    }
  }
  for (auto & [label, entry] : names)
  {
    const std::string numbered = entry.name + " (" + std::to_string(label) + ')';
    entry.name = counts[entry.name] > 1 || IsTaken(entry.name) ? numbered : entry.name;
  }
  return names;
}

std::string
NameOfPair(const LabelTable & names, const std::pair<int, int> & labels)
{
  const auto first = names.find(labels.first);
  const auto second = names.find(labels.second);
  const auto nameOf = [&](LabelTable::const_iterator place, int label) {
    return place == names.end() ? "label " + std::to_string(label) : place->second.name;
  };
  return first == names.end() && second == names.end()
           ? ""
           : nameOf(first, labels.first) + '|' + nameOf(second, labels.second);
}
} // namespace mmm
