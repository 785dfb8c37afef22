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
#include "report/Json.h"

#include "report/UTF8.h"

#include "itkNumberToString.h"

#include <cmath>

namespace mmm
{
namespace
{
std::string
Quoted(const std::string & text)
{
  const char * const digits = "0123456789abcdef";
  std::string        quoted = "\"";
  for (const char c : ToUTF8(text))
  {
    if (c == '"' || c == '\\')
    {
      quoted += std::string("\\") + c;
    }
    else if (static_cast<unsigned char>(c) < 0x20)
    {
      quoted += std::string("\\u00") + digits[c >> 4] + digits[c & 15];
    }
    else
    {
      quoted += c;
    }
  }
  return quoted + '"';
}
} // namespace

Json::Json(bool value)
  : m_Scalar(value ? "true" : "false")
{}

Json::Json(double value)
{
  if (std::isfinite(value))
  {
    m_Scalar = itk::NumberToString<double>()(value);
    // a number that is real by its type should look so
    m_Scalar += m_Scalar.find_first_of(".eE") == std::string::npos ? ".0" : "";
  }
}

Json::Json(const std::string & text)
  : m_Scalar(Quoted(text))
{}

Json::Json(const char * text)
  : Json(std::string(text))
{}

Json
Json::Array(std::vector<Json> values)
{
  Json json;
  json.m_Kind = Kind::Array;
  json.m_Values = std::move(values);
  return json;
}

Json
Json::Object(std::vector<Member> members)
{
  Json json;
  json.m_Kind = Kind::Object;
  for (Member & member : members)
  {
    json.Add(member.first, std::move(member.second));
  }
  return json;
}

void
Json::Add(Json value)
{
  m_Values.push_back(std::move(value));
}

void
Json::Add(const std::string & name, Json value)
{
  m_Names.push_back(name);
  m_Values.push_back(std::move(value));
}

std::string
Json::ToText(const std::string & indent) const
{
  if (m_Kind == Kind::Scalar)
  {
    return m_Scalar;
  }
  const bool isObject = m_Kind == Kind::Object;
  if (m_Values.empty())
  {
    return isObject ? "{}" : "[]";
  }
  const std::string inner = indent + "  ";
  std::string       text;
  for (std::size_t n = 0; n < m_Values.size(); ++n)
  {
    text += (n == 0 ? "\n" : ",\n") + inner + (isObject ? Quoted(m_Names[n]) + ": " : "") + m_Values[n].ToText(inner);
  }
  return (isObject ? '{' : '[') + text + '\n' + indent + (isObject ? '}' : ']');
}
} // namespace mmm
