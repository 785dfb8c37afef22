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
#include "input/LabelTableJson.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mmm
{
namespace
{
using Color = LabelTableSource::Color;

Color
ParseColor(const LabelTableSource & source, const JsonValue & value)
{
  if (value.kind == JsonValue::Kind::Text)
  {
    return source.ParseHexadecimal(value.text);
  }
  Color  color{};
  double highest = 0.0;
  bool   isColor = value.elements.size() >= 3;
  for (std::size_t c = 0; c < 3 && isColor; ++c)
  {
    color[c] = value.elements[c].number;
    highest = std::max(highest, color[c]);
    isColor = value.elements[c].kind == JsonValue::Kind::Number && color[c] >= 0.0 && color[c] <= HighestByte;
  }
  if (!isColor)
  {
    source.Fail("has a color that is neither like \"#cd3e4e\" nor three numbers, from 0 to 1 or to 255");
  }
  for (double & component : color)
  {
    component /= highest > 1.0 ? HighestByte : 1.0;
  }
  return color;
}

/** {"gray matter": 3} */
bool
IsNumberOfName(const JsonValue & value)
{
  return value.kind == JsonValue::Kind::Number && std::round(value.number) == value.number &&
         std::abs(value.number) <= std::numeric_limits<int>::max();
}

void
ParseMember(LabelTableSource & source, const std::string & key, const JsonValue & value)
{
  int        label = 0;
  LabelEntry entry{ key, {} };
  source.line = value.line;
  if (!ParseLabel(key, label))
  {
    if (!IsNumberOfName(value))
    {
      source.Fail("has '" + key + "', which is no label");
    }
    label = static_cast<int>(value.number);
  }
  else if (value.kind == JsonValue::Kind::Text)
  {
    entry.name = value.text;
  }
  else
  {
    const JsonValue * const name = value.Find("name");
    const JsonValue * const color = value.Find("color");
    if (name == nullptr || name->kind != JsonValue::Kind::Text)
    {
      source.Fail("has no name of label " + key + "; it has to be \"" + key + "\": \"NAME\" or \"" + key +
                  "\": {\"name\": \"NAME\"}");
    }
    entry.name = name->text;
    if (color != nullptr)
    {
      entry.color = ParseColor(source, *color);
    }
  }
  source.Add(label, entry);
}
} // namespace

const JsonValue *
FindLabelMap(const JsonValue & value)
{
  for (const char * const name : { "LabelMap", "labels" })
  {
    const JsonValue * const found = value.Find(name);
    if (found != nullptr && found->kind == JsonValue::Kind::Object)
    {
      return found;
    }
  }
  return nullptr;
}

void
AddLabels(LabelTableSource & source, const JsonValue & object)
{
  for (const auto & [key, member] : object.members)
  {
    ParseMember(source, key, member);
  }
}
} // namespace mmm
