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
#include "io/AtomicFile.h"

#include "itksys/Encoding.hxx"
#include "itksys/SystemTools.hxx"

#include <cerrno>
#include <filesystem>
#include <random>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace mmm
{
namespace
{
std::filesystem::path
ToPath(const std::string & fileName)
{
#ifdef _WIN32
  return itksys::Encoding::ToWide(fileName);
#else
  return fileName;
#endif
}

[[noreturn]] void
ThrowSystemError(int error)
{
  throw std::runtime_error(std::generic_category().message(error));
}
} // namespace

AtomicFile::AtomicFile(const std::string & fileName)
  : m_FileName(fileName)
{
  std::random_device random;
  std::ostringstream suffix;
  suffix.imbue(std::locale::classic());
  suffix << '.' << std::hex << random() << random() << ".tmp";
  m_TemporaryName = m_FileName + suffix.str();
  m_File = itksys::SystemTools::Fopen(m_TemporaryName, "wbx");
  if (m_File == nullptr)
  {
    ThrowSystemError(errno);
  }
}

AtomicFile::~AtomicFile()
{
  if (m_File != nullptr)
  {
    std::fclose(m_File);
  }
  if (!m_TemporaryName.empty())
  {
    std::error_code ignored;
    std::filesystem::remove(ToPath(m_TemporaryName), ignored);
  }
}

void
AtomicFile::Write(const std::string & text)
{
  if (std::fwrite(text.data(), 1, text.size(), m_File) != text.size())
  {
    ThrowSystemError(errno);
  }
}

void
AtomicFile::Commit()
{
  // A full disk may show only now, when the last bytes leave the buffer of the C library.
  std::FILE * const file = m_File;
  m_File = nullptr;
  if (std::fclose(file) != 0)
  {
    ThrowSystemError(errno);
  }
  std::error_code error;
  std::filesystem::rename(ToPath(m_TemporaryName), ToPath(m_FileName), error);
  if (error)
  {
    throw std::runtime_error(error.message());
  }
  m_TemporaryName.clear();
}
} // namespace mmm
