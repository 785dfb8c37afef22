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
#include "OutputFile.h"

#include "Errors.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <system_error>

namespace cli
{
namespace
{
namespace fs = std::filesystem;

std::string
ReasonOf(int error)
{
  return std::generic_category().message(error);
}

[[noreturn]] void
ThrowCannotWrite(const std::string & fileName, const std::string & reason)
{
  throw Error("cannot write " + fileName + ": " + reason);
}
} // namespace

OutputFile::OutputFile(const std::string & fileName)
  : m_FileName(fileName)
{
  std::random_device random;
  std::ostringstream name;
  name << '.' << std::hex << random() << random() << '-' << fs::u8path(fileName).filename().u8string();
  m_TemporaryName = fs::u8path(fileName).replace_filename(fs::u8path(name.str())).u8string();
}

OutputFile::~OutputFile()
{
  if (!m_TemporaryName.empty())
  {
    std::error_code ignored;
    fs::remove(fs::u8path(m_TemporaryName), ignored);
  }
}

void
OutputFile::Commit()
{
  std::error_code error;
  fs::rename(fs::u8path(m_TemporaryName), fs::u8path(m_FileName), error);
  if (error)
  {
    ThrowCannotWrite(m_FileName, error.message());
  }
  m_TemporaryName.clear();
}

void
CheckWritable(const std::string & fileName)
{
  const fs::path  path = fs::u8path(fileName);
  const fs::path  folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored))
  {
    ThrowCannotWrite(fileName, "the folder " + folder.u8string() + " does not exist; create it first");
  }
  if (fs::is_directory(path, ignored))
  {
    ThrowCannotWrite(fileName, "it is a folder");
  }
  if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored))
  {
    // Renaming would replace a device.
    ThrowCannotWrite(fileName, "it is not an ordinary file");
  }
  const OutputFile file(fileName);
  errno = 0;
  const std::ofstream stream(fs::u8path(file.GetTemporaryName()), std::ios::binary);
  if (!stream)
  {
    ThrowCannotWrite(fileName, ReasonOf(errno));
  }
}

void
WriteTextFile(const std::string & fileName, const std::string & text)
{
  OutputFile file(fileName);
  errno = 0;
  std::ofstream stream(fs::u8path(file.GetTemporaryName()), std::ios::binary);
  stream << text;
  stream.close();
  if (!stream)
  {
    ThrowCannotWrite(fileName, ReasonOf(errno));
  }
  file.Commit();
}

bool
IsSameFile(const std::string & first, const std::string & second)
{
  std::error_code error;
  const fs::path  a = fs::weakly_canonical(fs::u8path(first), error);
  const fs::path  b = fs::weakly_canonical(fs::u8path(second), error);
  return !error && a == b;
}
} // namespace cli
