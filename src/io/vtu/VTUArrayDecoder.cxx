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
#include "io/vtu/VTUArrayDecoder.h"
#include "base/Parallel.h"
#include "io/NumberText.h"
#include "io/vtu/VTUByteReader.h"

#include "itkByteSwapper.h"
#include "itk_zlib.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

namespace mmm
{
namespace
{
bool
SwapsBytes(const VTUDocument & document)
{
  return document.bigEndian != itk::ByteSwapper<int>::SystemIsBigEndian();
}

void
ReverseEach(void * values, std::size_t count, std::size_t size)
{
  auto * bytes = static_cast<unsigned char *>(values);
  for (std::size_t i = 0; i < count && size > 1; ++i, bytes += size)
  {
    std::reverse(bytes, bytes + size);
  }
}

[[noreturn]] void
ThrowUnexpectedCount(std::uint64_t announced, std::uint64_t expected)
{
  throw MeshFileError("holds " + std::to_string(announced) + " values, where " + std::to_string(expected) +
                      " are expected");
}

// Memory is allocated only for what was found to be in the file.
class BinaryArray
{
public:
  BinaryArray(std::istream & file, const VTUDocument & document, const VTUArray & array)
    : m_Document(document)
    , m_Reader(file, Begin(document, array), End(document, array), !(IsAppended(array) && !document.appendedBase64))
  {}

  /** expected: number of values. */
  std::vector<unsigned char>
  Read(std::optional<std::uint64_t> expected, std::size_t valueSize)
  {
    return m_Document.compressed ? this->ReadCompressed(expected, valueSize) : this->ReadPlain(expected, valueSize);
  }

private:
  static bool
  IsAppended(const VTUArray & array)
  {
    return array.format == "appended";
  }

  static std::uint64_t
  Begin(const VTUDocument & document, const VTUArray & array)
  {
    if (!IsAppended(array))
    {
      return array.begin;
    }
    if (!document.appendedBegin || !array.offset)
    {
      throw MeshFileError("is said to be appended, but the file does not say where");
    }
    if (*array.offset > document.fileSize - *document.appendedBegin)
    {
      throw MeshFileError("begins beyond the end of the file");
    }
    return *document.appendedBegin + *array.offset;
  }

  static std::uint64_t
  End(const VTUDocument & document, const VTUArray & array)
  {
    return IsAppended(array) ? document.fileSize : array.end;
  }

  std::uint64_t
  ReadHeaderNumber()
  {
    unsigned char bytes[8];
    m_Reader.Read(bytes, m_Document.headerSize);
    if (SwapsBytes(m_Document))
    {
      std::reverse(bytes, bytes + m_Document.headerSize);
    }
    std::uint32_t narrow = 0;
    std::uint64_t wide = 0;
    std::memcpy(&narrow, bytes, sizeof narrow);
    std::memcpy(&wide, bytes, m_Document.headerSize == 8 ? sizeof wide : 0);
    return m_Document.headerSize == 8 ? wide : narrow;
  }

  static void
  CheckSize(std::uint64_t bytes, std::optional<std::uint64_t> expected, std::size_t valueSize)
  {
    if (bytes % valueSize != 0)
    {
      throw MeshFileError("ends in the middle of a value");
    }
    if (expected && bytes / valueSize != *expected)
    {
      ThrowUnexpectedCount(bytes / valueSize, *expected);
    }
  }

  std::vector<unsigned char>
  ReadPlain(std::optional<std::uint64_t> expected, std::size_t valueSize)
  {
    const std::uint64_t size = this->ReadHeaderNumber();
    CheckSize(size, expected, valueSize);
    return this->ReadBytes(size);
  }

  std::vector<unsigned char>
  ReadBytes(std::uint64_t size)
  {
    if (size > m_Reader.Available())
    {
      throw MeshFileError("announces " + std::to_string(size) + " bytes, but the file ends before them");
    }
    std::vector<unsigned char> bytes(static_cast<std::size_t>(size));
    m_Reader.Read(bytes.data(), bytes.size());
    return bytes;
  }

  std::vector<unsigned char>
  ReadCompressed(std::optional<std::uint64_t> expected, std::size_t valueSize);

  const VTUDocument & m_Document;
  VTUByteReader       m_Reader;
};

std::vector<unsigned char>
BinaryArray::ReadCompressed(std::optional<std::uint64_t> expected, std::size_t valueSize)
{
  const std::uint64_t blocks = this->ReadHeaderNumber();
  const std::uint64_t blockSize = this->ReadHeaderNumber();
  const std::uint64_t lastSize = this->ReadHeaderNumber();
  if (blocks > m_Reader.Available() / m_Document.headerSize)
  {
    throw MeshFileError("announces " + std::to_string(blocks) + " blocks, but the file ends before them");
  }
  if (lastSize > blockSize || blockSize > std::numeric_limits<std::uint32_t>::max() ||
      blocks > std::numeric_limits<std::uint32_t>::max())
  {
    throw MeshFileError("has blocks of an impossible size");
  }
  const std::uint64_t missing = blocks > 0 && lastSize > 0 ? blockSize - lastSize : 0;
  const std::uint64_t size = blocks * blockSize - missing;
  CheckSize(size, expected, valueSize);

  // Deflate makes 258 bytes of two bits at best.
  constexpr std::uint64_t largestRatio = 1032;
  const auto sizeOfBlock = [&](std::uint64_t block) { return block + 1 < blocks ? blockSize : blockSize - missing; };
  // Where each compressed block begins, and where the last one ends.
  std::vector<std::size_t> begins{ 0 };
  begins.reserve(static_cast<std::size_t>(blocks + 1));
  for (std::uint64_t block = 0; block < blocks; ++block)
  {
    const std::uint64_t compressedSize = this->ReadHeaderNumber();
    if (compressedSize > m_Reader.Available() || sizeOfBlock(block) / largestRatio > compressedSize)
    {
      throw MeshFileError("has a compressed block of an impossible size");
    }
    begins.push_back(begins.back() + static_cast<std::size_t>(compressedSize));
    if (begins.back() > m_Reader.Available())
    {
      throw MeshFileError("announces more compressed bytes than the file has");
    }
  }

  const std::vector<unsigned char> compressed = this->ReadBytes(begins.back());
  std::vector<unsigned char>       bytes(static_cast<std::size_t>(size));
  // Small blocks are not worth a thread each.
  const std::size_t grain = 1 + (std::size_t{ 1 } << 18) / static_cast<std::size_t>(blockSize + 1);
  ParallelFor(static_cast<std::size_t>(blocks), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block)
    {
      auto       blockBytes = static_cast<uLongf>(sizeOfBlock(block));
      const auto compressedSize = static_cast<uLong>(begins[block + 1] - begins[block]);
      const int  status = uncompress(bytes.data() + block * static_cast<std::size_t>(blockSize),
                                    &blockBytes,
                                    compressed.data() + begins[block],
                                    compressedSize);
      if (status != Z_OK || blockBytes != sizeOfBlock(block))
      {
        throw MeshFileError("has a compressed block that is damaged");
      }
    }
  });
  return bytes;
}

/** Calls body(word) for each word of the text of an array. */
template <typename TBody>
void
ForEachWord(std::istream & file, const VTUArray & array, TBody body)
{
  std::string text(static_cast<std::size_t>(array.end - array.begin), ' ');
  VTUByteReader(file, array.begin, array.end, false).Read(text.data(), text.size());
  const char * const end = text.data() + text.size();
  const char *       word = std::find_if_not(static_cast<const char *>(text.data()), end, IsBlank);
  while (word != end)
  {
    const char * const wordEnd = std::find_if(word, end, IsBlank);
    body(std::string_view(word, wordEnd - word));
    word = std::find_if_not(wordEnd, end, IsBlank);
  }
}

template <typename T>
std::vector<unsigned char>
ReadText(std::istream & file, const VTUArray & array, std::optional<std::uint64_t> expected)
{
  // A value takes two characters, the blank included.
  const std::uint64_t most = (array.end - array.begin) / 2 + 1;
  if (expected && *expected > most)
  {
    throw MeshFileError("is too short for the " + std::to_string(*expected) + " values that are expected");
  }
  std::vector<unsigned char> bytes;
  bytes.reserve(static_cast<std::size_t>(expected.value_or(0)) * sizeof(T));
  ForEachWord(file, array, [&](std::string_view word) {
    // Bytes are numbers here, not characters.
    std::conditional_t<sizeof(T) == 1, int, T> value{};
    if (!ParseNumber(word, value) || (sizeof(T) == 1 && static_cast<T>(value) != value))
    {
      throw MeshFileError("has \"" + std::string(word.substr(0, 20)) + "\" where a number is expected");
    }
    const auto         stored = static_cast<T>(value);
    const auto * const first = reinterpret_cast<const unsigned char *>(&stored);
    bytes.insert(bytes.end(), first, first + sizeof stored);
  });
  if (expected && bytes.size() / sizeof(T) != *expected)
  {
    ThrowUnexpectedCount(bytes.size() / sizeof(T), *expected);
  }
  return bytes;
}

VTUValues
ReadValues(std::istream &               file,
           const VTUDocument &          document,
           const VTUArray &             array,
           std::optional<std::uint64_t> expected)
{
  VTUValues values;
  values.type = ComponentTypeOfVTU(array.type);
  if (expected == std::uint64_t{ 0 })
  {
    return values;
  }
  VisitComponentType(values.type, [&](auto zero) {
    using T = decltype(zero);
    if (array.format == "ascii")
    {
      values.bytes = ReadText<T>(file, array, expected);
    }
    else if (array.format == "binary" || array.format == "appended")
    {
      values.bytes = BinaryArray(file, document, array).Read(expected, sizeof(T));
      if (SwapsBytes(document))
      {
        ReverseEach(values.bytes.data(), values.bytes.size() / sizeof(T), sizeof(T));
      }
    }
    else
    {
      throw MeshFileError("has the unknown format \"" + array.format + '"');
    }
    values.count = values.bytes.size() / sizeof(T);
  });
  return values;
}
} // namespace

std::int64_t
VTUValues::IntegerAt(std::size_t index) const
{
  return VisitComponentType(type, [&](auto value) -> std::int64_t {
    if constexpr (std::is_integral_v<decltype(value)>)
    {
      std::memcpy(&value, bytes.data() + index * sizeof value, sizeof value);
      constexpr auto largest = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
      return value > 0 && static_cast<std::uint64_t>(value) > largest ? -1 : static_cast<std::int64_t>(value);
    }
    else
    {
      throw MeshFileError("has values that are not integers");
    }
  });
}

VTUValues
ReadVTUArray(std::istream &               file,
             const VTUDocument &          document,
             const VTUArray &             array,
             std::optional<std::uint64_t> expected)
{
  try
  {
    return ReadValues(file, document, array, expected);
  }
  catch (const MeshFileError & error)
  {
    throw MeshFileError("its array \"" + array.name + "\" " + error.what());
  }
}

std::string
ReadVTUString(std::istream & file, const VTUDocument & document, const VTUArray & array)
{
  VTUArray characters = array;
  characters.type = "UInt8";
  const VTUValues values = ReadVTUArray(file, document, characters, std::nullopt);
  return { values.bytes.begin(), std::find(values.bytes.begin(), values.bytes.end(), 0) };
}
} // namespace mmm
