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
#ifndef mmmFileComposer_h
#define mmmFileComposer_h

#include "itkOutputFile.h"

#include <cstdint>
#include <string>

namespace mmm
{
/** \brief Writes a file of texts and of numbers, which are text or binary. It is there when Commit() is done. */
class FileComposer
{
public:
  FileComposer(const std::string & fileName, bool binary)
    : m_File(fileName)
    , m_Binary(binary)
  {}

  void
  Text(const std::string & text);

  /** Numbers in text are separated by blanks. The shortest texts are taken that give the same number again. */
  void
  Int(int value);
  void
  Size(std::uint64_t value);
  void
  Real(double value);

  /** Of numbers, in text. */
  void
  EndLine();

  /** After the last number of binary ones. */
  void
  EndNumbers();

  void
  Commit();

private:
  template <typename T>
  void
  Number(T value);
  void
  FlushIfLarge();

  itk::OutputFile m_File;
  bool            m_Binary;
  std::string     m_Buffer;
};
} // namespace mmm

#endif
