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
#ifndef mmmGzipFile_h
#define mmmGzipFile_h

#include "itk_zlib.h"

#include <memory>
#include <string>
#include <vector>

namespace mmm
{
/** \brief A file to read, whether it is compressed by gzip or not. */
class GzipFile
{
public:
  explicit GzipFile(const std::string & fileName);

  /** Returns how many bytes were there. */
  std::size_t
  Read(char * bytes, std::size_t count);

  bool
  IsBroken() const;

private:
  std::unique_ptr<gzFile_s, int (*)(gzFile)> m_File;
};

/** At most so many. Throws itk::ExceptionObject if they are compressed and damaged. */
std::vector<char>
FirstBytes(const std::string & fileName, std::size_t count);

/** Whether the name ends in one of these, such as ".gz", in capitals or not. */
bool
HasExtension(const std::string & fileName, const std::vector<std::string> & extensions);
} // namespace mmm

#endif
