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
#ifndef mmmFileCursor_h
#define mmmFileCursor_h

#include "io/CellMesh.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace mmm
{
/** \brief Goes through the bytes of a file, which are words and, if it is binary, also numbers as they are in memory.
 *
 * Whatever is not as asked for throws MeshFileError, which says where. */
class FileCursor
{
public:
  explicit FileCursor(std::string_view bytes)
    : m_Bytes(bytes)
  {}

  /** From here on, numbers are binary; with the bytes of each in the other order if `swapped`. */
  void
  SetBinary(bool swapped)
  {
    m_Binary = true;
    m_Swapped = swapped;
  }
  bool
  IsBinary() const
  {
    return m_Binary;
  }

  /** Skips blanks. */
  bool
  AtEnd();

  /** Up to the next blank. */
  std::string_view
  Word();

  /** What is left of the line. */
  std::string_view
  Line();

  /** Skips all up to and with the text. */
  void
  SkipPast(std::string_view text);

  /** Throws unless the next word is this one. */
  void
  Expect(std::string_view word);

  /** Numbers in words, or binary: of 4 and 8 bytes, and a double. */
  int
  Int();
  std::uint64_t
  Size();
  double
  Real();

  /** Numbers in words, always. */
  int
  IntWord();
  std::uint64_t
  SizeWord();
  double
  RealWord();

  /** Throws if what is left cannot hold `count` records of `numbers` numbers, of `bytes` bytes if they are binary; to
   * be asked before memory is allocated for them. */
  void
  CheckCount(std::uint64_t count, std::size_t numbers, std::size_t bytes, const std::string & what) const;

  [[noreturn]] void
  Fail(const std::string & what) const;

private:
  template <typename T>
  T
  Parse(std::string_view word, const char * kind) const;
  template <typename T>
  T
  Raw();

  std::string_view m_Bytes;
  std::size_t      m_Position{ 0 };
  bool             m_Binary{ false };
  bool             m_Swapped{ false };
};

/** For messages: the beginning of a word, in quotation marks. */
std::string
Quoted(std::string_view word);

/** The bytes of a file. Throws MeshFileError if there is no such file. */
std::string
ReadWholeFile(const std::string & fileName);
} // namespace mmm

#endif
