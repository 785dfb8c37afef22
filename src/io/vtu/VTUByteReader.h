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
#ifndef mmmVTUByteReader_h
#define mmmVTUByteReader_h

#include <cstddef>
#include <cstdint>
#include <istream>
#include <vector>

namespace mmm
{
/** \brief Hands out the bytes of a part of a file one after the other, decoded if they are base64. */
class VTUByteReader
{
public:
  VTUByteReader(std::istream & file, std::uint64_t begin, std::uint64_t end, bool base64);

  /** Upper bound of the bytes that are left. */
  std::uint64_t
  Available() const;

  /** Throws MeshFileError if there are not as many bytes. */
  void
  Read(void * bytes, std::size_t size);

private:
  void
  Refill();
  [[noreturn]] void
  ThrowEnd() const;

  std::istream & m_File;
  std::uint64_t  m_Left;
  bool           m_Base64;

  // Decoded bytes that were not asked for yet, and the characters of a group of four that is incomplete.
  std::vector<unsigned char> m_Decoded;
  std::size_t                m_Position{ 0 };
  unsigned char              m_Group[4]{};
  unsigned int               m_GroupSize{ 0 };
  bool                       m_EndsInvalid{ false };
};
} // namespace mmm

#endif
