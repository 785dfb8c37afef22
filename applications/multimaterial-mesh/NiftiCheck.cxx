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
#include "NiftiCheck.h"

#include "itk_zlib.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <sstream>
#include <vector>

namespace cli
{
namespace
{
bool
EndsWith(const std::string & text, const std::string & end)
{
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/** Reads numbers of either byte order from the start of the file. */
class HeaderReader
{
public:
  explicit HeaderReader(const std::vector<char> & bytes)
    : m_Bytes(bytes)
  {
    const auto size = this->Get<std::int32_t>(0);
    m_IsSwapped = size != 348 && size != 540;
  }

  /** 348 for NIfTI-1, 540 for NIfTI-2. */
  std::int32_t
  HeaderSize() const
  {
    return this->Get<std::int32_t>(0);
  }

  template <typename T>
  T
  Get(std::size_t offset) const
  {
    char bytes[sizeof(T)];
    std::copy_n(m_Bytes.begin() + offset, sizeof(T), bytes);
    if (m_IsSwapped)
    {
      std::reverse(bytes, bytes + sizeof(T));
    }
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
  }

private:
  const std::vector<char> & m_Bytes;
  bool                      m_IsSwapped{ false };
};

/** The size that the uncompressed file has to have, as its header says. TDim and TOffset are what NIfTI-1 and 2 differ
 * in, besides the places of their fields. */
template <typename TDim, typename TOffset>
double
ExpectedSize(const HeaderReader & header, std::size_t dimensions, std::size_t bits, std::size_t offset)
{
  double size = header.Get<std::int16_t>(bits) / 8.0;
  for (int d = 1; d <= std::min<int>(header.Get<TDim>(dimensions), 7); ++d)
  {
    size *= double(header.Get<TDim>(dimensions + d * sizeof(TDim)));
  }
  return size + double(header.Get<TOffset>(offset));
}

double
ExpectedSize(const HeaderReader & header)
{
  switch (header.HeaderSize())
  {
    case 348:
      return ExpectedSize<std::int16_t, float>(header, 40, 72, 108);
    case 540:
      return ExpectedSize<std::int64_t, std::int64_t>(header, 16, 14, 168);
    default:
      return 0.0;
  }
}
} // namespace

std::string
FindNiftiDamage(const std::string & fileName)
{
  if (!EndsWith(fileName, ".nii") && !EndsWith(fileName, ".nii.gz"))
  {
    return "";
  }
  // zlib reads files that are not compressed, too.
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(fileName.c_str(), "rb"), gzclose);
  if (!file)
  {
    return "";
  }
  std::vector<char> bytes(1 << 20);
  double            expected = 0.0;
  double            size = 0.0;
  int               count = 0;
  while ((count = gzread(file.get(), bytes.data(), unsigned(bytes.size()))) > 0)
  {
    if (size == 0.0 && count >= 540)
    {
      expected = ExpectedSize(HeaderReader(bytes));
    }
    size += count;
  }
  int error = Z_OK;
  gzerror(file.get(), &error);
  if (error != Z_OK && error != Z_STREAM_END)
  {
    return "its compressed data is broken or incomplete";
  }
  if (size < expected)
  {
    std::ostringstream message;
    message.precision(15);
    message << "it holds " << size << " bytes of data where its header says " << expected;
    return message.str();
  }
  return "";
}
} // namespace cli
