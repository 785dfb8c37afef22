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
#include "report/LabelLook.h"

#include "report/HTML.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
std::array<double, 3>
DefaultColor(int label)
{
  // hues that a golden section of the circle is between, which keeps the next ones apart
  constexpr double goldenSection = 0.6180339887498949;
  constexpr double chroma[3] = { 0.24, 0.28, 0.18 };
  constexpr double lightness[3] = { 0.62, 0.50, 0.74 };
  const double     turns = label * goldenSection;
  const double     hue = 12.0 * (turns - std::floor(turns));
  const auto       kind = std::size_t(((label / 3) % 3 + 3) % 3);
  const auto       channel = [&](double offset) {
    const double place = std::fmod(offset + hue, 12.0);
    return lightness[kind] - chroma[kind] * std::clamp(std::min(place - 3.0, 9.0 - place), -1.0, 1.0);
  };
  return { { channel(0.0), channel(8.0), channel(4.0) } };
}

std::string
ColorText(int label, const LabelTable & table)
{
  const auto         entry = table.find(label);
  const auto         color = entry != table.end() && entry->second.color ? *entry->second.color : DefaultColor(label);
  const char * const digits = "0123456789abcdef";
  std::string        text = "#";
  for (const double channel : color)
  {
    // a value that is no number is black
    const auto value = std::size_t(channel > 0.0 ? std::lround(255.0 * std::min(channel, 1.0)) : 0);
    text += digits[value / 16];
    text += digits[value % 16];
  }
  return text;
}

std::string
LabelText(int label, const LabelTable & table)
{
  const auto        entry = table.find(label);
  const std::string name = entry == table.end() ? "" : entry->second.name;
  return std::to_string(label) + (name.empty() ? "" : " " + name);
}

std::string
LabelClass(int label)
{
  return "l" + std::to_string(label);
}

std::string
LabelRules(const std::set<int> & labels, const LabelTable & table)
{
  std::string rules;
  for (const int label : labels)
  {
    rules += '.' + LabelClass(label) + "{--c:" + ColorText(label, table) + "}\n";
  }
  return rules;
}

std::string
LabelHTML(int label, const LabelTable & table)
{
  return "<span class=\"swatch " + LabelClass(label) + "\"></span>" + EscapedHTML(LabelText(label, table));
}
} // namespace mmm
