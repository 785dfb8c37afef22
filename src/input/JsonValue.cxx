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
#include "input/JsonValue.h"

#include "itkMacro.h"

#include <algorithm>
#include <cstdint>
#include <locale>
#include <sstream>
#include <string_view>

namespace mmm
{
namespace
{
/** Deeper than any table; texts that go deeper are not to fill the stack. */
constexpr int MostLevels = 64;

void
AppendUTF8(std::string & text, std::uint32_t code)
{
  const auto rest = [code](int shift) { return static_cast<char>(0x80 | (code >> shift & 0x3f)); };
  if (code < 0x80)
  {
    text += static_cast<char>(code);
  }
  else if (code < 0x800)
  {
    text += { static_cast<char>(0xc0 | code >> 6), rest(0) };
  }
  else if (code < 0x10000)
  {
    text += { static_cast<char>(0xe0 | code >> 12), rest(6), rest(0) };
  }
  else
  {
    text += { static_cast<char>(0xf0 | code >> 18), rest(12), rest(6), rest(0) };
  }
}

class Parser
{
public:
  Parser(const std::string & fileName, std::string_view text)
    : m_FileName(fileName)
    , m_Text(text)
  {}

  JsonValue
  ParseAll()
  {
    const JsonValue value = this->ParseValue(0);
    if (this->Next() != '\0')
    {
      this->Fail("there is more after the end of the value");
    }
    return value;
  }

private:
  [[noreturn]] void
  Fail(const std::string & what) const
  {
    itkGenericExceptionMacro(<< m_FileName << ": line " << m_Line << " is not JSON: " << what);
  }

  /** The next character that is no blank; 0 at the end. */
  char
  Next()
  {
    while (m_Place < m_Text.size() && std::string_view(" \t\r\n").find(m_Text[m_Place]) != std::string_view::npos)
    {
      m_Line += m_Text[m_Place++] == '\n';
    }
    return m_Place < m_Text.size() ? m_Text[m_Place] : '\0';
  }

  void
  Expect(char character)
  {
    if (this->Next() != character)
    {
      this->Fail(std::string("there is no ") + character + " where one has to be");
    }
    ++m_Place;
  }

  /** Calls parse() for each of the parts between two brackets. */
  template <typename TParse>
  void
  ParseList(char last, const TParse & parse)
  {
    ++m_Place;
    if (this->Next() == last)
    {
      ++m_Place;
      return;
    }
    while (true)
    {
      parse();
      if (this->Next() == last)
      {
        ++m_Place;
        return;
      }
      this->Expect(',');
    }
  }

  JsonValue
  ParseValue(int level)
  {
    JsonValue  value;
    const char first = this->Next();
    value.line = m_Line;
    if (level > MostLevels)
    {
      this->Fail("it is nested too deeply");
    }
    if (first == '{')
    {
      value.kind = JsonValue::Kind::Object;
      this->ParseList('}', [&] {
        this->Next();
        std::string name = this->ParseText();
        this->Expect(':');
        value.members.emplace_back(std::move(name), this->ParseValue(level + 1));
      });
    }
    else if (first == '[')
    {
      value.kind = JsonValue::Kind::Array;
      this->ParseList(']', [&] { value.elements.push_back(this->ParseValue(level + 1)); });
    }
    else if (first == '"')
    {
      value.kind = JsonValue::Kind::Text;
      value.text = this->ParseText();
    }
    else
    {
      this->ParseWord(value);
    }
    return value;
  }

  void
  ParseWord(JsonValue & value)
  {
    const std::size_t end = std::min(m_Text.find_first_of(" \t\r\n,]}:", m_Place), m_Text.size());
    const std::string word(m_Text.substr(m_Place, end - m_Place));
    m_Place = end;
    if (word == "true" || word == "false" || word == "null")
    {
      return;
    }
    std::istringstream stream(word);
    stream.imbue(std::locale::classic());
    if (!(stream >> std::noskipws >> value.number) || stream.peek() != std::istringstream::traits_type::eof())
    {
      this->Fail(word.empty() ? "a value is missing" : "'" + word + "' is no value; texts are in quotation marks");
    }
    value.kind = JsonValue::Kind::Number;
  }

  std::uint32_t
  ParseCode()
  {
    const std::string digits(m_Text.substr(std::min(m_Place, m_Text.size()), 4));
    if (digits.size() < 4 || digits.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos)
    {
      this->Fail("\\u has to be followed by four hexadecimal digits");
    }
    m_Place += 4;
    return static_cast<std::uint32_t>(std::stoul(digits, nullptr, 16));
  }

  std::string
  ParseText()
  {
    std::string text;
    this->Expect('"');
    while (m_Place < m_Text.size() && m_Text[m_Place] != '"' && m_Text[m_Place] != '\n')
    {
      const char character = m_Text[m_Place++];
      if (character != '\\')
      {
        text += character;
        continue;
      }
      const char             escape = m_Place < m_Text.size() ? m_Text[m_Place++] : '\0';
      const std::string_view escapes = "\"\\/bfnrt";
      const auto             known = escapes.find(escape);
      if (escape == 'u')
      {
        std::uint32_t code = this->ParseCode();
        if (code >= 0xd800 && code < 0xdc00 && m_Text.substr(m_Place, 2) == "\\u")
        {
          m_Place += 2;
          code = 0x10000 + ((code - 0xd800) << 10) + (this->ParseCode() & 0x3ff);
        }
        AppendUTF8(text, code);
      }
      else if (known == std::string_view::npos)
      {
        this->Fail("a text has an unknown escape");
      }
      else
      {
        text += "\"\\/\b\f\n\r\t"[known];
      }
    }
    this->Expect('"');
    return text;
  }

  const std::string & m_FileName;
  std::string_view    m_Text;
  std::size_t         m_Place{ 0 };
  std::size_t         m_Line{ 1 };
};
} // namespace

const JsonValue *
JsonValue::Find(const std::string & name) const
{
  const auto found =
    std::find_if(members.begin(), members.end(), [&](const auto & member) { return member.first == name; });
  return found == members.end() ? nullptr : &found->second;
}

JsonValue
ParseJson(const std::string & fileName, const std::string & text)
{
  return Parser(fileName, text).ParseAll();
}
} // namespace mmm
