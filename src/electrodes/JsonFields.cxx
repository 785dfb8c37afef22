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
#include "electrodes/JsonFields.h"

#include "itkMacro.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace mmm
{
namespace
{
std::string
ToText(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

/** "a, b or c" */
std::string
ListOf(std::initializer_list<const char *> names)
{
  std::string list;
  for (auto name = names.begin(); name != names.end(); ++name)
  {
    list += (name == names.begin() ? "" : name + 1 == names.end() ? " or " : ", ") + std::string(*name);
  }
  return list;
}
} // namespace

std::string
JsonFields::PathOf(const std::string & name) const
{
  return m_Path + (m_Path.back() == ' ' ? "" : ".") + name;
}

void
JsonFields::Fail(const std::string & problem) const
{
  itkGenericExceptionMacro(<< m_Path << ": " << problem << '.');
}

void
JsonFields::Allow(std::initializer_list<const char *> names) const
{
  if (m_Value.kind != JsonValue::Kind::Object)
  {
    this->Fail("this has to be an object, {...}");
  }
  for (const auto & member : m_Value.members)
  {
    if (std::find(names.begin(), names.end(), member.first) == names.end())
    {
      JsonFields(member.second, this->PathOf(member.first))
        .Fail("there is no such key here; it can be " + ListOf(names));
    }
  }
}

JsonFields
JsonFields::operator[](const std::string & name) const
{
  const JsonValue * const value = m_Value.Find(name);
  const std::string       path = this->PathOf(name);
  if (value == nullptr)
  {
    JsonFields(m_Value, path).Fail("it is missing");
  }
  return { *value, path };
}

std::vector<JsonFields>
JsonFields::Elements() const
{
  if (m_Value.kind != JsonValue::Kind::Array)
  {
    this->Fail("this has to be a list, [...]");
  }
  std::vector<JsonFields> elements;
  for (std::size_t n = 0; n < m_Value.elements.size(); ++n)
  {
    elements.emplace_back(m_Value.elements[n], m_Path + '[' + std::to_string(n) + ']');
  }
  return elements;
}

std::string
JsonFields::Text() const
{
  if (m_Value.kind != JsonValue::Kind::Text || m_Value.text.empty())
  {
    this->Fail("this has to be a text, \"...\"");
  }
  return m_Value.text;
}

double
JsonFields::Number() const
{
  if (m_Value.kind != JsonValue::Kind::Number || !std::isfinite(m_Value.number))
  {
    this->Fail("this has to be a number");
  }
  return m_Value.number;
}

double
JsonFields::PositiveNumber() const
{
  const double number = this->Number();
  if (!(number > 0.0))
  {
    this->Fail(ToText(number) + " mm is not positive");
  }
  return number;
}

int
JsonFields::Label() const
{
  const double number = this->Number();
  if (std::round(number) != number || std::abs(number) > std::numeric_limits<int>::max())
  {
    this->Fail(ToText(number) + " is no label, which is a whole number");
  }
  return static_cast<int>(number);
}

std::vector<double>
JsonFields::Numbers(std::size_t count) const
{
  std::vector<double> numbers;
  for (const JsonFields & element : this->Elements())
  {
    numbers.push_back(element.Number());
  }
  if (numbers.size() != count)
  {
    this->Fail("there are " + std::to_string(numbers.size()) + " numbers; it has to be " + std::to_string(count));
  }
  return numbers;
}
} // namespace mmm
