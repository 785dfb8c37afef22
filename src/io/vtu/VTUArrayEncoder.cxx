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
#include "io/vtu/VTUArrayEncoder.h"
#include "base/EscapedXML.h"
#include "base/Parallel.h"
#include "io/vtu/VTUFormat.h"

#include "itk_zlib.h"
#include "itksys/Base64.h"

#include <algorithm>

namespace mmm
{
namespace
{
constexpr std::size_t blockSize = 128 * 1024;
constexpr std::size_t blocksAtATime = 32;
constexpr std::size_t valuesPerLine = 12;

std::size_t
Base64Size(std::size_t bytes)
{
  return (bytes + 2) / 3 * 4;
}

std::vector<unsigned char>
Compress(const unsigned char * bytes, std::size_t size)
{
  auto                       compressedSize = compressBound(static_cast<uLong>(size));
  std::vector<unsigned char> compressed(compressedSize);
  if (compress2(compressed.data(), &compressedSize, bytes, static_cast<uLong>(size), Z_BEST_SPEED) != Z_OK)
  {
    throw MeshFileError("zlib failed to compress a block");
  }
  compressed.resize(compressedSize);
  return compressed;
}
} // namespace

VTUArrayEncoder::VTUArrayEncoder(VTUEncoding encoding, std::uint64_t numberOfBytes)
  : m_Encoding(encoding)
{
  if (encoding == VTUEncoding::Text)
  {
    return;
  }
  m_Pending.resize(static_cast<std::size_t>(std::min<std::uint64_t>(numberOfBytes, blocksAtATime * blockSize)));
  if (encoding == VTUEncoding::Base64)
  {
    // One stream of the size and the bytes.
    m_Text.reserve(Base64Size(static_cast<std::size_t>(numberOfBytes) + sizeof numberOfBytes));
    this->AppendBase64(reinterpret_cast<const unsigned char *>(&numberOfBytes), sizeof numberOfBytes);
    return;
  }
  // One stream of the number of blocks, their size, the size of the last one if it is smaller, and the compressed
  // sizes; another of the blocks. The first one's place is kept, as it is complete only at the end.
  const std::uint64_t blocks = (numberOfBytes + blockSize - 1) / blockSize;
  m_Header = { blocks, blockSize, numberOfBytes % blockSize };
  m_Header.reserve(static_cast<std::size_t>(3 + blocks));
  m_Text.resize(Base64Size(static_cast<std::size_t>(3 + blocks) * sizeof(std::uint64_t)));
}

std::string
VTUArrayEncoder::Finish()
{
  if (m_Encoding != VTUEncoding::Text)
  {
    this->EncodePending();
    this->FinishBase64();
  }
  if (m_Encoding == VTUEncoding::CompressedBase64)
  {
    itksysBase64_Encode(reinterpret_cast<const unsigned char *>(m_Header.data()),
                        m_Header.size() * sizeof(std::uint64_t),
                        reinterpret_cast<unsigned char *>(m_Text.data()),
                        0);
  }
  return std::move(m_Text);
}

void
VTUArrayEncoder::BeginWord()
{
  if (m_Column > 0)
  {
    m_Text += m_Column % valuesPerLine == 0 ? '\n' : ' ';
  }
  ++m_Column;
}

void
VTUArrayEncoder::EncodePending()
{
  if (m_Encoding == VTUEncoding::Base64)
  {
    this->AppendBase64(m_Pending.data(), m_Used);
    m_Used = 0;
    return;
  }
  const std::size_t                       blocks = (m_Used + blockSize - 1) / blockSize;
  std::vector<std::vector<unsigned char>> compressed(blocks);
  ParallelFor(blocks, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block)
    {
      const std::size_t first = block * blockSize;
      compressed[block] = Compress(m_Pending.data() + first, std::min(blockSize, m_Used - first));
    }
  });
  for (const auto & block : compressed)
  {
    m_Header.push_back(block.size());
    this->AppendBase64(block.data(), block.size());
  }
  m_Used = 0;
}

void
VTUArrayEncoder::AppendBase64(const unsigned char * bytes, std::size_t size)
{
  if (m_CarrySize > 0)
  {
    const std::size_t taken = std::min(size, 3 - m_CarrySize);
    std::copy_n(bytes, taken, m_Carry + m_CarrySize);
    m_CarrySize += taken;
    bytes += taken;
    size -= taken;
    if (m_CarrySize < 3)
    {
      return;
    }
    this->FinishBase64();
  }
  const std::size_t whole = size / 3 * 3;
  const std::size_t end = m_Text.size();
  m_Text.resize(end + Base64Size(whole));
  itksysBase64_Encode(bytes, whole, reinterpret_cast<unsigned char *>(&m_Text[end]), 0);
  m_CarrySize = size - whole;
  std::copy_n(bytes + whole, m_CarrySize, m_Carry);
}

void
VTUArrayEncoder::FinishBase64()
{
  const std::size_t end = m_Text.size();
  m_Text.resize(end + Base64Size(m_CarrySize));
  itksysBase64_Encode(m_Carry, m_CarrySize, reinterpret_cast<unsigned char *>(&m_Text[end]), 0);
  m_CarrySize = 0;
}

std::string
VTUArrayElement(const std::string & typeName,
                const std::string & name,
                std::size_t         numberOfComponents,
                VTUEncoding         encoding,
                const std::string & content)
{
  std::string element = "        <DataArray type=\"" + typeName + "\" Name=\"" + EscapedXML(name) + '"';
  if (numberOfComponents > 1)
  {
    element += " NumberOfComponents=\"" + std::to_string(numberOfComponents) + '"';
  }
  element += encoding == VTUEncoding::Text ? " format=\"ascii\">\n" : " format=\"binary\">\n";
  element.reserve(element.size() + content.size() + 32);
  element += content;
  element += "\n        </DataArray>\n";
  return element;
}
} // namespace mmm
