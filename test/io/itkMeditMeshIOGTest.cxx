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

#include "itkMeditMeshIO.h"
#include "itkMeditMeshIOFactory.h"

#include "itkFixedArray.h"
#include "itkMeshIOFactory.h"
#include "itkVertexCell.h"

#include <limits>

using namespace mmmGroupedTest;

namespace
{
using IO = itk::MeditMeshIO;

class MeditMeshIOTest : public VTUMeshIOTest
{
protected:
  std::string
  File() const
  {
    return this->Name("mesh.mesh");
  }

  template <typename TMesh>
  void
  Write(const TMesh * mesh) const
  {
    WriteBy(IO::New(), mesh, this->File(), true);
  }
};

/** As other programs write it: comments, other keywords, blanks at will. */
constexpr const char * smallMesh = R"(
# by hand
MeshVersionFormatted 1 Dimension
3
Vertices 4
0 0 0 0   1 0 0 0
0 1 0 -3  # a comment
0 0 1 0
Corners
2
1 4
Tetrahedra
1
1 2 3 4 -17
Triangles
1
2 3 4 5
RequiredTriangles
1 1
End
)";
} // namespace

TEST_F(MeditMeshIOTest, ClaimsOnlyMeshFiles)
{
  const auto io = IO::New();
  EXPECT_TRUE(io->CanWriteFile("a.mesh"));
  EXPECT_FALSE(io->CanWriteFile("a.msh"));
  EXPECT_FALSE(io->CanWriteFile("a.meshb"));
  EXPECT_FALSE(io->CanReadFile(File().c_str()));
}

TEST_F(MeditMeshIOTest, IsFoundByReadersAndWritersOnceItsFactoryIsRegistered)
{
  itk::MeditMeshIOFactory::RegisterOneFactory();
  const auto io = itk::MeshIOFactory::CreateMeshIO("new.mesh", itk::MeshIOFactory::IOFileModeEnum::WriteMode);
  ASSERT_TRUE(io.IsNotNull());
  EXPECT_STREQ(io->GetNameOfClass(), "MeditMeshIO");
}

TEST_F(MeditMeshIOTest, WritesTetrahedraThatReadBackUnchanged)
{
  Write(MakeTetrahedra().GetPointer());
  ExpectTetrahedra(ReadBy(IO::New(), File()));
  // References may be negative.
  EXPECT_FALSE(Contains(Content(File()), "#"));
}

TEST_F(MeditMeshIOTest, WritesCellsByShape)
{
  Write(MakeMixed<int>({ 1, 2, 3, 4 }).GetPointer());
  EXPECT_EQ(LabelsBy(IO::New(), File()), (std::vector<std::int64_t>{ 1, 3, 2, 4 }));
}

TEST_F(MeditMeshIOTest, KeepsLabelsBeyondInts)
{
  const std::vector<std::int64_t> labels{ std::numeric_limits<std::int64_t>::max(),
                                          std::numeric_limits<std::int64_t>::min() };
  const auto                      warnings = Warnings::Catch();
  Write(MakeMixed<std::int64_t>(labels).GetPointer());
  EXPECT_TRUE(Contains(warnings->Release(), "label -9223372036854775808 is 1"));
  EXPECT_EQ(LabelsBy(IO::New(), File()), labels);
}

TEST_F(MeditMeshIOTest, KeepsPairsOfLabels)
{
  using Pair = itk::FixedArray<int, 2>;
  const int values[][2] = { { 0, 2 }, { -5, 70000 } };
  Write(MakeMixed<Pair>({ values[0], values[1] }).GetPointer());
  EXPECT_TRUE(Contains(Content(File()), "# group 3 1: labels -5 70000\n"));
  EXPECT_EQ(LabelsBy(IO::New(), File()), (std::vector<std::int64_t>{ 0, 2, -5, 70000 }));
}

TEST_F(MeditMeshIOTest, ReadsFilesOfOtherPrograms)
{
  Save(File(), smallMesh);
  const auto mesh = ReadBy(IO::New(), File());
  ASSERT_EQ(mesh->GetNumberOfPoints(), 4u);
  EXPECT_EQ(mesh->GetPoint(3)[2], 1);
  ASSERT_EQ(mesh->GetNumberOfCells(), 2u);
  MeshType::CellAutoPointer cell;
  ASSERT_TRUE(mesh->GetCell(1, cell));
  EXPECT_EQ(PointIds(cell.GetPointer()), (std::vector<itk::IdentifierType>{ 1, 2, 3 }));
  EXPECT_EQ(mesh->GetCellData()->ElementAt(0), -17);
  EXPECT_EQ(mesh->GetCellData()->ElementAt(1), 5);
}

TEST_F(MeditMeshIOTest, ReadsTwoDimensions)
{
  Save(File(), "MeshVersionFormatted 2\nDimension 2\nVertices\n3\n0 0 0\n1 0 0\n0 1 0\nTriangles\n1\n1 2 3 4\nEnd\n");
  const auto mesh = ReadBy(IO::New(), File());
  ASSERT_EQ(mesh->GetNumberOfPoints(), 3u);
  EXPECT_EQ(mesh->GetPoint(2)[1], 1);
  EXPECT_EQ(mesh->GetPoint(2)[2], 0);
}

TEST_F(MeditMeshIOTest, ThrowsOnVerticesAsCells)
{
  const auto mesh = MeshType::New();
  AddPoints(mesh.GetPointer());
  AddCell<itk::VertexCell<MeshType::CellType>>(mesh.GetPointer(), { 0 });
  EXPECT_THROW(Write(mesh.GetPointer()), itk::ExceptionObject);
  EXPECT_EQ(NumberOfFiles(), 0u);
}

TEST_F(MeditMeshIOTest, SaysWhatIsWrongWithAFile)
{
  constexpr GroupedDamage damages[]{
    { "MeshVersionFormatted 1", "mesh", "\"mesh\" is not MeshVersionFormatted" },
    { "MeshVersionFormatted 1", "MeshVersionFormatted 9", "the version is 9" },
    { "Dimension\n3", "Dimension\n4", "the dimension is 4" },
    { "Vertices 4", "Vertices 1000000", "too short for 1000000 vertices" },
    { "Vertices 4", "Vertices 1152921504606846976", "too short for 1152921504606846976 vertices" },
    { "Vertices 4", "Vertices NaN", "\"NaN\" is not a count" },
    { "Vertices 4", "Vertices 5", "in line 9, \"Corners\" is not a number" },
    { "Vertices 4", "Vertexes 4", "there are no Vertices" },
    { "Corners\n2", "Vertices\n1 0 0 0 0", "a second section Vertices" },
    { "0 1 0 -3", "0 1,5 0 -3", "\"1,5\" is not a number" },
    { "Tetrahedra\n1", "Tetrahedra\n100000", "too short for 100000 Tetrahedra" },
    { "Tetrahedra\n1", "Tetrahedra\n2", "\"Triangles\" is not a count" },
    { "1 2 3 4 -17", "1 2 3 5 -17", "its cell 0 refers to a point that is not one of its 4" },
    { "1 2 3 4 -17", "0 2 3 4 -17", "its cell 0 refers to a point that is not one of its 4" },
    { "1 2 3 4 -17", "1 2 3 4 -3000000000", "\"-3000000000\" is not a whole number" },
    { "End", "", "the file ends too early" },
  };
  for (const GroupedDamage & damage : damages)
  {
    Save(File(), Replaced(smallMesh, damage.part, damage.by));
    const std::string error = ErrorBy(IO::New(), File());
    EXPECT_TRUE(Contains(error, File())) << error;
    EXPECT_TRUE(Contains(error, damage.error)) << "expected: " << damage.error << "\nactual: " << error;
  }
}

TEST_F(MeditMeshIOTest, ThrowsOnTruncatedFile)
{
  Write(MakeTetrahedra().GetPointer());
  const std::string file = Content(File());
  for (std::size_t size = 0; size + 1 < file.size(); ++size)
  {
    Save(File(), file.substr(0, size));
    EXPECT_NE(ErrorBy(IO::New(), File()), "") << size << " bytes of " << file.size();
  }
}

TEST_F(MeditMeshIOTest, NeverCrashesOnDamagedFiles)
{
  Write(MakeTetrahedra().GetPointer());
  const auto [rejected, all] = ReadDamaged<IO>({ smallMesh, Content(File()) }, File(), 500);
  EXPECT_GT(rejected, all / 5);
}
