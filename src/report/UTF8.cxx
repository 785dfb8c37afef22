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
#include "report/UTF8.h"

namespace mmm
{
namespace
{
/** The number of bytes of the UTF-8 character that begins here, or 0 if there is none. */
std::size_t
CharacterSize(const std::string & text, std::size_t at)
{
  const auto        first = static_cast<unsigned char>(text[at]);
  const std::size_t size = first < 0x80                    ? 1
                           : first >= 0xC2 && first < 0xE0 ? 2
                           : first >= 0xE0 && first < 0xF0 ? 3
                           : first >= 0xF0 && first < 0xF5 ? 4
                                                           : 0;
  if (at + size > text.size())
  {
    return 0;
  }
  for (std::size_t n = 1; n < size; ++n)
  {
    if ((static_cast<unsigned char>(text[at + n]) & 0xC0) != 0x80)
    {
      return 0;
    }
  }
  return size;
}
} // namespace

std::string
ToUTF8(const std::string & text)
{
  const char * const replacement = "\xEF\xBF\xBD";
  std::string        valid;
  for (std::size_t at = 0; at < text.size();)
  {
    const std::size_t size = CharacterSize(text, at);
    valid += size == 0 ? replacement : text.substr(at, size);
    at += size == 0 ? 1 : size;
  }
  return valid;
}
} // namespace mmm
