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
#include "input/LabelTableSource.h"

#include "itkMacro.h"

#include <charconv>

namespace mmm
{
void
LabelTableSource::Fail(const std::string & what) const
{
  itkGenericExceptionMacro(<< fileName << ": line " << line << ' ' << what);
}

void
LabelTableSource::Add(int label, const LabelEntry & entry)
{
  const auto [place, isNew] = table.insert({ label, entry });
  if (!isNew && (place->second.name != entry.name || place->second.color != entry.color))
  {
    this->Fail("names label " + std::to_string(label) + " again, '" + entry.name + "' after '" + place->second.name +
               "'");
  }
}

auto
LabelTableSource::ParseHexadecimal(const std::string & text) const -> Color
{
  const std::string digits = text.substr(!text.empty() && text.front() == '#');
  if (digits.size() != 6 || digits.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos)
  {
    this->Fail("has the color '" + text + "'; it has to be like #cd3e4e");
  }
  Color color;
  for (std::size_t c = 0; c < color.size(); ++c)
  {
    color[c] = std::stoi(digits.substr(2 * c, 2), nullptr, 16) / HighestByte;
  }
  return color;
}

bool
ParseLabel(const std::string & word, int & label)
{
  const auto parsed = std::from_chars(word.data(), word.data() + word.size(), label);
  return parsed.ec == std::errc() && parsed.ptr == word.data() + word.size();
}
} // namespace mmm
