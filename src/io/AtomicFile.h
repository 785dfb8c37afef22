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
#ifndef mmmAtomicFile_h
#define mmmAtomicFile_h

#include <cstddef>
#include <cstdio>
#include <string>

namespace mmm
{
/** \brief A file that appears under its name only when it is complete.
 *
 * It is written under a temporary name in the same folder, which Commit() replaces by its own. An object that goes
 * without Commit() leaves nothing behind. Failures throw std::runtime_error with the reason of the operating system. */
class AtomicFile
{
public:
  explicit AtomicFile(const std::string & fileName);
  ~AtomicFile();
  AtomicFile(const AtomicFile &) = delete;
  AtomicFile &
  operator=(const AtomicFile &) = delete;

  void
  Write(const std::string & text);

  void
  Commit();

private:
  std::string m_FileName;
  std::string m_TemporaryName;
  std::FILE * m_File{ nullptr };
};
} // namespace mmm

#endif
