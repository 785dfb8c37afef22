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
// Names and colors of labels: the tables that are read, where they are found, and what is refused.
#include "itkLabelTableReader.h"

#include "itkImageFileReader.h" // registers ITK's formats
#include "itkMacro.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace
{
namespace fs = std::filesystem;

class LabelTableReader : public testing::Test
{
public:
  LabelTableReader()
    : m_Folder(fs::temp_directory_path() /
               ("label-table-" + std::to_string(std::hash<std::string>()(
                                   testing::UnitTest::GetInstance()->current_test_info()->name()))))
  {
    fs::create_directories(m_Folder);
  }

  ~LabelTableReader() override { fs::remove_all(m_Folder); }

  std::string
  Write(const std::string & name, const std::string & text) const
  {
    fs::create_directories((m_Folder / name).parent_path());
    std::ofstream(m_Folder / name, std::ios::binary) << text;
    return (m_Folder / name).string();
  }

  static mmm::LabelTable
  Read(const std::string & fileName)
  {
    const auto reader = itk::LabelTableReader::New();
    reader->SetFileName(fileName);
    reader->Read();
    return reader->GetLabelTable();
  }

  static std::string
  ErrorOf(const std::string & fileName)
  {
    try
    {
      Read(fileName);
    }
    catch (const itk::ExceptionObject & exception)
    {
      return exception.GetDescription();
    }
    return "";
  }

  void
  ExpectError(const std::string & name, const std::string & text, const std::string & message) const
  {
    const std::string file = this->Write(name, text);
    const std::string error = ErrorOf(file);
    EXPECT_NE(error.find(file + ": " + message), std::string::npos) << error;
  }

  static void
  ExpectEntry(const mmm::LabelTable & table, int label, const std::string & name, int red, int green, int blue)
  {
    const auto entry = table.find(label);
    ASSERT_NE(entry, table.end()) << label;
    EXPECT_EQ(entry->second.name, name);
    ASSERT_TRUE(entry->second.color) << label;
    const int expected[] = { red, green, blue };
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR((*entry->second.color)[c], expected[c] / 255.0, 1e-9) << label;
    }
  }

protected:
  fs::path m_Folder;
};

const char * const Header =
  "NRRD0005\ntype: unsigned char\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 2 2\n"
  "space directions: (1,0,0) (0,1,0) (0,0,1)\nencoding: raw\nspace origin: (0,0,0)\n";
} // namespace

TEST_F(LabelTableReader, FreeSurfersTable)
{
  const auto table = Read(this->Write("lut.txt",
                                      "#$Id$\r\n#No. Label Name:   R   G   B   A\r\n\r\n"
                                      "0   Unknown                 0   0   0   0\r\n"
                                      "3   Left-Cerebral-Cortex    205 62  78  0 \r\n"
                                      "  251\tCC_Posterior\t0\t0\t64\t0\n"));
  EXPECT_EQ(table.size(), 3u);
  ExpectEntry(table, 0, "Unknown", 0, 0, 0);
  ExpectEntry(table, 3, "Left-Cerebral-Cortex", 205, 62, 78);
  ExpectEntry(table, 251, "CC_Posterior", 0, 0, 64);
}

TEST_F(LabelTableReader, SlicersTableHasBlanksForUnderscores)
{
  const auto table = Read(this->Write("x.ctbl",
                                      "# Color table file x.ctbl\n# 2 values\n0 Background 0 0 0 0\n"
                                      "7 gray_matter 128 174 128 255\n"));
  ExpectEntry(table, 7, "gray matter", 128, 174, 128);
}

TEST_F(LabelTableReader, ItkSnapsDescription)
{
  const auto table = Read(this->Write("x.txt",
                                      "################\n# IDX   -R-  -G-  -B-  -A--  VIS MSH  LABEL\n"
                                      "    0     0    0    0        0  0  0    \"Clear Label\"\n"
                                      "    2     0  255    0      0.5  1  1    \"gray \"matter\"\n"));
  ExpectEntry(table, 2, "gray \"matter", 0, 255, 0);
  EXPECT_EQ(table.at(0).name, "Clear Label");
}

TEST_F(LabelTableReader, TableOfBIDS)
{
  const auto table = Read(this->Write("x_dseg.tsv",
                                      "\xef\xbb\xbf"
                                      "name\tindex\tabbreviation\tcolor\n"
                                      "Gray Matter\t1\tGM\t#ff53BB\nWhite Matter\t2\tWM\tn/a\n"));
  ExpectEntry(table, 1, "Gray Matter", 255, 83, 187);
  EXPECT_EQ(table.at(2).name, "White Matter");
  EXPECT_FALSE(table.at(2).color);
}

TEST_F(LabelTableReader, JsonInItsForms)
{
  const auto table =
    Read(this->Write("x.json",
                     "{\"1\": \"Knochen \\u00e4\\\"\", \"-2\": {\"name\": \"b\", \"color\": \"#00ff00\"},\n"
                     " \"3\": {\"color\": [0, 51, 255], \"name\": \"c\"}, \"4\": {\"name\": \"d\", "
                     "\"color\": [0, 0.2, 1]}, \"gray matter\": 5}"));
  EXPECT_EQ(table.at(1).name, "Knochen \xc3\xa4\"");
  ExpectEntry(table, -2, "b", 0, 255, 0);
  ExpectEntry(table, 3, "c", 0, 51, 255);
  ExpectEntry(table, 4, "d", 0, 51, 255);
  EXPECT_EQ(table.at(5).name, "gray matter");
  EXPECT_EQ(Read(this->Write("side.json", "{\"Manual\": true, \"LabelMap\": {\"1\": \"a\"}}")).at(1).name, "a");
  EXPECT_EQ(Read(this->Write("dataset.json", "{\"a\": [1, {}], \"labels\": {\"liver\": 1}}")).at(1).name, "liver");
}

TEST_F(LabelTableReader, PlainLines)
{
  const auto table = Read(this->Write("x.txt", "1 gray matter\n-2\tlayer 2\n3 a b 10 20 30\n"));
  EXPECT_EQ(table.at(1).name, "gray matter");
  EXPECT_EQ(table.at(-2).name, "layer 2");
  ExpectEntry(table, 3, "a b", 10, 20, 30);
}

TEST_F(LabelTableReader, SegmentsOfSlicer)
{
  const auto table = Read(this->Write("x.seg.nrrd",
                                      std::string(Header) +
                                        "Segment0_LabelValue:=4\nSegment0_Layer:=0\nSegment0_Name:=gray matter\n"
                                        "Segment0_Color:=0.2 0.4 1\n"
                                        "Segment1_LabelValue:=2\nSegment1_Layer:=0\nSegment1_Name:=skull\n\n12345678"));
  EXPECT_EQ(table.size(), 2u);
  ExpectEntry(table, 4, "gray matter", 51, 102, 255);
  EXPECT_EQ(table.at(2).name, "skull");
  EXPECT_FALSE(table.at(2).color);
}

TEST_F(LabelTableReader, WhatIsBrokenIsToldByItsLine)
{
  this->ExpectError("a.txt", "# x\n1 bone 1 2 3 4\nbone 2\n", "line 3 is not LABEL NAME");
  this->ExpectError("b.txt", "1 bone 256 2 3 4\n", "line 1 has a color that is not three whole numbers");
  this->ExpectError("c.txt", "1 bone\n1 skin\n", "line 2 names label 1 again, 'skin' after 'bone'");
  this->ExpectError("d.txt", "1 2 3 \"bone\"\n", "line 1 is not LABEL R G B A VISIBLE MESH \"NAME\"");
  this->ExpectError("a.tsv", "index\tabbreviation\n1\tGM\n", "line 1 has no column 'name'");
  this->ExpectError("b.tsv", "index\tname\n1\tGM\nx\tWM\n", "line 3 has no whole number in the column 'index'");
  this->ExpectError("c.tsv", "index\tname\tcolor\n1\tGM\tred\n", "line 2 has the color 'red'");
  this->ExpectError("a.json", "{\"1\": \"a\",\n\"2\": b}", "line 2 is not JSON: 'b' is no value");
  this->ExpectError("b.json", "{\"1\": \"a\"\n", "line 2 is not JSON: there is no ,");
  this->ExpectError("c.json", "{\n\"a\": \"b\"}", "line 2 has 'a', which is no label");
  this->ExpectError("d.json", "{\"1\": {\"color\": \"#000000\"}}", "line 1 has no name of label 1");
  this->ExpectError(
    "e.json", std::string(100000, '[').insert(0, "{\"1\":"), "line 1 is not JSON: it is nested too deeply");
  this->ExpectError("empty.txt", "# nothing\n", "the file names no label");
  this->ExpectError("binary.txt", std::string("1 a\0b", 5), "this is not a text");
  this->ExpectError("x.nrrd", std::string(Header) + "\n12345678", "the header lists no segments");
  EXPECT_NE(ErrorOf((m_Folder / "none.txt").string()).find("there is no such file"), std::string::npos);
  EXPECT_NE(ErrorOf(m_Folder.string()).find("this is a folder; a table of labels is needed"), std::string::npos);
}

TEST_F(LabelTableReader, IsFoundWhereBIDSPutsIt)
{
  const auto find = [&](const std::string & image) {
    return itk::LabelTableReader::FindFileFor((m_Folder / image).string());
  };
  const std::string image = "data/sub-1/anat/sub-1_space-T1w_dseg.nii.gz";
  const std::string text = "index\tname\n1\ta\n";
  this->Write("data/dataset_description.json", "{}");
  this->Write("dseg.tsv", text);
  this->Write(image, "");
  EXPECT_EQ(find(image), "") << "a table above the data set";
  const auto general = this->Write("data/dseg.tsv", text);
  EXPECT_EQ(find(image), general);
  this->Write("data/sub-1/anat/sub-2_dseg.tsv", text);
  this->Write("data/sub-1/anat/sub-1_desc-aseg_dseg.tsv", text);
  this->Write("data/sub-1/anat/sub-1_space-T1w_mask.tsv", text);
  this->Write("data/sub-1/anat/sub-1_space-T1w_dseg.json", "{\"Manual\": true}");
  EXPECT_EQ(find(image), general) << "tables of other images";
  const auto fewer = this->Write("data/sub-1/anat/sub-1_dseg.tsv", text);
  EXPECT_EQ(find(image), fewer);
  const auto sidecar = this->Write("data/sub-1/anat/sub-1_space-T1w_dseg.json", "{\"LabelMap\": {\"1\": \"a\"}}");
  EXPECT_EQ(find(image), sidecar);
  const auto own = this->Write("data/sub-1/anat/sub-1_space-T1w_dseg.tsv", text);
  EXPECT_EQ(find(image), own);
  EXPECT_EQ(find("data/sub-1/anat/sub-1_T1w.nii.gz"), "") << "an image of another kind";
}

TEST_F(LabelTableReader, IsFoundInTheImageOfSlicer)
{
  const auto with = this->Write(
    "x.seg.nrrd", std::string(Header) + "Segment0_LabelValue:=4\nSegment0_Layer:=0\nSegment0_Name:=a\n\n12345678");
  EXPECT_EQ(itk::LabelTableReader::FindFileFor(with), with);
  EXPECT_EQ(itk::LabelTableReader::FindFileFor(this->Write("x.nrrd", std::string(Header) + "\n12345678")), "");
}
