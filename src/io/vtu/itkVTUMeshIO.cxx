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
#include "itkVTUMeshIO.h"

#include "io/CellArrays.h"
#include "io/vtu/VTUArrayDecoder.h"
#include "io/vtu/VTUArrayEncoder.h"
#include "io/vtu/VTUCells.h"
#include "io/vtu/VTUDocument.h"
#include "io/vtu/VTUFile.h"
#include "io/vtu/VTUFormat.h"
#include "io/vtu/VTUPixels.h"
#include "io/vtu/VTUPoints.h"

#include "itksys/FStream.hxx"
#include "itksys/SystemTools.hxx"

#include <algorithm>
#include <cstring>
#include <exception>
#include <utility>

namespace itk
{
namespace
{
constexpr const char * defaultCellDataName = "label";

bool
HasVTUExtension(const std::string & fileName)
{
  return itksys::SystemTools::LowerCase(itksys::SystemTools::GetFilenameLastExtension(fileName)) == ".vtu";
}

/** The pixels of the cells that the file's cells were split into. */
void
RepeatPixels(mmm::VTUPixels & pixels, const std::vector<std::size_t> & sources)
{
  const std::size_t          size = pixels.numberOfComponents * pixels.values.ValueSize();
  std::vector<unsigned char> bytes(sources.size() * size);
  for (std::size_t i = 0; i < sources.size(); ++i)
  {
    std::memcpy(&bytes[i * size], &pixels.values.bytes[sources[i] * size], size);
  }
  pixels.values.bytes = std::move(bytes);
  pixels.values.count = sources.size() * pixels.numberOfComponents;
}

/** No data, that is no components, counts as a scalar, as ITK has it. */
IOPixelEnum
PixelTypeOf(std::size_t numberOfComponents)
{
  return numberOfComponents <= 1 ? IOPixelEnum::SCALAR : IOPixelEnum::FIXEDARRAY;
}

/** The names if there is one per component. */
VTUMeshIO::NamesType
NamesFor(unsigned int numberOfComponents, const VTUMeshIO::NamesType & names, const VTUMeshIO::NamesType & fallback)
{
  return !names.empty() && names.size() == numberOfComponents ? names : fallback;
}

void
PrintNames(std::ostream & os, const std::vector<std::string> & names)
{
  for (const std::string & name : names)
  {
    os << ' ' << name;
  }
  os << std::endl;
}
} // namespace

struct VTUMeshIO::ReadState
{
  std::vector<unsigned char>  points;
  std::vector<IdentifierType> cells;
  std::vector<unsigned char>  pointData;
  std::vector<unsigned char>  cellData;
};

struct VTUMeshIO::WriteState : mmm::VTUContent
{};

VTUMeshIO::VTUMeshIO()
{
  m_FileType = IOFileEnum::BINARY;
  m_UseCompression = true;
  this->AddSupportedReadExtension(".vtu");
  this->AddSupportedWriteExtension(".vtu");
}

VTUMeshIO::~VTUMeshIO() = default;

void
VTUMeshIO::SetCellDataNames(const NamesType & names)
{
  if (names != m_CellDataNames)
  {
    m_CellDataNames = names;
    this->Modified();
  }
}

void
VTUMeshIO::SetPointDataNames(const NamesType & names)
{
  if (names != m_PointDataNames)
  {
    m_PointDataNames = names;
    this->Modified();
  }
}

void
VTUMeshIO::SetCellArrays(const CellArraysType & arrays)
{
  m_CellArrays = arrays;
  this->Modified();
}

void
VTUMeshIO::SetLabelTable(const mmm::LabelTable & table)
{
  m_LabelTable = table;
  this->Modified();
}

bool
VTUMeshIO::CanReadFile(const char * fileName)
{
  return fileName != nullptr && HasVTUExtension(fileName) && itksys::SystemTools::FileExists(fileName, true);
}

bool
VTUMeshIO::CanWriteFile(const char * fileName)
{
  return fileName != nullptr && HasVTUExtension(fileName);
}

void
VTUMeshIO::ReadMeshInformation()
{
  m_Read = nullptr;
  try
  {
    itksys::ifstream file(m_FileName.c_str(), std::ios::in | std::ios::binary);
    if (!file)
    {
      throw mmm::MeshFileError("it cannot be opened: " + itksys::SystemTools::GetLastSystemError());
    }
    auto                   read = std::make_unique<ReadState>();
    const mmm::VTUDocument document = mmm::ParseVTUDocument(file);

    mmm::VTUValues points = mmm::ReadVTUPoints(file, document);
    mmm::VTUCells  cells = mmm::ReadVTUCells(file, document);

    const bool usesDefaultNames = m_CellDataNames == NamesType{ defaultCellDataName };
    const auto pointArrays = mmm::SelectPixelArrays(document.pointData, m_PointDataNames, "");
    const auto cellArrays =
      mmm::SelectPixelArrays(document.cellData, usesDefaultNames ? NamesType{} : m_CellDataNames, defaultCellDataName);
    mmm::VTUPixels pointPixels = mmm::ReadVTUPixels(file, document, pointArrays, document.numberOfPoints);
    mmm::VTUPixels cellPixels = mmm::ReadVTUPixels(file, document, cellArrays, document.numberOfCells);
    if (!cells.sources.empty() && cellPixels.values.count > 0)
    {
      RepeatPixels(cellPixels, cells.sources);
    }

    m_ReadCellDataNames.clear();
    for (const mmm::VTUArray & array : cellArrays)
    {
      m_ReadCellDataNames.push_back(array.name);
    }
    m_ByteOrder = document.bigEndian ? IOByteOrderEnum::BigEndian : IOByteOrderEnum::LittleEndian;
    m_PointDimension = mmm::vtuDimension;

    m_NumberOfPoints = points.count / mmm::vtuDimension;
    m_PointComponentType = points.type;
    m_UpdatePoints = m_NumberOfPoints > 0;
    read->points = std::move(points.bytes);

    m_NumberOfCells = cells.count;
    m_CellBufferSize = cells.buffer.size();
    m_CellComponentType = MapComponentType<IdentifierType>::CType;
    m_UpdateCells = m_NumberOfCells > 0;
    read->cells = std::move(cells.buffer);

    m_UpdatePointData = pointPixels.values.count > 0;
    m_NumberOfPointPixels = m_UpdatePointData ? m_NumberOfPoints : 0;
    m_NumberOfPointPixelComponents = static_cast<unsigned int>(pointPixels.numberOfComponents);
    m_PointPixelComponentType = pointPixels.values.type;
    m_PointPixelType = PixelTypeOf(pointPixels.numberOfComponents);
    read->pointData = std::move(pointPixels.values.bytes);

    m_UpdateCellData = cellPixels.values.count > 0;
    m_NumberOfCellPixels = m_UpdateCellData ? m_NumberOfCells : 0;
    m_NumberOfCellPixelComponents = static_cast<unsigned int>(cellPixels.numberOfComponents);
    m_CellPixelComponentType = cellPixels.values.type;
    m_CellPixelType = PixelTypeOf(cellPixels.numberOfComponents);
    read->cellData = std::move(cellPixels.values.bytes);

    m_Read = std::move(read);
  }
  catch (const std::exception & error)
  {
    itkExceptionMacro("Cannot read \"" << m_FileName << "\": " << mmm::ReasonOf(error));
  }
}

template <typename T>
void
VTUMeshIO::HandOver(std::vector<T> ReadState::* part, void * buffer)
{
  if (m_Read == nullptr || ((*m_Read).*part).empty())
  {
    itkExceptionMacro("ReadMeshInformation() must be called before each reading of a part of \"" << m_FileName << '"');
  }
  std::memcpy(buffer, ((*m_Read).*part).data(), ((*m_Read).*part).size() * sizeof(T));
  ((*m_Read).*part) = {};
}

void
VTUMeshIO::ReadPoints(void * buffer)
{
  this->HandOver(&ReadState::points, buffer);
}

void
VTUMeshIO::ReadCells(void * buffer)
{
  this->HandOver(&ReadState::cells, buffer);
}

void
VTUMeshIO::ReadPointData(void * buffer)
{
  this->HandOver(&ReadState::pointData, buffer);
}

void
VTUMeshIO::ReadCellData(void * buffer)
{
  this->HandOver(&ReadState::cellData, buffer);
}

void
VTUMeshIO::WriteMeshInformation()
{
  m_Written = std::make_unique<WriteState>();
  m_Written->encoding = m_FileType == IOFileEnum::ASCII ? mmm::VTUEncoding::Text
                        : m_UseCompression              ? mmm::VTUEncoding::CompressedBase64
                                                        : mmm::VTUEncoding::Base64;
  m_Written->fieldData = mmm::VTUFieldData(m_WriteSpace, m_LabelTable);
}

template <typename TBody>
void
VTUMeshIO::WritePart(TBody body)
{
  if (m_Written == nullptr)
  {
    itkExceptionMacro("WriteMeshInformation() must be called before the parts of \"" << m_FileName << "\" are written");
  }
  try
  {
    body(*m_Written);
  }
  catch (const std::exception & error)
  {
    m_Written = nullptr;
    itkExceptionMacro("Cannot write \"" << m_FileName << "\": " << mmm::ReasonOf(error));
  }
}

void
VTUMeshIO::WritePoints(void * buffer)
{
  this->WritePart([&](WriteState & written) {
    written.points =
      mmm::EncodeVTUPoints(buffer, m_PointComponentType, m_NumberOfPoints, m_PointDimension, written.encoding);
    written.numberOfPoints = m_NumberOfPoints;
  });
}

void
VTUMeshIO::WriteCells(void * buffer)
{
  this->WritePart([&](WriteState & written) {
    written.cells = mmm::EncodeVTUCells(
      buffer, m_CellComponentType, m_CellBufferSize, m_NumberOfCells, written.numberOfPoints, written.encoding);
    written.numberOfCells = m_NumberOfCells;
  });
}

void
VTUMeshIO::WritePointData(void * buffer)
{
  this->WritePart([&](WriteState & written) {
    const NamesType names = NamesFor(m_NumberOfPointPixelComponents, m_PointDataNames, { "PointData" });
    written.pointData = mmm::EncodeVTUPixels(buffer,
                                             m_PointPixelComponentType,
                                             m_NumberOfPointPixels,
                                             m_NumberOfPointPixelComponents,
                                             names,
                                             written.encoding);
    written.numberOfPointPixels = m_NumberOfPointPixels;
    written.pointScalars = names.front();
  });
}

void
VTUMeshIO::WriteCellData(void * buffer)
{
  this->WritePart([&](WriteState & written) {
    const NamesType fallback =
      m_NumberOfCellPixelComponents == 2 ? NamesType{ "label_a", "label_b" } : NamesType{ "CellData" };
    const NamesType names = NamesFor(m_NumberOfCellPixelComponents, m_CellDataNames, fallback);
    written.cellData = mmm::EncodeVTUPixels(
      buffer, m_CellPixelComponentType, m_NumberOfCellPixels, m_NumberOfCellPixelComponents, names, written.encoding);
    written.numberOfCellPixels = m_NumberOfCellPixels;
    written.cellScalars = names.front();
  });
}

void
VTUMeshIO::Write()
{
  this->WritePart([&](WriteState & written) {
    if (written.numberOfCells == 0)
    {
      written.cells = mmm::EncodeVTUVertices(written.numberOfPoints, written.encoding);
      written.numberOfCells = written.numberOfPoints;
    }
    for (const auto & array : m_CellArrays)
    {
      const std::size_t components = mmm::ComponentsOf(array, written.numberOfCells);
      written.cellData += mmm::EncodeVTUPixels(array.second.data(),
                                               IOComponentEnum::DOUBLE,
                                               written.numberOfCells,
                                               components,
                                               { array.first },
                                               written.encoding);
      written.numberOfCellPixels = written.numberOfCells;
    }
    mmm::WriteVTUFile(m_FileName, written);
  });
  m_Written = nullptr;
}

void
VTUMeshIO::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "CellDataNames:";
  PrintNames(os, m_CellDataNames);
  os << indent << "PointDataNames:";
  PrintNames(os, m_PointDataNames);
  os << indent << "WriteSpace: " << (m_WriteSpace ? "On" : "Off") << std::endl;
  os << indent << "CellArrays: " << m_CellArrays.size() << std::endl;
  os << indent << "LabelTable: " << m_LabelTable.size() << std::endl;
}
} // end namespace itk
