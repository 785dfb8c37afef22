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
#include "itkOutputFile.h"

#include "itkMacro.h"
#include "itksys/SystemTools.hxx"

#include <cerrno>
#include <filesystem>
#include <locale>
#include <random>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace itk
{
namespace
{
namespace fs = std::filesystem;

[[noreturn]] void
ThrowSystemError(int error)
{
  throw std::runtime_error(std::generic_category().message(error));
}

[[noreturn]] void
ThrowCannotWrite(const std::string & fileName, const std::string & reason)
{
  itkGenericExceptionMacro("cannot write " << fileName << ": " << reason);
}

/** The name at the end of symbolic links, whether there is a file or not. */
fs::path
FollowLinks(fs::path path)
{
  // as many as Linux follows
  constexpr int   mostLinks = 40;
  std::error_code error;
  for (int n = 0; n < mostLinks && fs::is_symlink(path, error); ++n)
  {
    const fs::path target = fs::read_symlink(path, error);
    if (error)
    {
      break;
    }
    path = path.parent_path() / target;
  }
  return path;
}

/** ".gz" alone would not tell an image's format. */
std::string
ExtensionOf(const fs::path & path)
{
  const std::string last = path.extension().u8string();
  return last == ".gz" ? path.stem().extension().u8string() + last : last;
}
} // namespace

OutputFile::OutputFile(const std::string & fileName)
{
  const fs::path     path = FollowLinks(fs::u8path(fileName));
  std::random_device random;
  std::ostringstream name;
  name.imbue(std::locale::classic());
  // short, as the name itself may be as long as names can be
  name << '.' << std::hex << random() << random() << ExtensionOf(path);
  m_FileName = path.u8string();
  m_TemporaryName = fs::path(path).replace_filename(fs::u8path(name.str())).u8string();
}

OutputFile::~OutputFile()
{
  if (m_File != nullptr)
  {
    std::fclose(m_File);
  }
  if (!m_TemporaryName.empty())
  {
    std::error_code ignored;
    fs::remove(fs::u8path(m_TemporaryName), ignored);
  }
}

void
OutputFile::Write(const std::string & bytes)
{
  if (m_File == nullptr)
  {
    m_File = itksys::SystemTools::Fopen(m_TemporaryName, "wbx");
  }
  if (m_File == nullptr || std::fwrite(bytes.data(), 1, bytes.size(), m_File) != bytes.size())
  {
    ThrowSystemError(errno);
  }
}

void
OutputFile::Commit()
{
  // A full disk may show only now, when the last bytes leave the buffer of the C library.
  std::FILE * const file = m_File;
  m_File = nullptr;
  if (file != nullptr && std::fclose(file) != 0)
  {
    ThrowSystemError(errno);
  }
  const fs::path  path = fs::u8path(m_FileName);
  const fs::path  temporary = fs::u8path(m_TemporaryName);
  std::error_code error;
  const auto      old = fs::status(path, error);
  if (fs::exists(old))
  {
    // what cannot be kept, on a foreign file system for instance, is not worth a mesh
    fs::permissions(temporary, old.permissions(), error);
  }
  fs::rename(temporary, path, error);
  if (error)
  {
    throw std::runtime_error(error.message());
  }
  m_TemporaryName.clear();
}

void
OutputFile::WriteWhole(const std::string & fileName, const std::string & bytes)
{
  try
  {
    OutputFile file(fileName);
    file.Write(bytes);
    file.Commit();
  }
  catch (const std::runtime_error & error)
  {
    ThrowCannotWrite(fileName, error.what());
  }
}

void
OutputFile::CheckWritable(const std::string & fileName)
{
  const fs::path  path = FollowLinks(fs::u8path(fileName));
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
  try
  {
    OutputFile(fileName).Write("");
  }
  catch (const std::runtime_error & error)
  {
    ThrowCannotWrite(fileName, error.what());
  }
}

bool
OutputFile::IsSame(const std::string & first, const std::string & second)
{
  std::error_code error;
  const fs::path  a = fs::weakly_canonical(FollowLinks(fs::u8path(first)), error);
  const fs::path  b = fs::weakly_canonical(FollowLinks(fs::u8path(second)), error);
  return !error && (a == b || fs::equivalent(a, b, error));
}
} // namespace itk
