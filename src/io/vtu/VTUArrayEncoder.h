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
#ifndef mmmVTUArrayEncoder_h
#define mmmVTUArrayEncoder_h

#include "io/NumberText.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace mmm
{
enum class VTUEncoding
{
  Text,
  Base64,
  CompressedBase64
};

/** \brief Makes the content of a `<DataArray>` of the values that are pushed, with a 64-bit header.
 *
 * Only a few MiB of values are kept at a time; their blocks are compressed in parallel. */
class VTUArrayEncoder
{
public:
  /** numberOfBytes: how much will be pushed. */
  VTUArrayEncoder(VTUEncoding encoding, std::uint64_t numberOfBytes);

  template <typename T>
  void
  Push(T value)
  {
    if (m_Encoding == VTUEncoding::Text)
    {
      this->BeginWord();
      AppendNumber(m_Text, value);
      return;
    }
    if (m_Pending.size() - m_Used < sizeof(T))
    {
      this->EncodePending();
    }
    std::memcpy(m_Pending.data() + m_Used, &value, sizeof(T));
    m_Used += sizeof(T);
  }

  std::string
  Finish();

private:
  void
  BeginWord();
  void
  EncodePending();
  void
  AppendBase64(const unsigned char * bytes, std::size_t size);
  void
  FinishBase64();

  VTUEncoding m_Encoding;
  std::string m_Text;
  std::size_t m_Column{ 0 };

  std::vector<unsigned char> m_Pending;
  std::size_t                m_Used{ 0 };
  std::vector<std::uint64_t> m_Header;

  // Base64 works on three bytes at a time: those that wait for a third.
  unsigned char m_Carry[3]{};
  std::size_t   m_CarrySize{ 0 };
};

/** Puts encoded values into a `<DataArray>` element. */
std::string
VTUArrayElement(const std::string & typeName,
                const std::string & name,
                std::size_t         numberOfComponents,
                VTUEncoding         encoding,
                const std::string & content);
} // namespace mmm

#endif
