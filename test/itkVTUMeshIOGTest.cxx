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
// Readers and writers get their IO from the tests, not from the factories that a build may register.
#undef ITK_IO_FACTORY_REGISTER_MANAGER

#include "itkVTUMeshIO.h"
#include "itkVTUMeshIOFactory.h"

#include "itkByteSwapper.h"
#include "itkFixedArray.h"
#include "itkHexahedronCell.h"
#include "itkLineCell.h"
#include "itkMesh.h"
#include "itkMeshFileReader.h"
#include "itkMeshFileWriter.h"
#include "itkMeshIOFactory.h"
#include "itkTetrahedronCell.h"
#include "itkTriangleCell.h"
#include "itkVertexCell.h"
#include "itk_zlib.h"
#include "itksys/Base64.h"

#include "gtest/gtest.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <locale>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#if defined(__unix__) || defined(__APPLE__)
#  include <csignal>
#  include <sys/resource.h>
#endif

namespace
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

std::string
Content(const std::string & name)
{
  std::ifstream     file(name, std::ios::binary);
  std::stringstream content;
  content << file.rdbuf();
  return content.str();
}

void
Save(const std::string & name, const std::string & content)
{
  std::ofstream(name, std::ios::binary) << content;
}

bool
Contains(const std::string & text, const std::string & part)
{
  return text.find(part) != std::string::npos;
}

std::string
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
MeshType::Pointer
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

/** What reading says of the file, or an empty text if it is read. */
std::string
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

std::vector<itk::IdentifierType>
PointIds(const itk::CellInterface<int, MeshType::CellTraits> * cell)
{
  return { cell->PointIdsBegin(), cell->PointIdsEnd() };
}

void
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
const char * const smallFile = R"(<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian">
<UnstructuredGrid><Piece NumberOfPoints="3" NumberOfCells="2">
<CellData><DataArray type="Int32" Name="label" format="ascii">5 6</DataArray></CellData>
<Points><DataArray type="Float32" Name="Points" NumberOfComponents="3" format="ascii">
0 0 0 1 0 0 0 1 0</DataArray></Points>
<Cells>
<DataArray type="Int64" Name="connectivity" format="ascii">0 1 0 1 2</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">2 5</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">3 5</DataArray>
</Cells></Piece></UnstructuredGrid></VTKFile>)";

/** Writes comma for point and groups thousands, as the numbers of many languages do. */
class CommaNumbers : public std::numpunct<char>
{
protected:
  char
  do_decimal_point() const override
  {
    return ',';
  }
  char
  do_thousands_sep() const override
  {
    return '.';
  }
  std::string
  do_grouping() const override
  {
    return "\3";
  }
};
} // namespace

TEST_F(VTUMeshIOTest, ClaimsOnlyVTUFiles)
{
  const auto io = itk::VTUMeshIO::New();
  EXPECT_TRUE(io->CanWriteFile("a.vtu"));
  EXPECT_TRUE(io->CanWriteFile("A.VTU"));
  EXPECT_FALSE(io->CanWriteFile("a.vtk"));
  EXPECT_FALSE(io->CanWriteFile("a.vtu.gz"));
  EXPECT_FALSE(io->CanWriteFile(nullptr));
  EXPECT_FALSE(io->CanReadFile(Name().c_str()));
  Save(Name(), "");
  Save(Name("mesh.vtk"), "");
  EXPECT_TRUE(io->CanReadFile(Name().c_str()));
  EXPECT_FALSE(io->CanReadFile(Name("mesh.vtk").c_str()));
  EXPECT_FALSE(io->CanReadFile(m_Folder.string().c_str()));
}

TEST_F(VTUMeshIOTest, IsFoundByReadersAndWritersOnceItsFactoryIsRegistered)
{
  itk::VTUMeshIOFactory::RegisterOneFactory();
  const auto io = itk::MeshIOFactory::CreateMeshIO("new.vtu", itk::MeshIOFactory::IOFileModeEnum::WriteMode);
  ASSERT_TRUE(io.IsNotNull());
  EXPECT_STREQ(io->GetNameOfClass(), "VTUMeshIO");
}

TEST_F(VTUMeshIOTest, StartsWithCompressedBinary)
{
  const auto io = itk::VTUMeshIO::New();
  EXPECT_TRUE(io->GetUseCompression());
  EXPECT_EQ(io->GetFileType(), itk::IOFileEnum::BINARY);
  EXPECT_EQ(io->GetCellDataNames(), itk::VTUMeshIO::NamesType{ "label" });
  EXPECT_EQ(io->GetPointDataNames(), itk::VTUMeshIO::NamesType{ "point_data" });
  std::ostringstream printed;
  io->Print(printed);
  EXPECT_TRUE(Contains(printed.str(), "CellDataNames: label"));
}

TEST_F(VTUMeshIOTest, WritesTetrahedraThatReadBackUnchanged)
{
  for (const Mode mode : modes)
  {
    Write(MakeTetrahedra().GetPointer(), Name(), mode);
    ExpectTetrahedra(Read(Name()));
  }
}

TEST_F(VTUMeshIOTest, WritesWhatTheModeSays)
{
  const auto mesh = MakeTetrahedra();
  Write(mesh.GetPointer(), Name(), Mode::Text);
  EXPECT_TRUE(Contains(Content(Name()), "format=\"ascii\">\n3 -7\n"));
  EXPECT_FALSE(Contains(Content(Name()), "compressor"));
  Write(mesh.GetPointer(), Name(), Mode::Base64);
  EXPECT_TRUE(Contains(Content(Name()), "format=\"binary\""));
  EXPECT_FALSE(Contains(Content(Name()), "compressor"));
  Write(mesh.GetPointer(), Name(), Mode::Compressed);
  EXPECT_TRUE(Contains(Content(Name()), "format=\"binary\""));
  EXPECT_TRUE(Contains(Content(Name()), "compressor=\"vtkZLibDataCompressor\""));
  EXPECT_TRUE(Contains(Content(Name()), "version=\"1.0\""));
  EXPECT_TRUE(Contains(Content(Name()), "header_type=\"UInt64\""));
}

TEST_F(VTUMeshIOTest, SaysThatCoordinatesAreLPSUnlessToldNotTo)
{
  const std::string space = "Name=\"SPACE\" NumberOfTuples=\"1\" format=\"ascii\">\n        76 80 83 0\n";
  const auto        io = itk::VTUMeshIO::New();
  Write(MakeTetrahedra().GetPointer(), Name(), Mode::Compressed, io);
  EXPECT_TRUE(Contains(Content(Name()), space));
  io->WriteSpaceOff();
  Write(MakeTetrahedra().GetPointer(), Name(), Mode::Compressed, io);
  EXPECT_FALSE(Contains(Content(Name()), "SPACE"));
  ExpectTetrahedra(Read(Name()));
}

TEST_F(VTUMeshIOTest, ReadsRASAsLPS)
{
  Write(MakeTetrahedra().GetPointer(), Name());
  Save(Name(), Replaced(Content(Name()), "76 80 83 0", "82 65 83 0"));
  const auto mesh = Read(Name());
  EXPECT_EQ(mesh->GetPoint(1)[0], -third);
  EXPECT_EQ(mesh->GetPoint(4)[1], -1);
  EXPECT_EQ(mesh->GetPoint(4)[2], 1);
}

TEST_F(VTUMeshIOTest, KeepsThePrecisionOfCoordinates)
{
  Write(MakeTetrahedra().GetPointer(), Name());
  EXPECT_TRUE(Contains(Content(Name()), "type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\""));
  using FloatMesh = MeshOf<int, float>;
  const auto mesh = FloatMesh::New();
  AddPoints(mesh.GetPointer());
  for (const Mode mode : modes)
  {
    Write(mesh.GetPointer(), Name(), mode);
    EXPECT_TRUE(Contains(Content(Name()), "type=\"Float32\" Name=\"Points\" NumberOfComponents=\"3\""));
    EXPECT_EQ(Read<FloatMesh>(Name())->GetPoint(1)[0], static_cast<float>(third));
  }
}

TEST_F(VTUMeshIOTest, ReadsBackCoordinatesThatAreNotFinite)
{
  const auto mesh = MeshType::New();
  AddPoints(mesh.GetPointer());
  MeshType::PointType point;
  point[0] = std::numeric_limits<double>::infinity();
  point[1] = std::numeric_limits<double>::quiet_NaN();
  point[2] = std::numeric_limits<double>::denorm_min();
  mesh->SetPoint(0, point);
  for (const Mode mode : modes)
  {
    Write(mesh.GetPointer(), Name(), mode);
    const auto read = Read(Name())->GetPoint(0);
    EXPECT_EQ(read[0], point[0]);
    EXPECT_TRUE(std::isnan(read[1]));
    EXPECT_EQ(read[2], point[2]);
  }
}

TEST_F(VTUMeshIOTest, KeepsTheTypeOfLabels)
{
  using ByteMesh = MeshOf<unsigned char>;
  const auto mesh = ByteMesh::New();
  AddPoints(mesh.GetPointer());
  AddCell<itk::TetrahedronCell<ByteMesh::CellType>>(mesh.GetPointer(), { 0, 1, 2, 3 });
  mesh->SetCellData(0, 200);
  for (const Mode mode : modes)
  {
    Write(mesh.GetPointer(), Name(), mode);
    EXPECT_TRUE(Contains(Content(Name()), "type=\"UInt8\" Name=\"label\""));
    EXPECT_EQ(Read<ByteMesh>(Name())->GetCellData()->ElementAt(0), 200);
  }
}

TEST_F(VTUMeshIOTest, WritesPairsOfLabelsAsTwoArraysAndJoinsThem)
{
  using PairMesh = MeshOf<itk::FixedArray<int, 2>>;
  const auto mesh = PairMesh::New();
  AddPoints(mesh.GetPointer());
  AddCell<itk::TriangleCell<PairMesh::CellType>>(mesh.GetPointer(), { 0, 1, 2 });
  AddCell<itk::TriangleCell<PairMesh::CellType>>(mesh.GetPointer(), { 1, 2, 3 });
  const int pairs[2][2] = { { 1, 2 }, { -3, 400 } };
  mesh->SetCellData(0, pairs[0]);
  mesh->SetCellData(1, pairs[1]);
  for (const Mode mode : modes)
  {
    Write(mesh.GetPointer(), Name(), mode);
    EXPECT_TRUE(Contains(Content(Name()), "<DataArray type=\"Int32\" Name=\"label_a\" format"));
    EXPECT_TRUE(Contains(Content(Name()), "<DataArray type=\"Int32\" Name=\"label_b\" format"));
    const auto read = Read<PairMesh>(Name());
    ASSERT_EQ(read->GetCellData()->Size(), 2u);
    EXPECT_EQ(read->GetCellData()->ElementAt(0), mesh->GetCellData()->ElementAt(0));
    EXPECT_EQ(read->GetCellData()->ElementAt(1), mesh->GetCellData()->ElementAt(1));
  }
}

TEST_F(VTUMeshIOTest, NamesAnArrayPerComponentAsTold)
{
  using FiveMesh = MeshOf<itk::FixedArray<int, 5>>;
  const itk::VTUMeshIO::NamesType names{ "cell_dimension", "label_a", "label_b", "label_c", "<\"&\">" };
  const auto                      io = itk::VTUMeshIO::New();
  io->SetCellDataNames(names);
  const auto mesh = FiveMesh::New();
  AddPoints(mesh.GetPointer());
  AddCell<itk::VertexCell<FiveMesh::CellType>>(mesh.GetPointer(), { 4 });
  const int five[]{ 9, 8, 7, 6, 5 };
  mesh->SetCellData(0, five);
  Write(mesh.GetPointer(), Name(), Mode::Compressed, io);
  EXPECT_TRUE(Contains(Content(Name()), "Name=\"&lt;&quot;&amp;&quot;&gt;\""));
  EXPECT_EQ(Read<FiveMesh>(Name(), io)->GetCellData()->ElementAt(0), mesh->GetCellData()->ElementAt(0));

  // Without names, the arrays that have the default ones.
  const auto automatic = itk::VTUMeshIO::New();
  automatic->SetFileName(Name());
  automatic->ReadMeshInformation();
  EXPECT_EQ(automatic->GetNumberOfCellPixelComponents(), 3u);
}

TEST_F(VTUMeshIOTest, WritesOneArrayIfThereIsNoNamePerComponent)
{
  using VectorMesh = MeshOf<itk::Vector<float, 3>>;
  const auto mesh = VectorMesh::New();
  AddPoints(mesh.GetPointer());
  AddCell<itk::VertexCell<VectorMesh::CellType>>(mesh.GetPointer(), { 4 });
  const float vector[]{ 1, 2.5f, 3 };
  mesh->SetCellData(0, vector);
  Write(mesh.GetPointer(), Name());
  EXPECT_TRUE(Contains(Content(Name()), "<DataArray type=\"Float32\" Name=\"CellData\" NumberOfComponents=\"3\""));
  EXPECT_EQ(Read<VectorMesh>(Name())->GetCellData()->ElementAt(0), mesh->GetCellData()->ElementAt(0));
}

TEST_F(VTUMeshIOTest, WritesAndReadsPointData)
{
  const auto mesh = MakeTetrahedra();
  for (itk::IdentifierType i = 0; i < 5; ++i)
  {
    mesh->SetPointData(i, 0.1f * static_cast<float>(i));
  }
  for (const Mode mode : modes)
  {
    Write(mesh.GetPointer(), Name(), mode);
    EXPECT_TRUE(Contains(Content(Name()), "<DataArray type=\"Float32\" Name=\"point_data\""));
    const auto read = Read(Name());
    ASSERT_EQ(read->GetPointData()->Size(), 5u);
    EXPECT_EQ(read->GetPointData()->ElementAt(3), 0.1f * 3);
  }
}

TEST_F(VTUMeshIOTest, ReadsTheNamedArrayElseLabelElseTheFirst)
{
  const std::string label = R"(<DataArray type="Int32" Name="label" format="ascii">5 6</DataArray>)";
  const std::string other = R"(<DataArray type="Int32" Name="other" format="ascii">8 9</DataArray>)";
  const auto        firstLabel = [&](itk::VTUMeshIO * io) { return Read(Name(), io)->GetCellData()->ElementAt(0); };
  Save(Name(), Replaced(smallFile, label, other + label));
  EXPECT_EQ(firstLabel(nullptr), 5);
  const auto io = itk::VTUMeshIO::New();
  io->SetCellDataNames({ "other" });
  EXPECT_EQ(firstLabel(io), 8);
  io->SetCellDataNames({ "missing" });
  EXPECT_EQ(firstLabel(io), 5);
  Save(Name(), Replaced(smallFile, label, other));
  EXPECT_EQ(firstLabel(nullptr), 8);
}

TEST_F(VTUMeshIOTest, WritesAVertexPerPointOfAMeshWithoutCells)
{
  const auto mesh = MeshType::New();
  AddPoints(mesh.GetPointer());
  for (const Mode mode : modes)
  {
    Write(mesh.GetPointer(), Name(), mode);
    const auto read = Read(Name());
    EXPECT_EQ(read->GetNumberOfPoints(), 5u);
    ASSERT_EQ(read->GetNumberOfCells(), 5u);
    MeshType::CellAutoPointer cell;
    ASSERT_TRUE(read->GetCell(4, cell));
    EXPECT_EQ(cell->GetType(), itk::CellGeometryEnum::VERTEX_CELL);
    EXPECT_EQ(PointIds(cell.GetPointer()), std::vector<itk::IdentifierType>{ 4 });
  }
}

TEST_F(VTUMeshIOTest, WritesAndReadsAnEmptyMesh)
{
  for (const Mode mode : modes)
  {
    Write(MeshType::New().GetPointer(), Name(), mode);
    const auto read = Read(Name());
    EXPECT_EQ(read->GetNumberOfPoints(), 0u);
    EXPECT_EQ(read->GetNumberOfCells(), 0u);
  }
}

TEST_F(VTUMeshIOTest, WritesMixedCellsThatReadBackUnchanged)
{
  const auto mesh = MeshType::New();
  AddPoints(mesh.GetPointer());
  AddPoints(mesh.GetPointer());
  using Cell = MeshType::CellType;
  AddCell<itk::VertexCell<Cell>>(mesh.GetPointer(), { 9 });
  AddCell<itk::HexahedronCell<Cell>>(mesh.GetPointer(), { 7, 6, 5, 4, 3, 2, 1, 0 });
  AddCell<itk::LineCell<Cell>>(mesh.GetPointer(), { 8, 0 });
  AddCell<itk::TriangleCell<Cell>>(mesh.GetPointer(), { 1, 3, 5 });
  AddCell<itk::QuadrilateralCell<Cell>>(mesh.GetPointer(), { 1, 3, 5, 7 });
  AddCell<itk::PolygonCell<Cell>>(mesh.GetPointer(), { 1, 3, 5, 7, 9 });
  AddCell<itk::QuadraticEdgeCell<Cell>>(mesh.GetPointer(), { 2, 4, 6 });
  AddCell<itk::QuadraticTriangleCell<Cell>>(mesh.GetPointer(), { 0, 1, 2, 3, 4, 5 });
  for (const Mode mode : modes)
  {
    Write(mesh.GetPointer(), Name(), mode);
    const auto read = Read(Name());
    ASSERT_EQ(read->GetNumberOfCells(), mesh->GetNumberOfCells());
    for (itk::IdentifierType i = 0; i < mesh->GetNumberOfCells(); ++i)
    {
      MeshType::CellAutoPointer expected;
      MeshType::CellAutoPointer cell;
      ASSERT_TRUE(mesh->GetCell(i, expected));
      ASSERT_TRUE(read->GetCell(i, cell));
      EXPECT_EQ(cell->GetType(), expected->GetType());
      EXPECT_EQ(PointIds(cell.GetPointer()), PointIds(expected.GetPointer()));
    }
  }
}

TEST_F(VTUMeshIOTest, ReadsPolylinesAsLinesThatShareTheirLabel)
{
  std::string text = Replaced(smallFile, "NumberOfCells=\"2\"", "NumberOfCells=\"3\"");
  text = Replaced(text, ">5 6<", ">5 6 7<");
  text = Replaced(text, ">0 1 0 1 2<", ">0 1 0 1 2 0 1 2<");
  text = Replaced(text, ">2 5<", ">2 5 8<");
  Save(Name(), Replaced(text, ">3 5<", ">3 4 5<"));
  const auto mesh = Read(Name());
  ASSERT_EQ(mesh->GetNumberOfCells(), 4u);
  const int labels[]{ 5, 6, 6, 7 };
  for (itk::IdentifierType i = 0; i < 4; ++i)
  {
    EXPECT_EQ(mesh->GetCellData()->ElementAt(i), labels[i]);
  }
  MeshType::CellAutoPointer cell;
  ASSERT_TRUE(mesh->GetCell(2, cell));
  EXPECT_EQ(PointIds(cell.GetPointer()), (std::vector<itk::IdentifierType>{ 1, 2 }));
}

TEST_F(VTUMeshIOTest, WritesLinesOfManyPointsAsPolylines)
{
  const auto io = itk::VTUMeshIO::New();
  io->SetFileName(Name());
  io->SetFileTypeToASCII();
  io->SetNumberOfPoints(3);
  io->SetPointComponentType(itk::IOComponentEnum::FLOAT);
  io->SetNumberOfCells(1);
  io->SetCellBufferSize(5);
  io->SetCellComponentType(itk::IOComponentEnum::UINT);
  float        points[9]{};
  unsigned int cells[]{ 1, 3, 2, 0, 1 };
  io->WriteMeshInformation();
  io->WritePoints(points);
  io->WriteCells(cells);
  io->Write();
  EXPECT_TRUE(Contains(Content(Name()), "Name=\"types\" format=\"ascii\">\n4\n"));
}

TEST_F(VTUMeshIOTest, KeepsArraysOfManyBlocks)
{
  // Enough for several batches of blocks, with a remainder.
  constexpr itk::IdentifierType    numberOfCells = 300001;
  constexpr itk::IdentifierType    numberOfPoints = 100003;
  std::vector<double>              points;
  std::vector<itk::IdentifierType> cells;
  std::vector<short>               labels;
  std::mt19937                     random(1);
  for (itk::IdentifierType i = 0; i < 3 * numberOfPoints; ++i)
  {
    points.push_back(random() * third);
  }
  for (itk::IdentifierType i = 0; i < numberOfCells; ++i)
  {
    cells.push_back(static_cast<itk::IdentifierType>(itk::CellGeometryEnum::TETRAHEDRON_CELL));
    cells.push_back(4);
    for (int k = 0; k < 4; ++k)
    {
      cells.push_back(random() % numberOfPoints);
    }
    labels.push_back(static_cast<short>(random()));
  }
  for (const Mode mode : modes)
  {
    const auto io = itk::VTUMeshIO::New();
    io->SetFileName(Name());
    io->SetFileType(mode == Mode::Text ? itk::IOFileEnum::ASCII : itk::IOFileEnum::BINARY);
    io->SetUseCompression(mode == Mode::Compressed);
    io->SetNumberOfPoints(numberOfPoints);
    io->SetPointComponentType(itk::IOComponentEnum::DOUBLE);
    io->SetNumberOfCells(numberOfCells);
    io->SetCellBufferSize(cells.size());
    io->SetCellComponentType(itk::MeshIOBase::MapComponentType<itk::IdentifierType>::CType);
    io->SetNumberOfCellPixels(numberOfCells);
    io->SetPixelType(short{}, false);
    io->WriteMeshInformation();
    io->WritePoints(points.data());
    io->WriteCells(cells.data());
    io->WriteCellData(labels.data());
    io->Write();

    const auto reader = itk::VTUMeshIO::New();
    reader->SetFileName(Name());
    reader->ReadMeshInformation();
    ASSERT_EQ(reader->GetNumberOfPoints(), numberOfPoints);
    ASSERT_EQ(reader->GetCellBufferSize(), cells.size());
    ASSERT_EQ(reader->GetNumberOfCellPixels(), numberOfCells);
    ASSERT_EQ(reader->GetCellPixelComponentType(), itk::IOComponentEnum::SHORT);
    std::vector<double>              readPoints(points.size());
    std::vector<itk::IdentifierType> readCells(cells.size());
    std::vector<short>               readLabels(labels.size());
    reader->ReadPoints(readPoints.data());
    reader->ReadCells(readCells.data());
    reader->ReadCellData(readLabels.data());
    EXPECT_EQ(readPoints, points);
    EXPECT_EQ(readCells, cells);
    EXPECT_EQ(readLabels, labels);
  }
}

TEST_F(VTUMeshIOTest, FillsUpPointsOfTwoCoordinates)
{
  using FlatMesh = itk::Mesh<float, 2>;
  const auto   mesh = FlatMesh::New();
  const double point[]{ 3, 4 };
  mesh->SetPoint(0, point);
  Write(mesh.GetPointer(), Name());
  const auto read = Read(Name())->GetPoint(0);
  EXPECT_EQ(read[0], 3);
  EXPECT_EQ(read[1], 4);
  EXPECT_EQ(read[2], 0);
}

TEST_F(VTUMeshIOTest, DoesNotDependOnTheLocale)
{
  const std::locale previous = std::locale::global(std::locale(std::locale::classic(), new CommaNumbers));
  Write(MakeTetrahedra().GetPointer(), Name(), Mode::Text);
  const auto mesh = Read(Name());
  Save(Name("small.vtu"), smallFile);
  const std::string error = ReadingError(Name("small.vtu"));
  std::locale::global(previous);
  ExpectTetrahedra(mesh);
  EXPECT_EQ(error, "");
}

TEST_F(VTUMeshIOTest, ReplacesAnExistingFileAndLeavesNoOther)
{
  Save(Name(), "old");
  Write(MakeTetrahedra().GetPointer(), Name());
  ExpectTetrahedra(Read(Name()));
  EXPECT_EQ(NumberOfFiles(), 1u);
}

TEST_F(VTUMeshIOTest, KeepsNoPartialFileWhenTheFolderIsMissing)
{
  const std::string name = (m_Folder / "missing" / "mesh.vtu").string();
  try
  {
    Write(MakeTetrahedra().GetPointer(), name);
    FAIL() << "The file was written to a folder that is not there.";
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_TRUE(Contains(error.GetDescription(), name)) << error;
    EXPECT_TRUE(Contains(error.GetDescription(), "No such file or directory")) << error;
  }
  EXPECT_EQ(NumberOfFiles(), 0u);
}

TEST_F(VTUMeshIOTest, KeepsNoPartialFileWhenTheNameIsAFolder)
{
  std::filesystem::create_directory(Name());
  EXPECT_THROW(Write(MakeTetrahedra().GetPointer(), Name()), itk::ExceptionObject);
  EXPECT_EQ(NumberOfFiles(), 1u);
  EXPECT_TRUE(std::filesystem::is_directory(Name()));
}

#if defined(__unix__) || defined(__APPLE__)
TEST_F(VTUMeshIOTest, KeepsTheOldFileWhenTheDiskIsFull)
{
  Save(Name(), "old");
  rlimit limit{};
  getrlimit(RLIMIT_FSIZE, &limit);
  const rlimit small{ 1000, limit.rlim_max };
  const auto   previous = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  EXPECT_THROW(Write(MakeTetrahedra().GetPointer(), Name()), itk::ExceptionObject);
  setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, previous);
  EXPECT_EQ(Content(Name()), "old");
  EXPECT_EQ(NumberOfFiles(), 1u);
}
#endif

TEST_F(VTUMeshIOTest, ThrowsWhenDataAndMeshDifferInNumber)
{
  const auto mesh = MakeTetrahedra();
  mesh->SetCellData(2, 5);
  EXPECT_THROW(Write(mesh.GetPointer(), Name()), itk::ExceptionObject);
  const auto other = MakeTetrahedra();
  other->SetPointData(0, 5);
  EXPECT_THROW(Write(other.GetPointer(), Name()), itk::ExceptionObject);
  EXPECT_EQ(NumberOfFiles(), 0u);
}

TEST_F(VTUMeshIOTest, ThrowsOnCellsThatCannotBeWritten)
{
  const auto writeCells = [&](std::vector<int> cells, itk::SizeValueType numberOfCells) {
    const auto io = itk::VTUMeshIO::New();
    io->SetFileName(Name());
    io->SetNumberOfPoints(3);
    io->SetPointComponentType(itk::IOComponentEnum::FLOAT);
    io->SetNumberOfCells(numberOfCells);
    io->SetCellBufferSize(cells.size());
    io->SetCellComponentType(itk::IOComponentEnum::INT);
    float points[9]{};
    io->WriteMeshInformation();
    io->WritePoints(points);
    io->WriteCells(cells.data());
  };
  EXPECT_NO_THROW(writeCells({ 2, 3, 0, 1, 2 }, 1));
  EXPECT_THROW(writeCells({ 2, 3, 0, 1, 3 }, 1), itk::ExceptionObject);  // no such point
  EXPECT_THROW(writeCells({ 2, 3, 0, 1, -1 }, 1), itk::ExceptionObject); // no such point
  EXPECT_THROW(writeCells({ 2, 2, 0, 1 }, 1), itk::ExceptionObject);     // a triangle of two points
  EXPECT_THROW(writeCells({ 77, 1, 0 }, 1), itk::ExceptionObject);       // no such type
  EXPECT_THROW(writeCells({ 2, 4, 0, 1, 2 }, 1), itk::ExceptionObject);  // buffer too short
  EXPECT_THROW(writeCells({ 2, 3, 0, 1, 2 }, 2), itk::ExceptionObject);  // buffer too short
  EXPECT_THROW(writeCells({ 2, 3, 0, 1, 2, 0 }, 1), itk::ExceptionObject);
  EXPECT_THROW(writeCells({ 2 }, 1), itk::ExceptionObject);
}

TEST_F(VTUMeshIOTest, ThrowsWhenPartsAreWrittenOrReadOutOfTurn)
{
  const auto io = itk::VTUMeshIO::New();
  io->SetFileName(Name());
  float buffer[9]{};
  EXPECT_THROW(io->Write(), itk::ExceptionObject);
  EXPECT_THROW(io->WritePoints(buffer), itk::ExceptionObject);
  EXPECT_THROW(io->ReadPoints(buffer), itk::ExceptionObject);
  Save(Name(), smallFile);
  io->ReadMeshInformation();
  io->ReadPoints(buffer);
  EXPECT_EQ(buffer[3], 1);
  EXPECT_THROW(io->ReadPoints(buffer), itk::ExceptionObject);
  EXPECT_THROW(io->ReadPointData(buffer), itk::ExceptionObject);
}

TEST_F(VTUMeshIOTest, ReadsInlineBase64Data)
{
  Save(Name(), FileMaker({ Layout::Inline }).Make());
  ExpectTetrahedra(Read(Name()));
}

TEST_F(VTUMeshIOTest, ReadsAppendedRawData)
{
  Save(Name(), FileMaker({ Layout::AppendedRaw }).Make());
  ExpectTetrahedra(Read(Name()));
}

TEST_F(VTUMeshIOTest, ReadsAppendedBase64Data)
{
  Save(Name(), FileMaker({ Layout::AppendedBase64 }).Make());
  ExpectTetrahedra(Read(Name()));
}

TEST_F(VTUMeshIOTest, ReadsCompressedBlocksOfAllLayouts)
{
  for (const Layout layout : { Layout::Inline, Layout::AppendedRaw, Layout::AppendedBase64 })
  {
    Save(Name(), FileMaker({ layout, true }).Make());
    ExpectTetrahedra(Read(Name()));
  }
}

TEST_F(VTUMeshIOTest, ReadsBothByteOrdersAndHeaderSizes)
{
  for (const Layout layout : { Layout::Inline, Layout::AppendedRaw, Layout::AppendedBase64 })
  {
    for (const bool compressed : { false, true })
    {
      for (const bool bigEndian : { false, true })
      {
        for (const unsigned headerSize : { 4u, 8u })
        {
          Save(Name(), FileMaker({ layout, compressed, bigEndian, headerSize }).Make());
          ExpectTetrahedra(Read(Name()));
        }
      }
    }
  }
}

TEST_F(VTUMeshIOTest, ReadsValuesAmongTheKeysOfVTK)
{
  const std::string key = R"(<InformationKey name="L2_NORM_RANGE" length="2">)"
                          R"(<Value index="0">0</Value> <Value index="1">1</Value></InformationKey>)";
  Save(Name(), Replaced(smallFile, "0 0 0 1 0 0 0 1 0<", "0 0 0 1 0 0 0 1 0 \n" + key + " <"));
  EXPECT_EQ(Read(Name())->GetPoint(1)[0], 1);
  Save(Name(), Replaced(smallFile, "\n0 0 0 1 0 0 0 1 0<", key + key + "0 0 0 1 0 0 0 1 0<"));
  EXPECT_EQ(Read(Name())->GetPoint(1)[0], 1);
}

TEST_F(VTUMeshIOTest, ReadsIntegerPoints)
{
  Save(Name(), Replaced(smallFile, "Float32", "Int16"));
  EXPECT_EQ(Read(Name())->GetPoint(1)[0], 1);
}

TEST_F(VTUMeshIOTest, SaysWhichFileCannotBeReadAndWhy)
{
  const auto expectError = [&](const std::string & part, const std::string & by, const std::string & expected) {
    Save(Name(), Replaced(smallFile, part, by));
    const std::string error = ReadingError(Name());
    EXPECT_TRUE(Contains(error, Name())) << error;
    EXPECT_TRUE(Contains(error, expected)) << "expected: " << expected << "\nactual: " << error;
  };
  EXPECT_TRUE(Contains(ReadingError(Name()), "No such file or directory"));
  Save(Name(), "");
  EXPECT_TRUE(Contains(ReadingError(Name()), "no element found"));

  expectError("<VTKFile", "<svg", "");
  expectError("type=\"UnstructuredGrid\"", "type=\"PolyData\"", "PolyData");
  expectError("<UnstructuredGrid>", "<!-- --><PolyData>", "mismatched tag");
  expectError("<VTKFile", "<!DOCTYPE a [<!ENTITY b \"c\">]><VTKFile", "document type declaration");
  expectError("byte_order", "compressor=\"vtkLZ4DataCompressor\" byte_order", "vtkLZ4DataCompressor");
  expectError("LittleEndian", "MiddleEndian", "MiddleEndian");
  expectError("byte_order", "header_type=\"UInt128\" byte_order", "UInt128");
  expectError("<Piece", "<Piece NumberOfPoints=\"0\" NumberOfCells=\"0\"/><Piece", "several pieces");
  expectError("NumberOfPoints=\"3\"", "", "<Piece> has no NumberOfPoints");
  expectError("NumberOfPoints=\"3\"", "NumberOfPoints=\"-3\"", "\"-3\", which is not a count");
  expectError("NumberOfPoints=\"3\"", "NumberOfPoints=\"1152921504606846976\"", "too short");
  expectError("NumberOfPoints=\"3\"", "NumberOfPoints=\"18446744073709551615\"", "more points than there can be");
  expectError("NumberOfPoints=\"3\"", "NumberOfPoints=\"18446744073709551616\"", "not a count");
  expectError("NumberOfPoints=\"3\"", "NumberOfPoints=\"2\"", "holds 9 values, where 6 are expected");
  expectError("NumberOfCells=\"2\"", "NumberOfCells=\"1000000\"", "1000000");
  expectError("NumberOfCells=\"2\"", "NumberOfCells=\"1152921504606846976\"", "1152921504606846976");
  expectError("NumberOfComponents=\"3\"", "NumberOfComponents=\"2\"", "three components");
  expectError("NumberOfComponents=\"3\"", "", "three components");
  expectError("Name=\"label\"", "Name=\"label\" NumberOfComponents=\"0\"", "0 components");
  expectError("Name=\"label\"", "Name=\"label\" NumberOfComponents=\"9999999999\"", "9999999999 components");
  expectError("Name=\"label\"", "Name=\"label\" NumberOfComponents=\"3\"", "6");
  expectError("Name=\"offsets\"", "Name=\"offsets\" NumberOfComponents=\"2\"", "offsets");
  expectError("Name=\"offsets\"", "Name=\"ofsets\"", "no array \"offsets\"");
  expectError("Int32", "Int31", "has the type \"Int31\", which is not supported");
  expectError("Int64\" Name=\"offsets", "Float32\" Name=\"offsets", "one integer per value");
  expectError(">5 6<", ">  5  <", "holds 1 values, where 2 are expected");
  expectError(">5 6<", ">5 six<", "\"six\"");
  expectError(">5 6<", ">5 2147483648<", "\"2147483648\"");
  expectError(">5 6<", ">5 6.5<", "\"6.5\"");
  expectError("0 0 0 1 0", "0 0 0 1,5 0", "\"1,5\"");
  expectError("format=\"ascii\">5", "format=\"hex\">5", "unknown format \"hex\"");
  expectError("format=\"ascii\">5", "format=\"binary\">5", "\"label\"");
  expectError("format=\"ascii\">5", "format=\"appended\" offset=\"0\">5", "appended");
  expectError(">2 5<", ">2 6<", "its cell 1 has the offset 6");
  expectError(">2 5<", ">2 1<", "its cell 1 has the offset 1");
  expectError(">2 5<", ">-2 5<", "its cell 0 has the offset -2");
  expectError(">0 1 0 1 2<", ">0 1 0 1 2 2<", "\"connectivity\" has 6");
  expectError(">0 1 0 1 2<", ">0 1 0 1 3<", "its cell 1 refers to the point 3 of 3");
  expectError(">0 1 0 1 2<", ">0 1 0 1 -1<", "its cell 1 refers to the point -1 of 3");
  expectError(">3 5<", ">5 5<", "its cell 0 is a triangle (VTK cell type 5) of 2 points");
  expectError(">3 5<", ">3 13<", "its cell 1 is a wedge (VTK cell type 13), which ITK meshes cannot hold");
  expectError(">3 5<", ">3 72<", "VTK cell type 72");
  expectError(">3 5<", ">3 300<", "\"300\"");
}

TEST_F(VTUMeshIOTest, ThrowsOnBinaryDataThatAnnouncesMoreThanThereIs)
{
  const auto base64 = [](const std::vector<std::uint64_t> & header) {
    std::string text(header.size() * 16 + 4, ' ');
    text.resize(itksysBase64_Encode(reinterpret_cast<const unsigned char *>(header.data()),
                                    header.size() * 8,
                                    reinterpret_cast<unsigned char *>(text.data()),
                                    0));
    return text;
  };
  const char * const endian = itk::ByteSwapper<int>::SystemIsBigEndian() ? "BigEndian" : "LittleEndian";
  const auto         expectError = [&](bool compressed, const std::vector<std::uint64_t> & header) {
    std::string text = Replaced(
      smallFile, "byte_order=\"LittleEndian\"", std::string("header_type=\"UInt64\" byte_order=\"") + endian + '"');
    if (compressed)
    {
      text = Replaced(text, "byte_order", "compressor=\"vtkZLibDataCompressor\" byte_order");
    }
    // The size of the connectivity is known from nowhere but its header.
    Save(Name(), Replaced(text, "format=\"ascii\">0 1 0 1 2<", "format=\"binary\">" + base64(header) + '<'));
    EXPECT_TRUE(Contains(ReadingError(Name()), "\"connectivity\"")) << ReadingError(Name());
  };
  constexpr std::uint64_t huge = std::uint64_t{ 1 } << 60;
  expectError(false, {});
  expectError(false, { 40 });
  expectError(false, { 39, 1, 2, 3, 4, 5 });
  expectError(false, { huge });
  expectError(false, { ~std::uint64_t{ 7 } });
  expectError(true, {});
  expectError(true, { huge, 8, 0 });
  expectError(true, { 1, huge, 0, 20, 0, 0 });
  expectError(true, { 1, huge, 40, 20, 0, 0, 0 });
  expectError(true, { 1, 40, 48, 20, 0, 0, 0 });
  expectError(true, { 1, 1 << 30, 0, 8, 0 });
  expectError(true, { 1, 40, 0, huge, 0 });
  expectError(true, { 2, 40, 0, 8, ~std::uint64_t{ 0 }, 0 });
  expectError(true, { 1, 40, 0, 8, 0 });
  expectError(true, { 1, 0, 0, 0 });
}

TEST_F(VTUMeshIOTest, ThrowsOnAppendedDataThatIsNotThere)
{
  const std::string text = FileMaker({ Layout::AppendedRaw }).Make();
  const auto        expectError = [&](const std::string & damaged, const std::string & expected) {
    Save(Name(), damaged);
    EXPECT_TRUE(Contains(ReadingError(Name()), expected)) << ReadingError(Name());
  };
  expectError(Replaced(text, "offset=\"0\"", "offset=\"123456\""), "beyond the end of the file");
  expectError(Replaced(text, "offset=\"0\"", "offset=\"18446744073709551615\""), "beyond the end of the file");
  expectError(Replaced(text, "offset=\"0\"", ""), "does not say where");
  expectError(Replaced(text, "\"raw\"", "\"hex\""), "unknown encoding \"hex\"");
  expectError(Replaced(text, "\n  _", "\n  -"), "underscore");
  expectError(text.substr(0, text.find('_', text.find("<AppendedData"))), "ends before its appended data");
}

TEST_F(VTUMeshIOTest, ThrowsOnTruncatedFile)
{
  std::vector<std::string> files;
  for (const Mode mode : modes)
  {
    Write(MakeTetrahedra().GetPointer(), Name(), mode);
    files.push_back(Content(Name()));
  }
  for (const std::string & file : files)
  {
    const std::size_t end = file.find("</VTKFile>") + std::string("</VTKFile>").size();
    for (std::size_t size = 0; size < end; size += 7)
    {
      Save(Name(), file.substr(0, size));
      EXPECT_NE(ReadingError(Name()), "") << size << " bytes of\n" << file;
    }
  }
  // Of raw data the last array ends the file.
  const std::string raw = FileMaker({ Layout::AppendedRaw }).Make();
  for (std::size_t size = raw.find("\n</AppendedData>") - 1; size > 0; size -= 7)
  {
    Save(Name(), raw.substr(0, size));
    EXPECT_NE(ReadingError(Name()), "") << size;
    if (size < 7)
    {
      break;
    }
  }
}

TEST_F(VTUMeshIOTest, NeverCrashesOnBitFlips)
{
  std::vector<std::string> files{ smallFile };
  for (const Mode mode : modes)
  {
    Write(MakeTetrahedra().GetPointer(), Name(), mode);
    files.push_back(Content(Name()));
  }
  for (const Layout layout : { Layout::Inline, Layout::AppendedRaw, Layout::AppendedBase64 })
  {
    for (const bool compressed : { false, true })
    {
      files.push_back(FileMaker({ layout, compressed, false, 4 }).Make());
    }
  }
  std::mt19937 random(20240607);
  std::size_t  rejected = 0;
  for (const std::string & file : files)
  {
    for (int trial = 0; trial < 500; ++trial)
    {
      std::string damaged = file;
      for (std::size_t flips = 1 + random() % 3; flips > 0; --flips)
      {
        damaged[random() % damaged.size()] ^= static_cast<char>(1 << (random() % 8));
      }
      if (trial % 10 == 0)
      {
        damaged.resize(random() % damaged.size());
      }
      Save(Name(), damaged);
      // Anything but an ExceptionObject fails the test.
      rejected += ReadingError(Name()).empty() ? 0 : 1;
    }
  }
  EXPECT_GT(rejected, 500 * files.size() / 2);
}
