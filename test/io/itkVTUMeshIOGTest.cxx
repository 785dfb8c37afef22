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
#include "support/TestVTUFiles.h"

#include "itkVTUMeshIOFactory.h"

#include "itkFixedArray.h"
#include "itkHexahedronCell.h"
#include "itkLineCell.h"
#include "itkMeshIOFactory.h"
#include "itkTriangleCell.h"
#include "itkVertexCell.h"

#include <cmath>
#include <limits>
#include <locale>

#if defined(__unix__) || defined(__APPLE__)
#  include <csignal>
#  include <sys/resource.h>
#endif

using namespace mmmVTUTest;

namespace
{
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

TEST_F(VTUMeshIOTest, SaysThatCoordinatesAreLPSIfTold)
{
  const std::string space = "Name=\"SPACE\" NumberOfTuples=\"1\" format=\"ascii\">\n        76 80 83 0\n";
  const auto        io = itk::VTUMeshIO::New();
  Write(MakeTetrahedra().GetPointer(), Name(), Mode::Compressed, io);
  EXPECT_FALSE(Contains(Content(Name()), "SPACE"));
  io->WriteSpaceOn();
  Write(MakeTetrahedra().GetPointer(), Name(), Mode::Compressed, io);
  EXPECT_TRUE(Contains(Content(Name()), space));
  ExpectTetrahedra(Read(Name()));
}

TEST_F(VTUMeshIOTest, ReadsRASAsLPS)
{
  const auto io = itk::VTUMeshIO::New();
  io->WriteSpaceOn();
  Write(MakeTetrahedra().GetPointer(), Name(), Mode::Compressed, io);
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
    EXPECT_EQ(Read(Name())->GetPoint(1)[0], static_cast<float>(third));
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
    EXPECT_EQ(ReadCellPixels<unsigned char>(Name(), itk::VTUMeshIO::New()), std::vector<unsigned char>{ 200 });
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
  EXPECT_EQ(ReadCellPixels<int>(Name(), io), (std::vector<int>{ 9, 8, 7, 6, 5 }));

  // Without names, the arrays that have the default ones.
  EXPECT_EQ(ReadCellPixels<int>(Name(), itk::VTUMeshIO::New()), (std::vector<int>{ 8, 7, 6 }));
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
  EXPECT_EQ(ReadCellPixels<float>(Name(), itk::VTUMeshIO::New()), (std::vector<float>{ 1, 2.5f, 3 }));
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
