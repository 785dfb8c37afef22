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
#include "io/FileComposer.h"
#include "io/NumberText.h"

namespace mmm
{
namespace
{
constexpr std::size_t BufferSize = 1 << 20;
}

template <typename T>
void
FileComposer::Number(T value)
{
  if (m_Binary)
  {
    m_Buffer.append(reinterpret_cast<const char *>(&value), sizeof value);
  }
  else
  {
    AppendNumber(m_Buffer, value);
    m_Buffer.push_back(' ');
  }
}

void
FileComposer::Int(int value)
{
  this->Number(static_cast<std::int32_t>(value));
}

void
FileComposer::Size(std::uint64_t value)
{
  this->Number(value);
}

void
FileComposer::Real(double value)
{
  this->Number(value);
}

void
FileComposer::Text(const std::string & text)
{
  m_Buffer += text;
  this->FlushIfLarge();
}

void
FileComposer::EndLine()
{
  if (!m_Binary)
  {
    m_Buffer.back() = '\n';
  }
  this->FlushIfLarge();
}

void
FileComposer::EndNumbers()
{
  if (m_Binary)
  {
    m_Buffer.push_back('\n');
  }
}

void
FileComposer::FlushIfLarge()
{
  if (m_Buffer.size() > BufferSize)
  {
    m_File.Write(m_Buffer);
    m_Buffer.clear();
  }
}

void
FileComposer::Commit()
{
  m_File.Write(m_Buffer);
  m_File.Commit();
}
} // namespace mmm
