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
#include "sizing/SizeRule.h"

#include "itkMacro.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

namespace mmm
{
namespace
{
std::vector<std::string>
Split(const std::string & text, char separator)
{
  std::vector<std::string> parts(1);
  for (const char c : text)
  {
    if (c == separator)
    {
      parts.emplace_back();
    }
    else
    {
      parts.back() += c;
    }
  }
  return parts;
}

/** Independent of the locale. Returns whether all of the text is a number. */
template <typename TNumber>
bool
ReadNumber(const std::string & text, TNumber & number)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  return !(stream >> std::noskipws >> number).fail() && stream.peek() == std::istringstream::traits_type::eof();
}

std::pair<int, SizeRule>
ParseRule(const std::string & text)
{
  const auto parts = Split(text, ':');
  int        label = 0;
  if (!ReadNumber(parts.front(), label))
  {
    itkGenericExceptionMacro("The sizes of labels have '" << parts.front() << "' where a label has to be, in '" << text
                                                          << "'. They are written like 3:factor=0.5:max=2,7:min=1.");
  }
  SizeRule rule;
  for (std::size_t n = 1; n < parts.size(); ++n)
  {
    const auto        equals = std::min(parts[n].find('='), parts[n].size());
    const std::string name = parts[n].substr(0, equals);
    double * const    value = name == "factor" ? &rule.factor
                              : name == "min"  ? &rule.minimumSize
                              : name == "max"  ? &rule.maximumSize
                                               : nullptr;
    if (value == nullptr || equals == parts[n].size() || !ReadNumber(parts[n].substr(equals + 1), *value))
    {
      itkGenericExceptionMacro("The sizes of label " << label << " have '" << parts[n]
                                                     << "', which is none of factor=NUMBER, min=NUMBER and max=NUMBER. "
                                                        "They are written like 3:factor=0.5:max=2,7:min=1.");
    }
  }
  if (!rule.IsGiven())
  {
    itkGenericExceptionMacro("The sizes of labels ask for nothing in label "
                             << label << ". They are written like 3:factor=0.5:max=2,7:min=1.");
  }
  return { label, rule };
}

/** Ascending numbers, runs of them as ranges: "0-6, 9". */
std::string
DescribeLabels(const std::vector<int> & labels)
{
  std::ostringstream words;
  for (std::size_t n = 0; n < labels.size(); ++n)
  {
    std::size_t last = n;
    while (last + 1 < labels.size() && labels[last + 1] == labels[last] + 1)
    {
      ++last;
    }
    words << (n > 0 ? ", " : "") << labels[n];
    if (last > n)
    {
      words << (last > n + 1 ? " to " : ", ") << labels[last];
    }
    n = last;
  }
  return words.str();
}
} // namespace

LabelSizeRules
ParseLabelSizeRules(const std::string & text)
{
  LabelSizeRules rules;
  if (text.empty())
  {
    return rules;
  }
  for (const std::string & part : Split(text, ','))
  {
    const auto rule = ParseRule(part);
    if (!rules.insert(rule).second)
    {
      itkGenericExceptionMacro("The sizes of label " << rule.first << " are given twice. Join them, with colons.");
    }
  }
  return rules;
}

std::string
ToText(const LabelSizeRules & rules)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(17);
  for (const auto & entry : rules)
  {
    const SizeRule & rule = entry.second;
    text << (text.tellp() > 0 ? "," : "") << entry.first;
    if (rule.factor != 1.0)
    {
      text << ":factor=" << rule.factor;
    }
    if (!std::isnan(rule.minimumSize))
    {
      text << ":min=" << rule.minimumSize;
    }
    if (!std::isnan(rule.maximumSize))
    {
      text << ":max=" << rule.maximumSize;
    }
  }
  return text.str();
}

std::string
DescribeError(const SizeRule & rule, const std::string & place)
{
  std::ostringstream words;
  const auto         isWrong = [](double value) { return !(value > 0.0) || std::isinf(value); };
  if (isWrong(rule.factor))
  {
    words << "The factor of " << place << " is " << rule.factor << ". It must be positive and finite.";
  }
  else if (!std::isnan(rule.minimumSize) && isWrong(rule.minimumSize))
  {
    words << "The smallest size in " << place << " is " << rule.minimumSize << " mm. It must be positive and finite.";
  }
  else if (rule.maximumSize <= 0.0)
  {
    words << "The largest size in " << place << " is " << rule.maximumSize << " mm. It must be positive.";
  }
  else if (rule.minimumSize > rule.maximumSize)
  {
    words << "The smallest size in " << place << ", " << rule.minimumSize << " mm, is above the largest, "
          << rule.maximumSize << " mm.";
  }
  return words.str();
}

std::string
DescribeUnknownLabels(const LabelSizeRules & rules, std::vector<int> labels)
{
  std::sort(labels.begin(), labels.end());
  std::vector<int> unknown;
  for (const auto & entry : rules)
  {
    if (!std::binary_search(labels.begin(), labels.end(), entry.first))
    {
      unknown.push_back(entry.first);
    }
  }
  return unknown.empty() ? ""
                         : "Sizes are given for " + DescribeLabels(unknown) +
                             ", which is no label here. The labels are " + DescribeLabels(labels) + ".";
}
} // namespace mmm
