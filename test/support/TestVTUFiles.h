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
#ifndef mmmTestVTUFiles_h
#define mmmTestVTUFiles_h

// Readers and writers get their IO from the tests, not from the factories that a build may register.
#undef ITK_IO_FACTORY_REGISTER_MANAGER

#include "support/TestDamage.h"
#include "support/TestFiles.h"
#include "itkVTUMeshIO.h"

#include "itkByteSwapper.h"
#include "itkMesh.h"
#include "itkMeshFileReader.h"
#include "itkMeshFileWriter.h"
#include "itkTetrahedronCell.h"
#include "itk_zlib.h"
#include "itksys/Base64.h"

#include "gtest/gtest.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

/** What the tests of VTUMeshIO share: meshes, and files as other programs write them. */
namespace mmmVTUTest
{
template <typename TCellPixel, typename TCoordinate = double>
using MeshOf = itk::Mesh<float, 3, itk::DefaultStaticMeshTraits<float, 3, 3, TCoordinate, TCoordinate, TCellPixel>>;
using MeshType = MeshOf<int>;

constexpr double third = 1.0 / 3.0;

/** A name in a folder of its own, which goes with the test. */
class VTUMeshIOTest : public ::testing::Test
{
protected:
  void
  SetUp() override
  {
    const auto * const info = ::testing::UnitTest::GetInstance()->current_test_info();
    m_Folder = std::filesystem::path(::testing::TempDir()) /
               (std::string("VTUMeshIO") + info->name() + std::to_string(std::random_device()()));
    std::filesystem::remove_all(m_Folder);
    std::filesystem::create_directories(m_Folder);
  }
  void
  TearDown() override
  {
    std::filesystem::remove_all(m_Folder);
  }

  std::string
  Name(const std::string & file = "mesh.vtu") const
  {
    return (m_Folder / file).string();
  }

  std::size_t
  NumberOfFiles() const
  {
    return std::distance(std::filesystem::directory_iterator(m_Folder), std::filesystem::directory_iterator());
  }

  std::filesystem::path m_Folder;
};

using mmmtest::Content;
using mmmtest::Save;

inline bool
Contains(const std::string & text, const std::string & part)
{
  return text.find(part) != std::string::npos;
}

inline std::string
Replaced(std::string text, const std::string & part, const std::string & by)
{
  const auto position = text.find(part);
  EXPECT_NE(position, std::string::npos) << part;
  return position == std::string::npos ? text : text.replace(position, part.size(), by);
}

template <typename TCell, typename TMesh>
void
AddCell(TMesh * mesh, const std::vector<itk::IdentifierType> & points)
{
  typename TMesh::CellAutoPointer cell;
  cell.TakeOwnership(new TCell);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    cell->SetPointId(static_cast<int>(i), points[i]);
  }
  mesh->SetCell(mesh->GetNumberOfCells(), cell);
}

template <typename TMesh>
void
AddPoints(TMesh * mesh)
{
  const double points[][3] = { { 0, 0, 0 }, { third, 0, 0 }, { 0, -1e-17, 0 }, { 0, 0, 1e5 + third }, { 1, 1, 1 } };
  for (const auto & point : points)
  {
    mesh->SetPoint(mesh->GetNumberOfPoints(), point);
  }
}

/** Two tetrahedra with the labels 3 and -7. */
inline MeshType::Pointer
MakeTetrahedra()
{
  const auto mesh = MeshType::New();
  AddPoints(mesh.GetPointer());
  AddCell<itk::TetrahedronCell<MeshType::CellType>>(mesh.GetPointer(), { 0, 1, 2, 3 });
  AddCell<itk::TetrahedronCell<MeshType::CellType>>(mesh.GetPointer(), { 4, 2, 1, 3 });
  mesh->SetCellData(0, 3);
  mesh->SetCellData(1, -7);
  return mesh;
}

enum class Mode
{
  Text,
  Base64,
  Compressed
};
constexpr Mode modes[]{ Mode::Text, Mode::Base64, Mode::Compressed };

template <typename TMesh>
void
Write(const TMesh * mesh, const std::string & name, Mode mode = Mode::Compressed, itk::VTUMeshIO * io = nullptr)
{
  const itk::VTUMeshIO::Pointer used = io ? io : itk::VTUMeshIO::New().GetPointer();
  const auto                    writer = itk::MeshFileWriter<TMesh>::New();
  writer->SetInput(mesh);
  writer->SetFileName(name);
  writer->SetMeshIO(used);
  writer->SetUseCompression(mode == Mode::Compressed);
  if (mode == Mode::Text)
  {
    writer->SetFileTypeAsASCII();
  }
  else
  {
    writer->SetFileTypeAsBINARY();
  }
  writer->Update();
}

template <typename TMesh = MeshType>
typename TMesh::Pointer
Read(const std::string & name, itk::VTUMeshIO * io = nullptr)
{
  const itk::VTUMeshIO::Pointer used = io ? io : itk::VTUMeshIO::New().GetPointer();
  const auto                    reader = itk::MeshFileReader<TMesh>::New();
  reader->SetFileName(name);
  reader->SetMeshIO(used);
  reader->Update();
  return reader->GetOutput();
}

/** The cell pixels of a file, component by component; nothing if they are not of that type. */
template <typename T>
std::vector<T>
ReadCellPixels(const std::string & name, itk::VTUMeshIO * io)
{
  io->SetFileName(name);
  io->ReadMeshInformation();
  if (io->GetCellPixelComponentType() != itk::MeshIOBase::MapComponentType<T>::CType)
  {
    return {};
  }
  std::vector<T> pixels(io->GetNumberOfCellPixels() * io->GetNumberOfCellPixelComponents());
  io->ReadCellData(pixels.data());
  return pixels;
}

/** What reading says of the file, or an empty text if it is read. */
inline std::string
ReadingError(const std::string & name)
{
  try
  {
    Read(name);
  }
  catch (const itk::ExceptionObject & error)
  {
    return error.GetDescription();
  }
  return {};
}

using mmmtest::CountRejected;

inline std::vector<itk::IdentifierType>
PointIds(const itk::CellInterface<int, MeshType::CellTraits> * cell)
{
  return { cell->PointIdsBegin(), cell->PointIdsEnd() };
}

inline void
ExpectTetrahedra(const MeshType * mesh)
{
  const auto expected = MakeTetrahedra();
  ASSERT_EQ(mesh->GetNumberOfPoints(), expected->GetNumberOfPoints());
  for (itk::IdentifierType i = 0; i < expected->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(mesh->GetPoint(i), expected->GetPoint(i));
  }
  ASSERT_EQ(mesh->GetNumberOfCells(), 2u);
  ASSERT_EQ(mesh->GetCellData()->Size(), 2u);
  for (itk::IdentifierType i = 0; i < 2; ++i)
  {
    MeshType::CellAutoPointer cell;
    MeshType::CellAutoPointer expectedCell;
    ASSERT_TRUE(mesh->GetCell(i, cell));
    ASSERT_TRUE(expected->GetCell(i, expectedCell));
    EXPECT_EQ(cell->GetType(), itk::CellGeometryEnum::TETRAHEDRON_CELL);
    EXPECT_EQ(PointIds(cell.GetPointer()), PointIds(expectedCell.GetPointer()));
  }
  EXPECT_EQ(mesh->GetCellData()->ElementAt(0), 3);
  EXPECT_EQ(mesh->GetCellData()->ElementAt(1), -7);
}

// ----- Files as other programs write them -----

enum class Layout
{
  Inline,
  AppendedBase64,
  AppendedRaw
};

struct Flavor
{
  Layout   layout{ Layout::Inline };
  bool     compressed{ false };
  bool     bigEndian{ false };
  unsigned headerSize{ 8 };
};

class FileMaker
{
public:
  explicit FileMaker(const Flavor & flavor)
    : m_Flavor(flavor)
  {}

  /** The mesh of MakeTetrahedra(). */
  std::string
  Make()
  {
    std::string text = R"(<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="0.1" byte_order=")" +
                       std::string(m_Flavor.bigEndian ? "BigEndian" : "LittleEndian") + "\" header_type=\"UInt" +
                       std::to_string(8 * m_Flavor.headerSize) + '"' +
                       (m_Flavor.compressed ? " compressor=\"vtkZLibDataCompressor\"" : "") + R"(>
  <UnstructuredGrid><Piece NumberOfPoints="5" NumberOfCells="2">
    <PointData></PointData>
    <CellData>)" + this->Array<std::int32_t>("Int32", "label", { 3, -7 }) +
                       "</CellData><Points>" +
                       this->Array<double>("Float64\" NumberOfComponents=\"3",
                                           "Points",
                                           { 0, 0, 0, third, 0, 0, 0, -1e-17, 0, 0, 0, 1e5 + third, 1, 1, 1 }) +
                       "</Points><Cells>" +
                       this->Array<std::int64_t>("Int64", "connectivity", { 0, 1, 2, 3, 4, 2, 1, 3 }) +
                       this->Array<std::int64_t>("Int64", "offsets", { 4, 8 }) +
                       this->Array<std::uint8_t>("UInt8", "types", { 10, 10 }) + "</Cells></Piece></UnstructuredGrid>";
    if (m_Flavor.layout != Layout::Inline)
    {
      text += std::string("<AppendedData encoding=\"") + (m_Flavor.layout == Layout::AppendedRaw ? "raw" : "base64") +
              "\">\n  _" + m_Appended + "\n</AppendedData>";
    }
    return text + "</VTKFile>\n";
  }

private:
  template <typename T>
  std::string
  InFileOrder(T value) const
  {
    std::string bytes(reinterpret_cast<const char *>(&value), sizeof value);
    if (m_Flavor.bigEndian != itk::ByteSwapper<int>::SystemIsBigEndian())
    {
      std::reverse(bytes.begin(), bytes.end());
    }
    return bytes;
  }

  std::string
  Header(std::uint64_t value) const
  {
    return m_Flavor.headerSize == 8 ? InFileOrder(value) : InFileOrder(static_cast<std::uint32_t>(value));
  }

  std::string
  Encode(const std::string & bytes) const
  {
    if (m_Flavor.layout == Layout::AppendedRaw)
    {
      return bytes;
    }
    std::string text(bytes.size() * 2 + 4, ' ');
    text.resize(itksysBase64_Encode(reinterpret_cast<const unsigned char *>(bytes.data()),
                                    bytes.size(),
                                    reinterpret_cast<unsigned char *>(text.data()),
                                    0));
    return text;
  }

  template <typename T>
  std::string
  Array(const std::string & type, const std::string & name, const std::vector<T> & values)
  {
    std::string bytes;
    for (const T value : values)
    {
      bytes += InFileOrder(value);
    }
    std::string encoded;
    if (m_Flavor.compressed)
    {
      // Blocks of sixteen bytes, so that there are several and most arrays have a smaller last one.
      constexpr std::size_t blockSize = 16;
      const std::size_t     blocks = (bytes.size() + blockSize - 1) / blockSize;
      std::string           header = Header(blocks) + Header(blockSize) + Header(bytes.size() % blockSize);
      std::string           body;
      for (std::size_t block = 0; block < blocks; ++block)
      {
        const std::string plain = bytes.substr(block * blockSize, blockSize);
        unsigned char     compressed[100];
        uLongf            size = sizeof compressed;
        compress(compressed, &size, reinterpret_cast<const Bytef *>(plain.data()), plain.size());
        header += Header(size);
        body.append(reinterpret_cast<const char *>(compressed), size);
      }
      encoded = Encode(header) + Encode(body);
    }
    else
    {
      encoded = Encode(Header(bytes.size()) + bytes);
    }
    const std::string start = "<DataArray type=\"" + type + "\" Name=\"" + name + "\" ";
    if (m_Flavor.layout == Layout::Inline)
    {
      return start + "format=\"binary\">\n" + encoded + "\n</DataArray>";
    }
    const std::string offset = std::to_string(m_Appended.size());
    m_Appended += encoded;
    return start + "format=\"appended\" offset=\"" + offset + "\"/>";
  }

  Flavor      m_Flavor;
  std::string m_Appended;
};

/** A file of three points, a line and a triangle, that is easy to damage. */
constexpr const char * smallFile = R"(<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian">
<UnstructuredGrid><Piece NumberOfPoints="3" NumberOfCells="2">
<CellData><DataArray type="Int32" Name="label" format="ascii">5 6</DataArray></CellData>
<Points><DataArray type="Float32" Name="Points" NumberOfComponents="3" format="ascii">
0 0 0 1 0 0 0 1 0</DataArray></Points>
<Cells>
<DataArray type="Int64" Name="connectivity" format="ascii">0 1 0 1 2</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">2 5</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">3 5</DataArray>
</Cells></Piece></UnstructuredGrid></VTKFile>)";
} // namespace mmmVTUTest

#endif
