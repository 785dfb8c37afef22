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
#include "io/vtu/VTUDocument.h"
#include "io/NumberText.h"
#include "io/vtu/VTUFormat.h"

// The header of ITK's own or the system's expat: ITK installs the first name from version 6 on.
#if __has_include("itk_expat.h")
#  include "itk_expat.h"
#else
#  include "expat.h"
#endif

#include <algorithm>
#include <cstring>
#include <exception>
#include <memory>
#include <type_traits>

namespace mmm
{
namespace
{
/** The attributes of one tag. */
class Attributes
{
public:
  Attributes(const char * tag, const char ** namesAndValues)
    : m_Tag(tag)
    , m_NamesAndValues(namesAndValues)
  {}

  std::string
  Get(const char * name, const char * fallback = "") const
  {
    for (const char ** item = m_NamesAndValues; *item != nullptr; item += 2)
    {
      if (std::strcmp(*item, name) == 0)
      {
        return item[1];
      }
    }
    return fallback;
  }

  std::optional<std::uint64_t>
  GetNumber(const char * name) const
  {
    const std::string text = this->Get(name);
    if (text.empty())
    {
      return std::nullopt;
    }
    std::uint64_t value = 0;
    if (!ParseNumber(text, value))
    {
      throw MeshFileError("<" + m_Tag + "> has " + name + "=\"" + text + "\", which is not a count");
    }
    return value;
  }

  std::uint64_t
  GetCount(const char * name) const
  {
    const auto value = this->GetNumber(name);
    if (!value)
    {
      throw MeshFileError("<" + m_Tag + "> has no " + name);
    }
    return *value;
  }

private:
  std::string   m_Tag;
  const char ** m_NamesAndValues;
};

class Parser
{
public:
  VTUDocument
  Parse(std::istream & file);

private:
  // Exceptions must not pass through expat, which is written in C.
  template <typename TBody>
  void
  Guard(TBody body) noexcept
  {
    try
    {
      if (!m_Failure)
      {
        body();
      }
    }
    catch (...)
    {
      m_Failure = std::current_exception();
      XML_StopParser(m_Expat.get(), XML_FALSE);
    }
  }

  static void XMLCALL
  OnStart(void * self, const XML_Char * tag, const XML_Char ** attributes)
  {
    auto * const parser = static_cast<Parser *>(self);
    parser->Guard([=] { parser->Start(tag, Attributes(tag, attributes)); });
  }
  static void XMLCALL
  OnEnd(void * self, const XML_Char *)
  {
    auto * const parser = static_cast<Parser *>(self);
    parser->Guard([=] { parser->End(); });
  }
  static void XMLCALL
  OnText(void * self, const XML_Char * text, int size)
  {
    auto * const parser = static_cast<Parser *>(self);
    if (parser->m_Array != nullptr && !parser->m_ArrayHasText && parser->m_Path.size() == parser->m_ArrayDepth)
    {
      parser->m_ArrayHasText = !std::all_of(text, text + size, IsBlank);
    }
  }
  static void XMLCALL
  OnDoctype(void * self, const XML_Char *, const XML_Char *, const XML_Char *, int)
  {
    auto * const parser = static_cast<Parser *>(self);
    parser->Guard([] { throw MeshFileError("it has a document type declaration, which .vtu files have not"); });
  }

  void
  Start(const std::string & tag, const Attributes & attributes);
  void
  StartFile(const std::string & tag, const Attributes & attributes);
  void
  StartArray(const Attributes & attributes);
  void
  End();

  std::uint64_t
  TagBegin() const
  {
    return XML_GetCurrentByteIndex(m_Expat.get());
  }
  std::uint64_t
  TagEnd() const
  {
    return this->TagBegin() + XML_GetCurrentByteCount(m_Expat.get());
  }
  void
  FindAppendedData(std::istream & file);

  std::unique_ptr<std::remove_pointer_t<XML_Parser>, decltype(&XML_ParserFree)> m_Expat{ XML_ParserCreate(nullptr),
                                                                                         &XML_ParserFree };

  VTUDocument              m_Document;
  std::exception_ptr       m_Failure;
  std::vector<std::string> m_Path;
  unsigned int             m_Pieces{ 0 };

  // The section and the array that the parser is in, if any.
  std::vector<VTUArray> * m_Section{ nullptr };
  std::size_t             m_SectionDepth{ 0 };
  VTUArray *              m_Array{ nullptr };
  std::size_t             m_ArrayDepth{ 0 };
  bool                    m_ArrayHasText{ false };
  bool                    m_ArrayEnded{ false };
};

void
Parser::Start(const std::string & tag, const Attributes & attributes)
{
  const std::size_t depth = m_Path.size();
  if (depth == 0)
  {
    this->StartFile(tag, attributes);
  }
  else if (depth == 1 && tag == "AppendedData")
  {
    // What follows may be raw bytes, which are no XML.
    const std::string encoding = attributes.Get("encoding", "raw");
    if (encoding != "raw" && encoding != "base64")
    {
      throw MeshFileError("its appended data has the unknown encoding \"" + encoding + '"');
    }
    m_Document.appendedBase64 = encoding == "base64";
    m_Document.appendedBegin = this->TagEnd();
    XML_StopParser(m_Expat.get(), XML_FALSE);
  }
  else if (depth == 2 && m_Path[1] == "UnstructuredGrid")
  {
    if (tag == "Piece")
    {
      if (++m_Pieces > 1)
      {
        throw MeshFileError("it has several pieces; only files with one are supported");
      }
      m_Document.numberOfPoints = attributes.GetCount("NumberOfPoints");
      m_Document.numberOfCells = attributes.GetCount("NumberOfCells");
    }
    else if (tag == "FieldData")
    {
      m_Section = &m_Document.fieldData;
      m_SectionDepth = 3;
    }
  }
  else if (depth == 3 && m_Path[1] == "UnstructuredGrid" && m_Path[2] == "Piece")
  {
    m_Section = tag == "PointData"  ? &m_Document.pointData
                : tag == "CellData" ? &m_Document.cellData
                : tag == "Points"   ? &m_Document.points
                : tag == "Cells"    ? &m_Document.cells
                                    : nullptr;
    m_SectionDepth = 4;
  }
  else if (m_Array != nullptr)
  {
    // VTK puts <InformationKey> tags around the values.
    if (depth == m_ArrayDepth && m_ArrayHasText && !m_ArrayEnded)
    {
      m_Array->end = this->TagBegin();
      m_ArrayEnded = true;
    }
  }
  else if (m_Section != nullptr && (tag == "DataArray" || (tag == "Array" && m_Section == &m_Document.fieldData)))
  {
    this->StartArray(attributes);
  }
  m_Path.push_back(tag);
}

void
Parser::StartFile(const std::string & tag, const Attributes & attributes)
{
  if (tag != "VTKFile")
  {
    throw MeshFileError("it is not a VTK file: it begins with <" + tag + ">");
  }
  const std::string type = attributes.Get("type");
  if (type != "UnstructuredGrid")
  {
    throw MeshFileError("it is a VTK file of type \"" + type + "\", not UnstructuredGrid");
  }
  const std::string byteOrder = attributes.Get("byte_order", "LittleEndian");
  if (byteOrder != "LittleEndian" && byteOrder != "BigEndian")
  {
    throw MeshFileError("its byte order \"" + byteOrder + "\" is unknown");
  }
  m_Document.bigEndian = byteOrder == "BigEndian";
  const std::string headerType = attributes.Get("header_type", "UInt32");
  if (headerType != "UInt32" && headerType != "UInt64")
  {
    throw MeshFileError("its header type \"" + headerType + "\" is unknown");
  }
  m_Document.headerSize = headerType == "UInt64" ? 8 : 4;
  const std::string compressor = attributes.Get("compressor");
  if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
  {
    throw MeshFileError("its data is compressed by \"" + compressor + "\"; only vtkZLibDataCompressor is supported");
  }
  m_Document.compressed = !compressor.empty();
}

void
Parser::StartArray(const Attributes & attributes)
{
  VTUArray array;
  array.name = attributes.Get("Name");
  array.type = attributes.Get("type");
  array.format = attributes.Get("format", "ascii");
  array.numberOfComponents = attributes.GetNumber("NumberOfComponents").value_or(1);
  array.offset = attributes.GetNumber("offset");
  array.begin = this->TagEnd();
  m_Section->push_back(array);
  m_Array = &m_Section->back();
  m_ArrayDepth = m_Path.size() + 1;
  m_ArrayHasText = false;
  m_ArrayEnded = false;
}

void
Parser::End()
{
  m_Path.pop_back();
  const std::size_t depth = m_Path.size();
  if (m_Array != nullptr && depth == m_ArrayDepth && !m_ArrayHasText)
  {
    m_Array->begin = this->TagEnd();
  }
  else if (m_Array != nullptr && depth < m_ArrayDepth)
  {
    if (!m_ArrayEnded)
    {
      // The tag of an empty element is start and end at once.
      m_Array->end = std::max(m_Array->begin, this->TagBegin());
    }
    m_Array = nullptr;
  }
  else if (m_Section != nullptr && depth < m_SectionDepth)
  {
    m_Section = nullptr;
  }
}

void
Parser::FindAppendedData(std::istream & file)
{
  file.clear();
  file.seekg(static_cast<std::streamoff>(*m_Document.appendedBegin));
  for (char c = ' '; IsBlank(c); ++*m_Document.appendedBegin)
  {
    if (!file.get(c))
    {
      throw MeshFileError("it ends before its appended data");
    }
    if (!IsBlank(c) && c != '_')
    {
      throw MeshFileError("its appended data does not begin with an underscore");
    }
  }
}

VTUDocument
Parser::Parse(std::istream & file)
{
  if (m_Expat == nullptr)
  {
    throw std::bad_alloc();
  }
  file.seekg(0, std::ios::end);
  m_Document.fileSize = static_cast<std::uint64_t>(file.tellg());
  file.seekg(0);
  if (!file)
  {
    throw MeshFileError("it cannot be read");
  }

  XML_SetUserData(m_Expat.get(), this);
  XML_SetElementHandler(m_Expat.get(), OnStart, OnEnd);
  XML_SetCharacterDataHandler(m_Expat.get(), OnText);
  XML_SetStartDoctypeDeclHandler(m_Expat.get(), OnDoctype);
  std::vector<char> chunk(1 << 16);
  for (bool last = false; !last && !m_Document.appendedBegin;)
  {
    file.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
    last = !file;
    const auto status = XML_Parse(m_Expat.get(), chunk.data(), static_cast<int>(file.gcount()), last);
    if (m_Failure)
    {
      std::rethrow_exception(m_Failure);
    }
    if (status != XML_STATUS_OK && !m_Document.appendedBegin)
    {
      throw MeshFileError("line " + std::to_string(XML_GetCurrentLineNumber(m_Expat.get())) + ": " +
                          XML_ErrorString(XML_GetErrorCode(m_Expat.get())));
    }
  }
  if (m_Pieces == 0)
  {
    throw MeshFileError("it has no <Piece> with a mesh");
  }
  if (m_Document.appendedBegin)
  {
    this->FindAppendedData(file);
  }
  return std::move(m_Document);
}
} // namespace

VTUDocument
ParseVTUDocument(std::istream & file)
{
  return Parser().Parse(file);
}
} // namespace mmm
