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
#include "support/TestGroupedFiles.h"

#include "itkGmshMeshIO.h"
#include "itkGmshMeshIOFactory.h"

#include "itkFixedArray.h"
#include "itkHexahedronCell.h"
#include "itkLineCell.h"
#include "itkMeshIOFactory.h"
#include "itkQuadrilateralCell.h"
#include "itkVertexCell.h"

#include <limits>
#include <locale>

#if defined(__unix__) || defined(__APPLE__)
#  include <csignal>
#  include <sys/resource.h>
#endif

using namespace mmmGroupedTest;

namespace
{
using IO = itk::GmshMeshIO;

struct Format
{
  bool isVersion2;
  bool isText;
};
constexpr Format formats[]{ { false, false }, { false, true }, { true, false }, { true, true } };

class GmshMeshIOTest : public VTUMeshIOTest
{
protected:
  std::string
  File() const
  {
    return this->Name("mesh.msh");
  }

  template <typename TMesh>
  void
  WriteAs(const Format & format, const TMesh * mesh, IO * io = nullptr) const
  {
    const IO::Pointer used = io ? io : IO::New().GetPointer();
    used->SetVersion2(format.isVersion2);
    WriteBy(used.GetPointer(), mesh, this->File(), format.isText);
  }
};

class CommaNumbers : public std::numpunct<char>
{
protected:
  char
  do_decimal_point() const override
  {
    return ',';
  }
  std::string
  do_grouping() const override
  {
    return "\3";
  }
};
} // namespace

TEST_F(GmshMeshIOTest, ClaimsOnlyMshFiles)
{
  const auto io = IO::New();
  EXPECT_TRUE(io->CanWriteFile("a.msh"));
  EXPECT_TRUE(io->CanWriteFile("A.MSH"));
  EXPECT_FALSE(io->CanWriteFile("a.mesh"));
  EXPECT_FALSE(io->CanWriteFile("a.vtk"));
  EXPECT_FALSE(io->CanWriteFile(nullptr));
  EXPECT_FALSE(io->CanReadFile(File().c_str()));
  Save(File(), "");
  EXPECT_TRUE(io->CanReadFile(File().c_str()));
}

TEST_F(GmshMeshIOTest, IsFoundByReadersAndWritersOnceItsFactoryIsRegistered)
{
  itk::GmshMeshIOFactory::RegisterOneFactory();
  const auto io = itk::MeshIOFactory::CreateMeshIO("new.msh", itk::MeshIOFactory::IOFileModeEnum::WriteMode);
  ASSERT_TRUE(io.IsNotNull());
  EXPECT_STREQ(io->GetNameOfClass(), "GmshMeshIO");
}

TEST_F(GmshMeshIOTest, PrintsItsSettings)
{
  const auto io = IO::New();
  io->SetGroupNames({ { { 3, 5 }, "brain" } });
  std::ostringstream printed;
  io->Print(printed);
  EXPECT_TRUE(Contains(printed.str(), "Version2: Off"));
  EXPECT_TRUE(Contains(printed.str(), "RAS: Off"));
  EXPECT_TRUE(Contains(printed.str(), "dimension 3, number 5: brain"));
}

TEST_F(GmshMeshIOTest, WritesMixedCellsThatReadBackUnchanged)
{
  const auto mesh = MakeMixed<int>({ 7, 3, 100000, 3, 7, std::numeric_limits<int>::max() });
  for (const Format & format : formats)
  {
    WriteAs(format, mesh.GetPointer());
    ExpectSame<MeshType>(ReadBy(IO::New(), File()), mesh);
  }
}

TEST_F(GmshMeshIOTest, WritesAllShapes)
{
  const auto mesh = MeshType::New();
  AddPoints(mesh.GetPointer());
  AddPoints(mesh.GetPointer());
  using Cell = MeshType::CellType;
  AddCell<itk::HexahedronCell<Cell>>(mesh.GetPointer(), { 7, 6, 5, 4, 3, 2, 1, 0 });
  AddCell<itk::VertexCell<Cell>>(mesh.GetPointer(), { 9 });
  AddCell<itk::LineCell<Cell>>(mesh.GetPointer(), { 8, 0 });
  AddCell<itk::QuadrilateralCell<Cell>>(mesh.GetPointer(), { 1, 3, 5, 7 });
  AddCell<itk::TriangleCell<Cell>>(mesh.GetPointer(), { 1, 3, 5 });
  for (itk::IdentifierType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    mesh->SetCellData(i, 4);
  }
  for (const Format & format : formats)
  {
    WriteAs(format, mesh.GetPointer());
    ExpectSame<MeshType>(ReadBy(IO::New(), File()), mesh);
  }
}

TEST_F(GmshMeshIOTest, WritesTheVersionAndTypeThatAreAskedFor)
{
  const char * const headers[]{ "4.1 1 8\n", "4.1 0 8\n", "2.2 1 8\n", "2.2 0 8\n" };
  for (int i = 0; i < 4; ++i)
  {
    WriteAs(formats[i], MakeMixed<int>({ 1, 2 }).GetPointer());
    EXPECT_EQ(Content(File()).rfind("$MeshFormat\n" + std::string(headers[i]), 0), 0u);
  }
}

TEST_F(GmshMeshIOTest, GivesEntitiesTheNumbersOfTheirGroups)
{
  WriteAs({ false, true }, MakeMixed<int>({ 7, 3, 100000, 3, 7, 12 }).GetPointer());
  const auto content = Content(File());
  // dimension, entity, type and count of a block of elements
  for (const char * const block : { "\n3 3 4 2\n", "\n3 12 4 1\n", "\n2 7 2 2\n" })
  {
    EXPECT_TRUE(Contains(content, block)) << block << content;
  }
}

TEST_F(GmshMeshIOTest, NumbersLabelsThatAreNoGroupsAndTellsWhich)
{
  // Groups of Gmsh are positive.
  const auto mesh = MakeMixed<int>({ 0, -7, 5, 3 });
  for (const Format & format : formats)
  {
    const auto warnings = Warnings::Catch();
    WriteAs(format, mesh.GetPointer());
    EXPECT_TRUE(Contains(warnings->Release(), "label -7 is 6, label 0 is 7"));
    EXPECT_TRUE(Contains(Content(File()), "\n3 6 \"label -7\"\n"));
    EXPECT_TRUE(Contains(Content(File()), "\n2 7 \"label 0\"\n"));
    EXPECT_TRUE(Contains(Content(File()), "\n2 5 \"label 5\"\n"));
    ExpectSame<MeshType>(ReadBy(IO::New(), File()), mesh);
  }
}

TEST_F(GmshMeshIOTest, KeepsLabelsOf64Bits)
{
  const std::vector<std::int64_t> labels{ std::numeric_limits<std::int64_t>::max(),
                                          std::numeric_limits<std::int64_t>::min(),
                                          std::int64_t{ 1 } << 31,
                                          std::numeric_limits<int>::max() };
  const auto                      warnings = Warnings::Catch();
  for (const Format & format : formats)
  {
    WriteAs(format, MakeMixed<std::int64_t>(labels).GetPointer());
    EXPECT_EQ(LabelsBy(IO::New(), File()), labels);
  }
  warnings->Release();
}

TEST_F(GmshMeshIOTest, KeepsPairsOfLabels)
{
  using Pair = itk::FixedArray<int, 2>;
  const int  values[][2] = { { 0, 2 }, { -5, 70000 }, { 0, 2 }, { 2, 5 } };
  const auto mesh = MakeMixed<Pair>({ values[0], values[1], values[2], values[3] });
  for (const Format & format : formats)
  {
    const auto warnings = Warnings::Catch();
    WriteAs(format, mesh.GetPointer());
    EXPECT_EQ(warnings->Release(), "");
    ExpectSame<MeshOf<Pair>>(ReadBy<MeshOf<Pair>>(IO::New(), File()), mesh);
  }
  EXPECT_TRUE(Contains(Content(File()), "\"labels -5 70000\""));
}

TEST_F(GmshMeshIOTest, WritesAndReadsNamesOfGroups)
{
  const IO::GroupNamesType names{ { { 2, 1001 }, "labels 0 5" },
                                  { { 3, 5 }, "gray \"matter\"" },
                                  { { 3, 9 }, "none" } };
  for (const Format & format : formats)
  {
    const auto io = IO::New();
    io->SetGroupNames(names);
    WriteAs(format, MakeMixed<int>({ 1001, 5 }).GetPointer(), io);
    const auto reader = IO::New();
    // Of groups of different kinds, the labels are their numbers.
    EXPECT_EQ(LabelsBy(reader, File()), (std::vector<std::int64_t>{ 1001, 5 }));
    EXPECT_EQ(reader->GetGroupNames(),
              (IO::GroupNamesType{ { { 2, 1001 }, "labels 0 5" }, { { 3, 5 }, "gray  matter " } }));
  }
}

TEST_F(GmshMeshIOTest, LeavesOutNamesOnRequest)
{
  for (const Format & format : formats)
  {
    const auto io = IO::New();
    io->WriteGroupNamesOff();
    WriteAs(format, MakeMixed<int>({ 8, 5 }).GetPointer(), io);
    EXPECT_FALSE(Contains(Content(File()), "$PhysicalNames"));
    EXPECT_EQ(LabelsBy(IO::New(), File()), (std::vector<std::int64_t>{ 8, 5 }));
  }
}

TEST_F(GmshMeshIOTest, TurnsRASBothWays)
{
  const auto mesh = MakeMixed<int>({ 1, 2 });
  for (const Format & format : formats)
  {
    const auto io = IO::New();
    io->RASOn();
    WriteAs(format, mesh.GetPointer(), io);
    const auto turned = ReadBy(IO::New(), File());
    EXPECT_EQ(turned->GetPoint(4)[0], -1.0);
    EXPECT_EQ(turned->GetPoint(4)[1], -1.0);
    EXPECT_EQ(turned->GetPoint(4)[2], 1.0);
    ExpectSame<MeshType>(ReadBy(io, File()), mesh);
  }
}

TEST_F(GmshMeshIOTest, MeshesWithoutLabelsHaveNoneAfterwards)
{
  const auto mesh = MeshType::New();
  AddPoints(mesh.GetPointer());
  AddCell<itk::TetrahedronCell<MeshType::CellType>>(mesh.GetPointer(), { 0, 1, 2, 3 });
  for (const Format & format : formats)
  {
    WriteAs(format, mesh.GetPointer());
    const auto read = ReadBy(IO::New(), File());
    EXPECT_EQ(read->GetNumberOfCells(), 1u);
    EXPECT_TRUE(read->GetCellData() == nullptr || read->GetCellData()->Size() == 0);
  }
}

TEST_F(GmshMeshIOTest, WritesPointsWithoutCellsAndNothing)
{
  const auto points = MeshType::New();
  AddPoints(points.GetPointer());
  for (const Format & format : formats)
  {
    WriteAs(format, points.GetPointer());
    EXPECT_EQ(ReadBy(IO::New(), File())->GetNumberOfPoints(), 5u);
    WriteAs(format, MeshType::New().GetPointer());
    EXPECT_EQ(ReadBy(IO::New(), File())->GetNumberOfPoints(), 0u);
  }
}

TEST_F(GmshMeshIOTest, FillsUpPointsOfTwoCoordinates)
{
  using FlatMesh = itk::Mesh<float, 2>;
  const auto   mesh = FlatMesh::New();
  const double point[]{ 3, 4 };
  mesh->SetPoint(0, point);
  WriteAs(formats[0], mesh.GetPointer());
  const auto read = ReadBy(IO::New(), File())->GetPoint(0);
  EXPECT_EQ(read[0], 3);
  EXPECT_EQ(read[1], 4);
  EXPECT_EQ(read[2], 0);
}

TEST_F(GmshMeshIOTest, KeepsCoordinatesThatAreNotFinite)
{
  const auto          mesh = MakeMixed<int>({ 1, 2 });
  MeshType::PointType point;
  point[0] = std::numeric_limits<double>::infinity();
  point[1] = std::numeric_limits<double>::quiet_NaN();
  point[2] = std::numeric_limits<double>::denorm_min();
  mesh->SetPoint(0, point);
  for (const Format & format : formats)
  {
    WriteAs(format, mesh.GetPointer());
    const auto read = ReadBy(IO::New(), File())->GetPoint(0);
    EXPECT_EQ(read[0], point[0]);
    EXPECT_NE(read[1], read[1]);
    EXPECT_EQ(read[2], point[2]);
  }
}

TEST_F(GmshMeshIOTest, WarnsThatDataOfPointsAreLeftOut)
{
  const auto mesh = MakeMixed<int>({ 1, 2 });
  for (itk::IdentifierType i = 0; i < 5; ++i)
  {
    mesh->SetPointData(i, 0.5f);
  }
  const auto warnings = Warnings::Catch();
  WriteAs(formats[0], mesh.GetPointer());
  EXPECT_TRUE(Contains(warnings->Release(), "The data of points are not in"));
}

TEST_F(GmshMeshIOTest, DoesNotDependOnTheLocale)
{
  const auto        mesh = MakeMixed<int>({ 10000, 20000 });
  const std::locale previous = std::locale::global(std::locale(std::locale::classic(), new CommaNumbers));
  for (const Format & format : formats)
  {
    WriteAs(format, mesh.GetPointer());
    ExpectSame<MeshType>(ReadBy(IO::New(), File()), mesh);
  }
  std::locale::global(previous);
}

TEST_F(GmshMeshIOTest, ThrowsOnLabelsThatAreNoWholeNumbers)
{
  for (const double label : { 2.5, std::numeric_limits<double>::quiet_NaN(), 1e19 })
  {
    EXPECT_THROW(WriteAs(formats[0], MakeMixed<double>({ 1.0, label }).GetPointer()), itk::ExceptionObject) << label;
  }
  EXPECT_EQ(NumberOfFiles(), 0u);
  WriteAs(formats[0], MakeMixed<double>({ 1.0, 2.0 }).GetPointer());
  EXPECT_EQ(LabelsBy(IO::New(), File()), (std::vector<std::int64_t>{ 1, 2 }));
}

TEST_F(GmshMeshIOTest, ThrowsOnCellsThatCannotBeWritten)
{
  const auto write = [&](std::vector<int> cells, itk::SizeValueType numberOfCells) {
    const auto io = IO::New();
    io->SetFileName(File());
    io->SetNumberOfPoints(3);
    io->SetPointComponentType(itk::IOComponentEnum::FLOAT);
    io->SetNumberOfCells(numberOfCells);
    io->SetCellBufferSize(cells.size());
    io->SetCellComponentType(itk::IOComponentEnum::INT);
    float points[9]{};
    io->WriteMeshInformation();
    io->WritePoints(points);
    io->WriteCells(cells.data());
    io->Write();
  };
  EXPECT_NO_THROW(write({ 2, 3, 0, 1, 2 }, 1));
  EXPECT_THROW(write({ 2, 3, 0, 1, 3 }, 1), itk::ExceptionObject);       // no such point
  EXPECT_THROW(write({ 2, 3, 0, 1, -1 }, 1), itk::ExceptionObject);      // no such point
  EXPECT_THROW(write({ 2, 2, 0, 1 }, 1), itk::ExceptionObject);          // a triangle of two points
  EXPECT_THROW(write({ 4, 5, 0, 1, 2, 0, 1 }, 1), itk::ExceptionObject); // a polygon
  EXPECT_THROW(write({ 2, 4, 0, 1, 2 }, 1), itk::ExceptionObject);       // buffer too short
  EXPECT_THROW(write({ 2, -1, 0, 1, 2 }, 1), itk::ExceptionObject);
  EXPECT_THROW(write({ 2, 3, 0, 1, 2 }, 2), itk::ExceptionObject);
  EXPECT_THROW(write({ 2, 3, 0, 1, 2, 0 }, 1), itk::ExceptionObject);
  EXPECT_THROW(write({ 2 }, 1), itk::ExceptionObject);
}

TEST_F(GmshMeshIOTest, ThrowsWhenPartsAreWrittenOrReadOutOfTurn)
{
  const auto io = IO::New();
  io->SetFileName(File());
  double buffer[15]{};
  EXPECT_THROW(io->Write(), itk::ExceptionObject);
  EXPECT_THROW(io->WritePoints(buffer), itk::ExceptionObject);
  EXPECT_THROW(io->ReadPoints(buffer), itk::ExceptionObject);
  EXPECT_THROW(io->ReadPointData(buffer), itk::ExceptionObject);
}

TEST_F(GmshMeshIOTest, ReplacesAnExistingFileAndLeavesNoOther)
{
  Save(File(), "old");
  WriteAs(formats[0], MakeMixed<int>({ 1, 2 }).GetPointer());
  EXPECT_EQ(ReadBy(IO::New(), File())->GetNumberOfCells(), 2u);
  EXPECT_EQ(NumberOfFiles(), 1u);
}

TEST_F(GmshMeshIOTest, KeepsNoPartialFileWhenTheFolderIsMissing)
{
  const std::string name = (m_Folder / "missing" / "mesh.msh").string();
  EXPECT_THROW(WriteBy(IO::New(), MakeMixed<int>({ 1, 2 }).GetPointer(), name, false), itk::ExceptionObject);
  EXPECT_EQ(NumberOfFiles(), 0u);
}

#if defined(__unix__) || defined(__APPLE__)
TEST_F(GmshMeshIOTest, KeepsTheOldFileWhenTheDiskIsFull)
{
  Save(File(), "old");
  rlimit limit{};
  getrlimit(RLIMIT_FSIZE, &limit);
  const rlimit small{ 100, limit.rlim_max };
  const auto   previous = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  for (const Format & format : formats)
  {
    EXPECT_THROW(WriteAs(format, MakeMixed<int>({ 1, 2 }).GetPointer()), itk::ExceptionObject);
  }
  setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, previous);
  EXPECT_EQ(Content(File()), "old");
  EXPECT_EQ(NumberOfFiles(), 1u);
}
#endif
