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

using namespace mmmGroupedTest;

namespace
{
using IO = itk::GmshMeshIO;

class GmshMeshIOReadTest : public VTUMeshIOTest
{
protected:
  std::string
  File() const
  {
    return this->Name("mesh.msh");
  }

  template <std::size_t VCount>
  void
  ExpectErrors(const std::string & text, const GroupedDamage (&damages)[VCount]) const
  {
    Save(this->File(), text);
    ASSERT_EQ(ErrorBy(IO::New(), this->File()), "");
    for (const GroupedDamage & damage : damages)
    {
      Save(this->File(), Replaced(text, damage.part, damage.by));
      const std::string error = ErrorBy(IO::New(), this->File());
      EXPECT_TRUE(Contains(error, this->File())) << error;
      EXPECT_TRUE(Contains(error, damage.error)) << "expected: " << damage.error << "\nactual: " << error;
    }
  }

  /** All files of a mesh that there can be. */
  std::vector<std::string>
  AllFormats() const
  {
    std::vector<std::string> files;
    const auto               mesh = MakeMixed<int>({ 7, 3, 5, 3 });
    for (const bool isVersion2 : { false, true })
    {
      for (const bool isText : { false, true })
      {
        const auto io = IO::New();
        io->SetVersion2(isVersion2);
        WriteBy(io.GetPointer(), mesh.GetPointer(), this->File(), isText);
        files.push_back(Content(this->File()));
      }
    }
    return files;
  }
};

/** Nodes with gaps in their numbers, elements in reverse order, and sections that are not of interest. */
constexpr const char * text2 = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
1
3 9 "brain"
$EndPhysicalNames
$Nodes
4
10 0 0 0
7 1 0 0
1000000 0 1 0
1 0 0 1
$EndNodes
$Elements
2
22 4 2 9 1 10 7 1000000 1
21 2 3 5 1 0 7 1000000 1
$EndElements
$ElementData
1
"a view"
$EndElementData
)";

constexpr const char * text4 = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$Comments
Nodes and $Elements of which nothing is read
$EndComments
$Entities
1 0 1 1
3 0 0 0 0
8 0 0 0 1 1 1 1 -5 2 1 -2
4 0 0 0 1 1 1 1 9 1 8
$EndEntities
$Nodes
2 4 1 40
2 8 1 1
10
0 0 0 0.5 0.5
3 4 0 3
20
30
40
1 0 0
0 1 0
0 0 1
$EndNodes
$Elements
2 2 21 22
3 4 4 1
22 10 20 30 40
2 8 2 1
21 20 30 40
$EndElements
)";
} // namespace

TEST_F(GmshMeshIOReadTest, ReadsFilesOfOtherPrograms)
{
  for (const char * const text : { text2, text4 })
  {
    Save(File(), text);
    const auto mesh = ReadBy(IO::New(), File());
    ASSERT_EQ(mesh->GetNumberOfPoints(), 4u);
    EXPECT_EQ(mesh->GetPoint(1)[0], 1);
    EXPECT_EQ(mesh->GetPoint(3)[2], 1);
    ASSERT_EQ(mesh->GetNumberOfCells(), 2u);
    MeshType::CellAutoPointer cell;
    ASSERT_TRUE(mesh->GetCell(0, cell));
    EXPECT_EQ(PointIds(cell.GetPointer()), (std::vector<itk::IdentifierType>{ 1, 2, 3 }));
    ASSERT_TRUE(mesh->GetCell(1, cell));
    EXPECT_EQ(PointIds(cell.GetPointer()), (std::vector<itk::IdentifierType>{ 0, 1, 2, 3 }));
    EXPECT_EQ(mesh->GetCellData()->ElementAt(0), 5);
    EXPECT_EQ(mesh->GetCellData()->ElementAt(1), 9);
  }
}

TEST_F(GmshMeshIOReadTest, ReadsLinesOfWindows)
{
  std::string text;
  for (const char c : std::string(text4))
  {
    text += c == '\n' ? "\r\n" : std::string(1, c);
  }
  Save(File(), text);
  EXPECT_EQ(ErrorBy(IO::New(), File()), "");
}

TEST_F(GmshMeshIOReadTest, ReadsTheOtherByteOrder)
{
  const auto swapped = [](auto value) {
    std::string bytes(reinterpret_cast<const char *>(&value), sizeof value);
    std::reverse(bytes.begin(), bytes.end());
    return bytes;
  };
  const auto ints = [&](const std::vector<std::int32_t> & values) {
    std::string bytes;
    for (const auto value : values)
    {
      bytes += swapped(value);
    }
    return bytes;
  };
  std::string text = "$MeshFormat\n2.2 1 8\n" + swapped(std::int32_t{ 1 }) + "\n$EndMeshFormat\n$Nodes\n3\n";
  for (std::int32_t node = 1; node <= 3; ++node)
  {
    text += ints({ node }) + swapped(third * node) + swapped(0.0) + swapped(-1.0);
  }
  text += "\n$EndNodes\n$Elements\n1\n" + ints({ 2, 1, 2, 1, 70000, 1, 3, 2, 1 }) + "\n$EndElements\n";
  Save(File(), text);
  const auto mesh = ReadBy(IO::New(), File());
  ASSERT_EQ(mesh->GetNumberOfPoints(), 3u);
  EXPECT_EQ(mesh->GetPoint(2)[0], third * 3);
  ASSERT_EQ(mesh->GetNumberOfCells(), 1u);
  EXPECT_EQ(mesh->GetCellData()->ElementAt(0), 70000);
}

TEST_F(GmshMeshIOReadTest, TakesTheFirstOfSeveralGroupsAndSaysSo)
{
  Save(File(), Replaced(text4, "1 1 1 1 9 1 8", "1 1 1 2 9 6 1 8"));
  const auto warnings = Warnings::Catch();
  EXPECT_EQ(LabelsBy(IO::New(), File()), (std::vector<std::int64_t>{ 5, 9 }));
  EXPECT_TRUE(Contains(warnings->Release(), "several physical groups"));
}

TEST_F(GmshMeshIOReadTest, SaysWhatIsWrongWithAFileOfVersion2)
{
  constexpr GroupedDamage damages[]{
    { "$MeshFormat", "(0 \"Fluent\")", "\"(0\" is not $MeshFormat" },
    { "2.2 0 8", "1.0 0 8", "in line 2, the version is \"1.0\"; 2.2 and 4.1 are read" },
    { "2.2 0 8", "2.2 0 4", "numbers have 4 bytes" },
    { "2.2 0 8", "2.2 3 8", "the file type is 3" },
    { "2.2 0 8", "2.2 1 8", "no number 1" },
    { "3 9 \"brain\"", "3 9 brain", "no name in quotation marks" },
    { "$Nodes\n4", "$Nodes\n1000000", "too short for 1000000 nodes" },
    { "$Nodes\n4", "$Nodes\n1152921504606846976", "too short for 1152921504606846976 nodes" },
    { "$Nodes\n4", "$Nodes\nNaN", "\"NaN\" is not a count" },
    { "$Nodes\n4", "$Nodes\n-4", "\"-4\" is not a count" },
    { "$Nodes\n4", "$Nodes\n3", "\"1\" is not $EndNodes" },
    { "10 0 0 0", "10 0 zero 0", "in line 10, \"zero\" is not a number" },
    { "7 1 0 0", "10 1 0 0", "two nodes have the number 10" },
    { "$Elements\n2", "$Elements\n1000000", "too short for 1000000 elements" },
    { "$Elements\n2", "$Elements\n1", "is not $EndElements" },
    { "22 4 2", "22 11 2", "Gmsh's type 11" },
    { "22 4 2", "22 4 1000000000", "is not a whole number" },
    { "10 7 1000000 1", "10 7 1000001 1", "the node 1000001, which is not in the file" },
    { "10 7 1000000 1", "10 7 0 1", "the node 0, which is not in the file" },
    { "$EndElements\n", "$EndElement\n", "\"$EndElement\" is not $EndElements" },
    { "$EndElementData", "", "there is no \"$EndElementData\"" },
    { "$ElementData", "ElementData", "\"ElementData\" is no section" },
    { "$PhysicalNames", "$Entities", "which this version does not have" },
    { "$ElementData", "$Nodes", "a second section $Nodes" },
  };
  ExpectErrors(text2, damages);
}

TEST_F(GmshMeshIOReadTest, SaysWhatIsWrongWithAFileOfVersion4)
{
  constexpr GroupedDamage damages[]{
    { "4.1 0 8", "4.0 0 8", "the version is \"4.0\"" },
    { "1 0 1 1\n", "1000000 0 1 1\n", "too short for 1000000 entities" },
    { "1 -5 2 1 -2", "100000 -5 2 1 -2", "too short for 100000 physical groups" },
    { "1 -5 2 1 -2", "1 -5 100000 1 -2", "too short for 100000 bounds" },
    { "2 4 1 40", "2 1000000 1 40", "too short for 1000000 nodes" },
    { "2 4 1 40", "2 5 1 40", "there are 4 nodes, where 5 are announced" },
    { "2 8 1 1\n", "2 8 1 100000\n", "too short for 100000 nodes in a block" },
    { "2 4 1 40", "1 1 1 40", "is not $EndNodes" },
    { "2 2 21 22", "2 100000 21 22", "too short for 100000 elements" },
    { "2 2 21 22", "2 3 21 22", "there are 2 elements, where 3 are announced" },
    { "2 2 21 22", "1000000 2 21 22", "is not a whole number" },
    { "3 4 4 1\n", "3 4 4 100000\n", "too short for 100000 elements in a block" },
    { "3 4 4 1\n", "3 4 99 1\n", "Gmsh's type 99" },
    { "3 4 4 1\n", "2 4 4 1\n", "have another one" },
    { "22 10 20 30 40", "22 10 20 30 41", "the node 41, which is not in the file" },
    { "22 10 20 30 40", "22 10 20 30 18446744073709551616", "\"18446744073709551616\" is not a count" },
    { "$Elements\n2", "$Element\n2", "is no section" },
  };
  ExpectErrors(text4, damages);
}

TEST_F(GmshMeshIOReadTest, ThrowsOnBinaryFilesThatAnnounceMoreThanThereIs)
{
  // A count in version 4.1 is 8 bytes, one of version 2.2 is text.
  const auto files = AllFormats();
  for (const std::uint64_t count : { std::uint64_t{ 1000000 }, std::uint64_t{ 1 } << 60, ~std::uint64_t{ 0 } })
  {
    const std::string bytes(reinterpret_cast<const char *>(&count), sizeof count);
    for (const char * const section : { "$Entities\n", "$Nodes\n", "$Elements\n" })
    {
      const auto begin = files[0].find(section) + std::string(section).size();
      for (std::size_t number = 0; number < 2; ++number)
      {
        std::string damaged = files[0];
        damaged.replace(begin + 8 * number, 8, bytes);
        Save(File(), damaged);
        EXPECT_NE(ErrorBy(IO::New(), File()), "") << section << number << ' ' << count;
      }
    }
    for (const char * const section : { "$Nodes\n5\n", "$Elements\n4\n" })
    {
      const std::string name = std::string(section).substr(0, std::string(section).find('\n') + 1);
      Save(File(), Replaced(files[2], section, name + std::to_string(count) + '\n'));
      EXPECT_TRUE(Contains(ErrorBy(IO::New(), File()), "too short")) << section << count;
    }
  }
}

TEST_F(GmshMeshIOReadTest, ThrowsOnTruncatedFile)
{
  for (const std::string & file : AllFormats())
  {
    for (std::size_t size = 0; size + 1 < file.size(); size += 3)
    {
      Save(File(), file.substr(0, size));
      EXPECT_NE(ErrorBy(IO::New(), File()), "") << size << " bytes of " << file.size();
    }
  }
}

TEST_F(GmshMeshIOReadTest, NeverCrashesOnDamagedFiles)
{
  auto files = AllFormats();
  files.push_back(text2);
  files.push_back(text4);
  const auto warnings = Warnings::Catch();
  const auto [rejected, all] = ReadDamaged<IO>(files, File(), 300);
  warnings->Release();
  EXPECT_GT(rejected, all / 5);
}

TEST_F(GmshMeshIOReadTest, DoesNotTakeALongNameForAListOfLabels)
{
  std::string name = "labels";
  for (int i = 0; i < 100000; ++i)
  {
    name += " 1";
  }
  Save(File(), Replaced(Replaced(text2, "brain", name), "21 2 3 5", "21 2 3 9"));
  EXPECT_EQ(LabelsBy(IO::New(), File()), (std::vector<std::int64_t>{ 9, 9 }));
}
