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
#ifndef OutputFile_h
#define OutputFile_h

#include <string>

namespace cli
{
/** \brief A file that appears under its name only when it is complete.
 *
 * Whatever is written goes to the temporary name, in the same folder and with the same extension. Without Commit()
 * nothing is left behind. */
class OutputFile
{
public:
  explicit OutputFile(const std::string & fileName);
  ~OutputFile();
  OutputFile(const OutputFile &) = delete;
  OutputFile &
  operator=(const OutputFile &) = delete;

  const std::string &
  GetTemporaryName() const
  {
    return m_TemporaryName;
  }

  /** Throws Error if the file cannot be renamed. */
  void
  Commit();

private:
  std::string m_FileName;
  std::string m_TemporaryName;
};

/** Throws Error if the file could not be written now. It leaves no trace. */
void
CheckWritable(const std::string & fileName);

/** Throws Error if that fails. */
void
WriteTextFile(const std::string & fileName, const std::string & text);

/** Whether both names stand for one file, which need not exist. */
bool
IsSameFile(const std::string & first, const std::string & second);
} // namespace cli

#endif
