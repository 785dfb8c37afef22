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
#include "input/GzipFile.h"

#include "input/ImageChecks.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace mmm
{
namespace fs = std::filesystem;

GzipFile::GzipFile(const std::string & fileName)
#ifdef _WIN32
  : m_File(gzopen_w(fs::u8path(fileName).c_str(), "rb"), gzclose)
#else
  : m_File(gzopen(fileName.c_str(), "rb"), gzclose)
#endif
{}

std::size_t
GzipFile::Read(char * bytes, std::size_t count)
{
  const int read = m_File ? gzread(m_File.get(), bytes, static_cast<unsigned int>(count)) : 0;
  return read > 0 ? static_cast<std::size_t>(read) : 0;
}

bool
GzipFile::IsBroken() const
{
  int error = Z_OK;
  if (m_File)
  {
    gzerror(m_File.get(), &error);
  }
  return error != Z_OK && error != Z_STREAM_END;
}

std::vector<char>
FirstBytes(const std::string & fileName, std::size_t count)
{
  GzipFile          file(fileName);
  std::vector<char> bytes(count);
  bytes.resize(file.Read(bytes.data(), count));
  if (file.IsBroken())
  {
    ThrowDamaged(fileName, "its compressed data is broken or incomplete");
  }
  return bytes;
}

bool
HasExtension(const std::string & fileName, const std::vector<std::string> & extensions)
{
  std::string extension = fs::u8path(fileName).extension().u8string();
  std::transform(
    extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}
} // namespace mmm
