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
#ifndef itkOutputFile_h
#define itkOutputFile_h

#include "MultiMaterialMeshingExport.h"

#include <cstdio>
#include <string>

namespace itk
{
/** \class OutputFile
 * \brief A file that appears under its name only when it is complete.
 *
 * It is written under a temporary name of the same extension in the same folder, by Write() or by somebody else;
 * Commit() gives it its own name. An object that goes without Commit() leaves nothing behind, and an older file stays
 * until then. A symbolic link stays one, and the file that it points to is replaced. The new file has the permissions
 * of the old one.
 *
 * Write() and Commit() throw std::runtime_error with the operating system's reason; the functions that take a name
 * throw an ExceptionObject that says "cannot write", the name and the reason. Names are UTF-8.
 *
 * \ingroup IOFilters
 * \ingroup MultiMaterialMeshing
 */
class MultiMaterialMeshing_EXPORT OutputFile
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

  /** Appends bytes. */
  void
  Write(const std::string & bytes);

  void
  Commit();

  /** Writes a file of these bytes. */
  static void
  WriteWhole(const std::string & fileName, const std::string & bytes);

  /** Throws if the file could not be written now. It leaves no trace. */
  static void
  CheckWritable(const std::string & fileName);

  /** Whether both names stand for one file, which need not exist. */
  static bool
  IsSame(const std::string & first, const std::string & second);

private:
  std::string m_FileName;
  std::string m_TemporaryName;
  std::FILE * m_File{ nullptr };
};
} // namespace itk

#endif
