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
#include "input/MetaImageData.h"

#include "base/Trimmed.h"
#include "input/ImageChecks.h"
#include "input/LabelValue.h"

#include "itk_zlib.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

namespace mmm
{
namespace
{
namespace fs = std::filesystem;

struct Header
{
  std::map<std::string, std::string> fields;
  std::uint64_t                      size{ 0 };

  bool
  Is(const char * field, const char * value) const
  {
    const auto found = fields.find(field);
    return found != fields.end() && found->second == value;
  }
};

/** The lines "name = value", of which the one with the file of the data is the last. */
Header
ReadHeader(std::istream & stream)
{
  constexpr const char * blanks = " \t\r";
  Header                 header;
  for (std::string line; header.fields.count("ElementDataFile") == 0 && std::getline(stream, line);)
  {
    const auto separator = line.find_first_of("=:");
    if (separator != std::string::npos)
    {
      header.fields[Trimmed(line.substr(0, separator), blanks)] = Trimmed(line.substr(separator + 1), blanks);
    }
  }
  header.size = stream ? static_cast<std::uint64_t>(stream.tellg()) : 0;
  return header;
}

/** How many bytes the rest of a file is when it is uncompressed; 0 if it is broken. */
std::uint64_t
CountUncompressed(std::istream & stream)
{
  std::vector<char> input(1 << 16);
  std::vector<char> output(1 << 18);
  z_stream          zlib{};
  constexpr int     anyHeader = 32; // of zlib or gzip
  if (inflateInit2(&zlib, MAX_WBITS + anyHeader) != Z_OK)
  {
    return 0;
  }
  std::uint64_t count = 0;
  int           status = Z_OK;
  while (status == Z_OK)
  {
    if (zlib.avail_in == 0)
    {
      stream.read(input.data(), static_cast<std::streamsize>(input.size()));
      zlib.next_in = reinterpret_cast<Bytef *>(input.data());
      zlib.avail_in = static_cast<uInt>(stream.gcount());
    }
    zlib.next_out = reinterpret_cast<Bytef *>(output.data());
    zlib.avail_out = static_cast<uInt>(output.size());
    status = inflate(&zlib, Z_NO_FLUSH);
    count += output.size() - zlib.avail_out;
  }
  inflateEnd(&zlib);
  return status == Z_STREAM_END ? count : 0;
}
} // namespace

void
CheckMetaImageHeader(const std::string & fileName)
{
  std::ifstream stream(fs::u8path(fileName), std::ios::binary);
  const Header  header = ReadHeader(stream);
  const auto    found = header.fields.find("NDims");
  if (found == header.fields.end())
  {
    return; // ITK says that it is missing
  }
  constexpr double   most = 10.0; // the size of MetaIO's arrays
  double             dimensions = 0.0;
  std::istringstream text(found->second);
  if (!(text >> dimensions) || !(dimensions >= 1.0 && dimensions <= most))
  {
    ThrowDamaged(fileName, "its header says that it has " + found->second.substr(0, 20) + " dimensions");
  }
}

void
CheckMetaImageData(const std::string & fileName, double bytes)
{
  const fs::path path = fs::u8path(fileName);
  std::ifstream  stream(path, std::ios::binary);
  const Header   header = ReadHeader(stream);
  const auto     found = header.fields.find("ElementDataFile");
  if (found == header.fields.end() || header.Is("BinaryData", "False"))
  {
    return;
  }
  const std::string & dataFile = found->second;
  const bool          isLocal = dataFile == "LOCAL" || dataFile == "Local" || dataFile == "local";
  const bool          areMany = dataFile.find_first_of("% ") != std::string::npos || dataFile == "LIST";
  const fs::path      dataPath = isLocal ? path : path.parent_path() / fs::u8path(dataFile);
  if (areMany)
  {
    return;
  }
  if (!fs::is_regular_file(dataPath))
  {
    ThrowDamaged(fileName, "there is no file '" + dataFile + "' with its data");
  }
  if (!isLocal)
  {
    stream = std::ifstream(dataPath, std::ios::binary);
  }
  const std::uint64_t held = header.Is("CompressedData", "True")
                               ? CountUncompressed(stream)
                               : fs::file_size(dataPath) - (isLocal ? header.size : 0);
  if (static_cast<double>(held) < bytes)
  {
    ThrowDamaged(fileName,
                 "its data is broken or incomplete: " + std::to_string(held) + " bytes of " + DigitsOf(bytes) +
                   " can be read");
  }
}
} // namespace mmm
