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

using namespace mmmVTUTest;

namespace
{
/** A damage of the small file, and a part of what reading has to say of it. */
struct Damage
{
  const char * part;
  const char * by;
  const char * error;
};

constexpr Damage damages[]{
  { "<VTKFile", "<svg", "it begins with <svg>" },
  { "type=\"UnstructuredGrid\"", "type=\"PolyData\"", "PolyData" },
  { "<UnstructuredGrid>", "<!-- --><PolyData>", "mismatched tag" },
  { "<VTKFile", "<!DOCTYPE a [<!ENTITY b \"c\">]><VTKFile", "document type declaration" },
  { "byte_order", "compressor=\"vtkLZ4DataCompressor\" byte_order", "vtkLZ4DataCompressor" },
  { "LittleEndian", "MiddleEndian", "MiddleEndian" },
  { "byte_order", "header_type=\"UInt128\" byte_order", "UInt128" },
  { "<Piece", "<Piece NumberOfPoints=\"0\" NumberOfCells=\"0\"/><Piece", "several pieces" },
  { "NumberOfPoints=\"3\"", "", "<Piece> has no NumberOfPoints" },
  { "NumberOfPoints=\"3\"", "NumberOfPoints=\"-3\"", "\"-3\", which is not a count" },
  { "NumberOfPoints=\"3\"", "NumberOfPoints=\"1152921504606846976\"", "too short" },
  { "NumberOfPoints=\"3\"", "NumberOfPoints=\"18446744073709551615\"", "more points than there can be" },
  { "NumberOfPoints=\"3\"", "NumberOfPoints=\"18446744073709551616\"", "not a count" },
  { "NumberOfPoints=\"3\"", "NumberOfPoints=\"2\"", "holds 9 values, where 6 are expected" },
  { "NumberOfCells=\"2\"", "NumberOfCells=\"1000000\"", "1000000" },
  { "NumberOfCells=\"2\"", "NumberOfCells=\"1152921504606846976\"", "1152921504606846976" },
  { "NumberOfComponents=\"3\"", "NumberOfComponents=\"2\"", "three components" },
  { "NumberOfComponents=\"3\"", "", "three components" },
  { "Name=\"label\"", "Name=\"label\" NumberOfComponents=\"0\"", "0 components" },
  { "Name=\"label\"", "Name=\"label\" NumberOfComponents=\"9999999999\"", "9999999999 components" },
  { "Name=\"label\"", "Name=\"label\" NumberOfComponents=\"3\"", "6" },
  { "Name=\"offsets\"", "Name=\"offsets\" NumberOfComponents=\"2\"", "offsets" },
  { "Name=\"offsets\"", "Name=\"ofsets\"", "no array \"offsets\"" },
  { "Int32", "Int31", "has the type \"Int31\", which is not supported" },
  { "Int64\" Name=\"offsets", "Float32\" Name=\"offsets", "one integer per value" },
  { ">5 6<", ">  5  <", "holds 1 values, where 2 are expected" },
  { ">5 6<", ">5 six<", "\"six\"" },
  { ">5 6<", ">5 2147483648<", "\"2147483648\"" },
  { ">5 6<", ">5 6.5<", "\"6.5\"" },
  { "0 0 0 1 0", "0 0 0 1,5 0", "\"1,5\"" },
  { "format=\"ascii\">5", "format=\"hex\">5", "unknown format \"hex\"" },
  { "format=\"ascii\">5", "format=\"binary\">5", "\"label\"" },
  { "format=\"ascii\">5", "format=\"appended\" offset=\"0\">5", "appended" },
  { ">2 5<", ">2 6<", "its cell 1 has the offset 6" },
  { ">2 5<", ">2 1<", "its cell 1 has the offset 1" },
  { ">2 5<", ">-2 5<", "its cell 0 has the offset -2" },
  { ">0 1 0 1 2<", ">0 1 0 1 2 2<", "\"connectivity\" has 6" },
  { ">0 1 0 1 2<", ">0 1 0 1 3<", "its cell 1 refers to the point 3 of 3" },
  { ">0 1 0 1 2<", ">0 1 0 1 -1<", "its cell 1 refers to the point -1 of 3" },
  { ">3 5<", ">5 5<", "its cell 0 is a triangle (VTK cell type 5) of 2 points" },
  { ">3 5<", ">3 13<", "its cell 1 is a wedge (VTK cell type 13), which ITK meshes cannot hold" },
  { ">3 5<", ">3 72<", "VTK cell type 72" },
  { ">3 5<", ">3 300<", "\"300\"" },
};
} // namespace

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
  EXPECT_TRUE(Contains(ReadingError(Name()), "No such file or directory"));
  Save(Name(), "");
  EXPECT_TRUE(Contains(ReadingError(Name()), "no element found"));
  for (const Damage & damage : damages)
  {
    Save(Name(), Replaced(smallFile, damage.part, damage.by));
    const std::string error = ReadingError(Name());
    EXPECT_TRUE(Contains(error, Name())) << error;
    EXPECT_TRUE(Contains(error, damage.error)) << "expected: " << damage.error << "\nactual: " << error;
  }
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
  constexpr std::uint64_t          huge = std::uint64_t{ 1 } << 60;
  const std::vector<std::uint64_t> plain[]{ {}, { 40 }, { 39, 1, 2, 3, 4, 5 }, { huge }, { ~std::uint64_t{ 7 } } };
  const std::vector<std::uint64_t> compressed[]{ {},
                                                 { huge, 8, 0 },
                                                 { 1, huge, 0, 20, 0, 0 },
                                                 { 1, huge, 40, 20, 0, 0, 0 },
                                                 { 1, 40, 48, 20, 0, 0, 0 },
                                                 { 1, 1 << 30, 0, 8, 0 },
                                                 { 1, 40, 0, huge, 0 },
                                                 { 2, 40, 0, 8, ~std::uint64_t{ 0 }, 0 },
                                                 { 1, 40, 0, 8, 0 },
                                                 { 1, 0, 0, 0 } };
  for (const auto & header : plain)
  {
    expectError(false, header);
  }
  for (const auto & header : compressed)
  {
    expectError(true, header);
  }
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

TEST_F(VTUMeshIOTest, NeverCrashesOnDamagedFiles)
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
  const auto [rejected, all] = CountRejected(files, 300, [&](const std::string & damaged) {
    Save(Name(), damaged);
    return !ReadingError(Name()).empty();
  });
  EXPECT_GT(rejected, all / 2);
}
