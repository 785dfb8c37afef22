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
#include "io/vtu/VTUByteReader.h"
#include "io/NumberText.h"
#include "io/vtu/VTUFormat.h"

#include "itksys/Base64.h"

#include <algorithm>
#include <cstring>

namespace mmm
{
namespace
{
constexpr std::size_t bufferSize = 1 << 16;

bool
IsBase64(unsigned char c)
{
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '+' || c == '/' || c == '=';
}
} // namespace

VTUByteReader::VTUByteReader(std::istream & file, std::uint64_t begin, std::uint64_t end, bool base64)
  : m_File(file)
  , m_Left(begin < end ? end - begin : 0)
  , m_Base64(base64)
{
  m_File.clear();
  m_File.seekg(static_cast<std::streamoff>(begin));
}

std::uint64_t
VTUByteReader::Available() const
{
  return m_Base64 ? m_Decoded.size() - m_Position + (m_Left + m_GroupSize) / 4 * 3 : m_Left;
}

void
VTUByteReader::Read(void * bytes, std::size_t size)
{
  if (size > this->Available())
  {
    this->ThrowEnd();
  }
  if (!m_Base64)
  {
    if (!m_File.read(static_cast<char *>(bytes), static_cast<std::streamsize>(size)))
    {
      throw MeshFileError("cannot be read");
    }
    m_Left -= size;
    return;
  }
  for (auto * out = static_cast<unsigned char *>(bytes); size > 0;)
  {
    if (m_Position == m_Decoded.size())
    {
      this->Refill();
    }
    const std::size_t taken = std::min(size, m_Decoded.size() - m_Position);
    std::memcpy(out, m_Decoded.data() + m_Position, taken);
    m_Position += taken;
    out += taken;
    size -= taken;
  }
}

void
VTUByteReader::ThrowEnd() const
{
  throw MeshFileError(m_EndsInvalid ? "has a character that is not base64" : "ends early");
}

void
VTUByteReader::Refill()
{
  m_Position = 0;
  m_Decoded.clear();
  unsigned char text[bufferSize];
  while (m_Decoded.empty())
  {
    const std::size_t size = static_cast<std::size_t>(std::min<std::uint64_t>(m_Left, bufferSize));
    if (size == 0)
    {
      this->ThrowEnd();
    }
    if (!m_File.read(reinterpret_cast<char *>(text), static_cast<std::streamsize>(size)))
    {
      throw MeshFileError("cannot be read");
    }
    m_Left -= size;
    m_Decoded.resize(bufferSize / 4 * 3 + 3);
    unsigned char * out = m_Decoded.data();
    for (const unsigned char * in = text; in < text + size; ++in)
    {
      if (IsBlank(static_cast<char>(*in)))
      {
        continue;
      }
      if (!IsBase64(*in))
      {
        // Of appended data the end is not known: what follows the last array is an error only if it is needed.
        m_Left = 0;
        m_EndsInvalid = true;
        break;
      }
      m_Group[m_GroupSize++] = *in;
      if (m_GroupSize == 4)
      {
        // A stream may follow another one: padding is no end.
        out += itksysBase64_Decode3(m_Group, out);
        m_GroupSize = 0;
      }
    }
    m_Decoded.resize(out - m_Decoded.data());
  }
}
} // namespace mmm
