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
#include "io/FileCursor.h"
#include "io/NumberText.h"

#include "itksys/FStream.hxx"
#include "itksys/SystemTools.hxx"

#include <algorithm>
#include <cstring>

namespace mmm
{
namespace
{
constexpr std::size_t quotedLength = 30;
} // namespace

std::string
Quoted(std::string_view word)
{
  std::string text(word.substr(0, quotedLength));
  std::replace_if(text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return '"' + text + '"';
}

bool
FileCursor::AtEnd()
{
  while (m_Position < m_Bytes.size() && IsBlank(m_Bytes[m_Position]))
  {
    ++m_Position;
  }
  return m_Position == m_Bytes.size();
}

std::string_view
FileCursor::Word()
{
  if (this->AtEnd())
  {
    this->Fail("the file ends too early");
  }
  const std::size_t begin = m_Position;
  while (m_Position < m_Bytes.size() && !IsBlank(m_Bytes[m_Position]))
  {
    ++m_Position;
  }
  return m_Bytes.substr(begin, m_Position - begin);
}

std::string_view
FileCursor::Line()
{
  const std::size_t begin = m_Position;
  const std::size_t end = std::min(m_Bytes.find('\n', begin), m_Bytes.size());
  m_Position = std::min(end + 1, m_Bytes.size());
  std::string_view line = m_Bytes.substr(begin, end - begin);
  while (!line.empty() && IsBlank(line.back()))
  {
    line.remove_suffix(1);
  }
  return line;
}

void
FileCursor::SkipPast(std::string_view text)
{
  const std::size_t found = m_Bytes.find(text, m_Position);
  if (found == std::string_view::npos)
  {
    this->Fail("there is no " + Quoted(text));
  }
  m_Position = found + text.size();
}

void
FileCursor::Expect(std::string_view word)
{
  const std::string_view found = this->Word();
  if (found != word)
  {
    this->Fail(Quoted(found) + " is not " + std::string(word));
  }
}

template <typename T>
T
FileCursor::Parse(std::string_view word, const char * kind) const
{
  T value{};
  if (!ParseNumber(word, value))
  {
    this->Fail(Quoted(word) + " is not " + kind);
  }
  return value;
}

template <typename T>
T
FileCursor::Raw()
{
  if (m_Bytes.size() - m_Position < sizeof(T))
  {
    this->Fail("the file ends too early");
  }
  char bytes[sizeof(T)];
  std::copy_n(m_Bytes.data() + m_Position, sizeof(T), bytes);
  m_Position += sizeof(T);
  if (m_Swapped)
  {
    std::reverse(bytes, bytes + sizeof(T));
  }
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

int
FileCursor::IntWord()
{
  return this->Parse<int>(this->Word(), "a whole number");
}

std::uint64_t
FileCursor::SizeWord()
{
  return this->Parse<std::uint64_t>(this->Word(), "a count or number");
}

double
FileCursor::RealWord()
{
  return this->Parse<double>(this->Word(), "a number");
}

int
FileCursor::Int()
{
  return m_Binary ? this->Raw<std::int32_t>() : this->IntWord();
}

std::uint64_t
FileCursor::Size()
{
  return m_Binary ? this->Raw<std::uint64_t>() : this->SizeWord();
}

double
FileCursor::Real()
{
  return m_Binary ? this->Raw<double>() : this->RealWord();
}

void
FileCursor::CheckCount(std::uint64_t count, std::size_t numbers, std::size_t bytes, const std::string & what) const
{
  // In text, a number is a digit and a blank at least.
  const std::size_t size = m_Binary ? bytes : 2 * numbers;
  if (count > (m_Bytes.size() - m_Position) / size)
  {
    this->Fail("the file is too short for " + std::to_string(count) + ' ' + what);
  }
}

void
FileCursor::Fail(const std::string & what) const
{
  if (m_Binary)
  {
    throw MeshFileError("at byte " + std::to_string(m_Position) + ", " + what);
  }
  const auto line = 1 + std::count(m_Bytes.begin(), m_Bytes.begin() + m_Position, '\n');
  throw MeshFileError("in line " + std::to_string(line) + ", " + what);
}

std::string
ReadWholeFile(const std::string & fileName)
{
  itksys::ifstream file(fileName.c_str(), std::ios::in | std::ios::binary);
  if (!file)
  {
    throw MeshFileError("it cannot be opened: " + itksys::SystemTools::GetLastSystemError());
  }
  std::string bytes;
  file.seekg(0, std::ios::end);
  const auto size = file.tellg();
  if (size > 0)
  {
    bytes.resize(static_cast<std::size_t>(size));
    file.seekg(0);
    file.read(bytes.data(), size);
  }
  if (!file)
  {
    throw MeshFileError("it cannot be read: " + itksys::SystemTools::GetLastSystemError());
  }
  return bytes;
}
} // namespace mmm
