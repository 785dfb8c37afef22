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
// What is read of label images, where they are put, and what is refused.
#include "itkVolumeFileReader.h"
#include "support/TestLabelImages.h"
#include "support/TestNifti.h"

#include "itkImageFileReader.h" // registers ITK's formats
#include "itkImageFileWriter.h"
#include "itkMacro.h"
#include "itkOutputWindow.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace
{
/** Keeps warnings. */
class Warnings : public itk::OutputWindow
{
public:
  using Self = Warnings;
  using Pointer = itk::SmartPointer<Self>;
  itkFactorylessNewMacro(Self);

  void
  DisplayText(const char * newText) override
  {
    text += newText;
  }

  std::string text;
};

class VolumeFileReader : public testing::Test
{
public:
  VolumeFileReader()
    : m_Folder(std::filesystem::temp_directory_path() /
               ("volume-" + std::to_string(
                              std::hash<std::string>()(testing::UnitTest::GetInstance()->current_test_info()->name()))))
  {
    std::filesystem::create_directories(m_Folder);
    itk::OutputWindow::SetInstance(m_Warnings);
  }

  ~VolumeFileReader() override
  {
    itk::OutputWindow::SetInstance(nullptr);
    std::filesystem::remove_all(m_Folder);
  }

  std::string
  Path(const std::string & name) const
  {
    return (m_Folder / name).string();
  }

  std::string
  Write(const TestNifti & nifti, const std::string & name = "x.nii") const
  {
    nifti.Write(this->Path(name));
    return this->Path(name);
  }

  std::string
  WriteText(const std::string & name, const std::string & text) const
  {
    std::ofstream(this->Path(name), std::ios::binary) << text;
    return this->Path(name);
  }

  itk::Image<int, 3>::Pointer
  Read(const std::string & fileName)
  {
    m_Warnings->text.clear();
    const auto reader = itk::VolumeFileReader::New();
    reader->SetFileName(fileName);
    return reader->ReadLabels();
  }

  /** The place of the voxel of label 7, which must be the only one. */
  itk::Point<double, 3>
  PlaceOfLabel(const std::string & fileName)
  {
    const auto            image = this->Read(fileName);
    itk::Point<double, 3> place;
    place.Fill(1e9);
    const int * const labels = image->GetBufferPointer();
    const auto        count = image->GetBufferedRegion().GetNumberOfPixels();
    EXPECT_EQ(std::count(labels, labels + count, 7), 1);
    EXPECT_EQ(std::count(labels, labels + count, 0), std::ptrdiff_t(count) - 1);
    image->TransformIndexToPhysicalPoint(image->ComputeIndex(std::find(labels, labels + count, 7) - labels), place);
    return place;
  }

  void
  ExpectPlace(const std::string & fileName, double x, double y, double z)
  {
    const auto   place = this->PlaceOfLabel(fileName);
    const double right[] = { x, y, z };
    EXPECT_LT(place.EuclideanDistanceTo(itk::Point<double, 3>(right)), 1e-4) << place;
  }

  void
  ExpectError(const std::string & fileName, const std::vector<std::string> & words)
  {
    try
    {
      this->Read(fileName);
      ADD_FAILURE() << "It was read.";
    }
    catch (const itk::ExceptionObject & exception)
    {
      const std::string text = exception.GetDescription();
      EXPECT_NE(text.find(fileName), std::string::npos) << text;
      EXPECT_EQ(text.find('\n'), std::string::npos) << text;
      for (const std::string & word : words)
      {
        EXPECT_NE(text.find(word), std::string::npos) << word << " is not in: " << text;
      }
    }
  }

  void
  ExpectNoWarning() const
  {
    EXPECT_EQ(m_Warnings->text, "");
  }

  void
  ExpectWarning(const std::string & words) const
  {
    EXPECT_NE(m_Warnings->text.find(words), std::string::npos) << m_Warnings->text;
  }

private:
  std::filesystem::path m_Folder;
  Warnings::Pointer     m_Warnings{ Warnings::New() };
};

std::string
Nrrd(const std::string & fields, const std::string & type = "unsigned char")
{
  std::string voxels(6 * 5 * 4, '\0');
  voxels[(1 * 5 + 2) * 6 + 4] = 7;
  return "NRRD0004\ntype: " + type + "\ndimension: 3\nsizes: 6 5 4\nencoding: raw\n" + fields + "\n\n" + voxels;
}
} // namespace

TEST_F(VolumeFileReader, NiftiIsPutByItsSform)
{
  // in RAS 10 - 4, 20 - 2 * 2, 30 + 3
  this->ExpectPlace(this->Write({}), -6, -16, 33);
  this->ExpectNoWarning();
  this->ExpectPlace(this->Write({}, "x.nii.gz"), -6, -16, 33);
  this->ExpectPlace(this->Write({}, "X.NII"), -6, -16, 33);
}

TEST_F(VolumeFileReader, SformIsTakenBeforeAnotherQformWithAWarning)
{
  TestNifti nifti;
  nifti.SetQform({ 0, 0, 0 }, { 1, 2, 3 });
  this->ExpectPlace(this->Write(nifti), -6, -16, 33);
  this->ExpectWarning("its sform and qform differ, by up to ");
}

TEST_F(VolumeFileReader, EqualFormsAreNotWorthAWarning)
{
  TestNifti nifti;
  // half a turn about z
  nifti.SetQform({ 0, 0, 1 }, { 10, 20, 30 });
  this->ExpectPlace(this->Write(nifti), -6, -16, 33);
  this->ExpectNoWarning();
}

TEST_F(VolumeFileReader, QformAloneIsTaken)
{
  TestNifti nifti;
  nifti.RemoveSform();
  // a quarter of a turn about z: x goes to y, y to -x
  nifti.SetQform({ 0, 0, std::sqrt(0.5f) }, { 1, 2, 3 });
  this->ExpectPlace(this->Write(nifti), -(1 - 4), -(2 + 4), 3 + 3);
  this->ExpectNoWarning();
  // the other handedness
  nifti.Set<float>(76, -1);
  this->ExpectPlace(this->Write(nifti), -(1 - 4), -(2 + 4), 3 - 3);
}

TEST_F(VolumeFileReader, SformWithoutSenseLeavesItToTheQform)
{
  TestNifti nifti;
  nifti.SetSform({ 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0 });
  nifti.SetQform({ 0, 0, 1 }, { 10, 20, 30 });
  this->ExpectPlace(this->Write(nifti), -6, -16, 33);
  this->ExpectWarning("its sform is of no use, as the spacing along its second axis is 0");
}

TEST_F(VolumeFileReader, SpacingAloneIsTakenWithAWarning)
{
  TestNifti nifti;
  nifti.RemoveSform();
  this->ExpectPlace(this->Write(nifti), -4, -4, 3);
  this->ExpectWarning("does not say where it lies");
}

TEST_F(VolumeFileReader, SpacingOfNothingIsRefused)
{
  TestNifti nifti;
  nifti.RemoveSform();
  nifti.Set<float>(76 + 12, 0);
  this->ExpectError(this->Write(nifti), { "in its pixdim, the spacing along its third axis is 0" });
  nifti.Set<float>(76 + 12, std::nanf(""));
  this->ExpectError(this->Write(nifti), { "in its pixdim, the spacing along its third axis is no number" });
  nifti.SetQform({ 0, 0, 0 }, { 0, 0, 0 });
  this->ExpectError(this->Write(nifti), { "in its qform and pixdim, the spacing along its third axis" });
  nifti.SetSform({ 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0 });
  this->ExpectError(this->Write(nifti), { "in its sform, the spacing along its third axis is 0" });
}

TEST_F(VolumeFileReader, SpacingIsThatOfTheSform)
{
  TestNifti nifti;
  nifti.SetFloats(76, { 0, 0, 0, 0 });
  this->ExpectPlace(this->Write(nifti), -6, -16, 33);
  this->ExpectNoWarning();
}

TEST_F(VolumeFileReader, NegativeSpacingIsTakenForItsSizeWithAWarning)
{
  TestNifti nifti;
  nifti.RemoveSform();
  nifti.Set<float>(80, -1);
  nifti.SetQform({ 0, 0, 0 }, { 0, 0, 0 });
  this->ExpectPlace(this->Write(nifti), -4, -4, 3);
  this->ExpectWarning("a spacing is negative");
}

TEST_F(VolumeFileReader, OffsetsThatAreNoNumbersAreRefused)
{
  TestNifti nifti;
  nifti.RemoveSform();
  nifti.SetQform({ 0, 0, 0 }, { 0, std::nanf(""), 0 });
  this->ExpectError(this->Write(nifti), { "its origin is no number" });
  for (const float offset : { std::nanf(""), -352.0f, 100.0f })
  {
    TestNifti other;
    other.Set<float>(108, offset);
    this->ExpectError(this->Write(other), { "vox_offset" });
  }
}

TEST_F(VolumeFileReader, LengthsAreInMillimeters)
{
  TestNifti nifti;
  nifti.Set<char>(123, 3);
  this->ExpectPlace(this->Write(nifti), -0.006, -0.016, 0.033);
  this->ExpectWarning("its unit is the micrometer");
  nifti.Set<char>(123, 1 | 8);
  this->ExpectPlace(this->Write(nifti), -6000, -16000, 33000);
  this->ExpectWarning("its unit is the meter");
}

TEST_F(VolumeFileReader, ShearedAxesStayAsTheyAreWithAWarning)
{
  TestNifti nifti;
  nifti.SetSform({ 1, 1, 0, 0, 0, 2, 0, 0, 0, 0, 3, 0 });
  this->ExpectPlace(this->Write(nifti), -(4 + 2), -4, 3);
  this->ExpectWarning("its axes are not at right angles (63.4 degrees)");
  nifti.SetSform({ 1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 3, 0 });
  this->ExpectError(this->Write(nifti), { "its first and second axes have nearly the same direction" });
}

TEST_F(VolumeFileReader, ScaledDirectionsBecomeSpacing)
{
  const auto file = this->WriteText("x.mha",
                                    "ObjectType = Image\nNDims = 3\nDimSize = 6 5 4\nElementType = MET_UCHAR\n"
                                    "TransformMatrix = 2 0 0 0 2 0 0 0 2\nOffset = 1 2 3\nElementSpacing = 1 2 3\n"
                                    "ElementDataFile = LOCAL\n" +
                                      std::string(6 * 5 * 4, '\7'));
  const auto image = this->Read(file);
  EXPECT_EQ(image->GetSpacing()[0], 2.0);
  EXPECT_EQ(image->GetSpacing()[2], 6.0);
  EXPECT_EQ(image->GetDirection()[1][1], 1.0);
}

TEST_F(VolumeFileReader, NrrdIsPutByItsSpace)
{
  const std::string place = "space directions: (1,0,0) (0,2,0) (0,0,3)\nspace origin: (10,20,30)";
  this->ExpectPlace(this->WriteText("lps.nrrd", Nrrd("space: left-posterior-superior\n" + place)), 14, 24, 33);
  this->ExpectPlace(this->WriteText("ras.nrrd", Nrrd("space: right-anterior-superior\n" + place)), -14, -24, 33);
  this->ExpectPlace(this->WriteText("las.nrrd", Nrrd("space: left-anterior-superior\n" + place)), 14, -24, 33);
  this->ExpectPlace(this->WriteText("abbreviated.nrrd", Nrrd("space: LAS\n" + place)), 14, -24, 33);
  this->ExpectPlace(this->WriteText("none.nrrd", Nrrd("space dimension: 3\n" + place)), 14, 24, 33);
  this->ExpectNoWarning();
  const std::string units = "\nspace units: \"um\" \"um\" \"um\"";
  this->ExpectPlace(this->WriteText("um.nrrd", Nrrd("space: LPS\n" + place + units)), 0.014, 0.024, 0.033);
  this->ExpectWarning("its unit is um");
}

TEST_F(VolumeFileReader, LayersOfSegmentsAreMadeOneImage)
{
  std::string layers(2 * 6 * 5 * 4, '\0');
  layers[0] = 1;
  layers[1] = 1;
  layers[2] = 1;
  layers[5] = 1;
  const auto write = [&](const std::string & name) {
    return this->WriteText(name,
                           "NRRD0005\ntype: unsigned char\ndimension: 4\nspace: left-posterior-superior\nsizes: 2 6 5 "
                           "4\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\nkinds: list domain domain domain\n"
                           "encoding: raw\nspace origin: (0,0,0)\n"
                           "Segment0_LabelValue:=1\nSegment0_Layer:=0\nSegment0_Name:=skull\n"
                           "Segment1_LabelValue:=1\nSegment1_Layer:=1\nSegment1_Name:=tumor\n\n" +
                             layers);
  };
  const auto labels = this->Read(write("x.seg.nrrd"));
  EXPECT_EQ(labels->GetPixel({ { 0, 0, 0 } }), 2);
  EXPECT_EQ(labels->GetPixel({ { 1, 0, 0 } }), 1);
  EXPECT_EQ(labels->GetPixel({ { 2, 0, 0 } }), 2);
  EXPECT_EQ(labels->GetPixel({ { 3, 0, 0 } }), 0);
  this->ExpectWarning("its 2 layers of segments are made one image, where later ones cover others: 1 skull, 2 tumor");
}

TEST_F(VolumeFileReader, ScaledLabelsAreRounded)
{
  TestNifti nifti;
  // as programs store real numbers from 0 to 7
  nifti.SetVoxels<std::int16_t>(4, 32767, -32768);
  nifti.SetFloats(112, { 7.0f / 65535.0f, 7.0f * 32768.0f / 65535.0f });
  this->ExpectPlace(this->Write(nifti), -6, -16, 33);
  nifti.SetVoxels<std::int16_t>(4, 32767, -30000);
  this->ExpectError(this->Write(nifti), { "voxel (0,0,0) has the value 0.295", "Is this an intensity" });
}

TEST_F(VolumeFileReader, RealNumbersAreRoundedIfTheyAreNearlyWhole)
{
  TestNifti nifti;
  nifti.SetVoxels<float>(16, 7.00005f, -0.00005f);
  this->ExpectPlace(this->Write(nifti), -6, -16, 33);
  nifti.SetVoxels<double>(64, 6.9995, 0.0);
  this->ExpectPlace(this->Write(nifti), -6, -16, 33);
  nifti.SetVoxels<float>(16, 7.002f, 0.0f);
  this->ExpectError(this->Write(nifti), { "voxel (4,2,1) has the value 7.002" });
  nifti.SetVoxels<float>(16, std::nanf(""), 0.0f);
  this->ExpectError(this->Write(nifti), { "voxel (4,2,1) has the value nan" });
}

TEST_F(VolumeFileReader, LabelsOfAllIntegerTypesAreRead)
{
  TestNifti nifti;
  nifti.SetVoxels<std::uint8_t>(2, 7, 0);
  this->ExpectPlace(this->Write(nifti), -6, -16, 33);
  nifti.SetVoxels<std::int8_t>(256, 7, 0);
  this->ExpectPlace(this->Write(nifti), -6, -16, 33);
  nifti.SetVoxels<std::uint16_t>(512, 7, 0);
  this->ExpectPlace(this->Write(nifti), -6, -16, 33);
  nifti.SetVoxels<std::int32_t>(8, 7, 0);
  this->ExpectPlace(this->Write(nifti), -6, -16, 33);
  nifti.SetVoxels<std::uint32_t>(768, 7, 0);
  this->ExpectPlace(this->Write(nifti), -6, -16, 33);
  nifti.SetVoxels<std::int64_t>(1024, 7, 0);
  this->ExpectPlace(this->Write(nifti), -6, -16, 33);
}

TEST_F(VolumeFileReader, LabelsBeyondTheRangeAreRefusedWithAllTheirDigits)
{
  TestNifti nifti;
  nifti.SetVoxels<std::uint64_t>(1280, 18446744073709551609u, 0);
  this->ExpectError(this->Write(nifti), { "18446744073709551609", "labels have to be from -2147483648 to 2147483647" });
  nifti.SetVoxels<std::uint32_t>(768, 4000000000u, 0);
  this->ExpectError(this->Write(nifti), { "4000000000", "labels have to be" });
  std::string nrrd = Nrrd("endian: little", "uint64");
  nrrd.resize(nrrd.size() - 6 * 5 * 4);
  nrrd.resize(nrrd.size() + 8 * 6 * 5 * 4, '\0');
  nrrd.replace(nrrd.size() - 8, 8, "\xF9\xFF\xFF\xFF\xFF\xFF\xFF\xFF");
  this->ExpectError(this->WriteText("u64.nrrd", nrrd), { "18446744073709551609" });
}

TEST_F(VolumeFileReader, OtherVoxelsAreRefusedByWhatTheyAre)
{
  TestNifti nifti;
  nifti.Set<std::int16_t>(70, 128);
  this->ExpectError(this->Write(nifti), { "the voxels are colors" });
  nifti.Set<std::int16_t>(70, 32);
  this->ExpectError(this->Write(nifti), { "the voxels are complex numbers" });
}

TEST_F(VolumeFileReader, OtherByteOrderIsRead)
{
  TestNifti  nifti;
  const auto turn = [&](std::size_t offset, std::size_t size, std::size_t count) {
    for (std::size_t n = 0; n < count; ++n)
    {
      std::reverse(nifti.bytes.begin() + std::ptrdiff_t(offset + n * size),
                   nifti.bytes.begin() + std::ptrdiff_t(offset + (n + 1) * size));
    }
  };
  turn(0, 4, 1);
  turn(40, 2, 8);
  turn(70, 2, 2);
  turn(76, 4, 8);
  turn(108, 4, 3);
  turn(252, 2, 2);
  turn(280, 4, 12);
  turn(352, 2, 6 * 5 * 4);
  this->ExpectPlace(this->Write(nifti), -6, -16, 33);
}

TEST_F(VolumeFileReader, PairOfFilesIsRead)
{
  TestNifti nifti;
  std::copy_n("ni1", 4, nifti.bytes.begin() + 344);
  nifti.Set<float>(108, 0);
  TestNifti voxels = nifti;
  voxels.bytes.erase(voxels.bytes.begin(), voxels.bytes.begin() + 352);
  nifti.bytes.resize(352);
  const auto header = this->Write(nifti, "x.hdr");
  this->ExpectError(header, { "the file with the voxels, .img, is not beside it" });
  const auto image = this->Write(voxels, "x.img");
  this->ExpectPlace(header, -6, -16, 33);
  this->ExpectPlace(image, -6, -16, 33);
}

TEST_F(VolumeFileReader, SecondVersionOfNiftiIsRead)
{
  TestNifti  nifti;
  const auto voxels = std::vector<char>(nifti.bytes.begin() + 352, nifti.bytes.end());
  nifti.bytes.assign(544, 0);
  nifti.Set<std::int32_t>(0, 540);
  std::copy_n("n+2\0\r\n\032\n", 8, nifti.bytes.begin() + 4);
  nifti.Set<std::int16_t>(12, 4);
  nifti.Set<std::int16_t>(14, 16);
  const std::int64_t dim[4] = { 3, 6, 5, 4 };
  const double       sform[12] = { -1, 0, 0, 10, 0, -2, 0, 20, 0, 0, 3, 30 };
  for (std::size_t n = 0; n < 4; ++n)
  {
    nifti.Set<std::int64_t>(16 + 8 * n, dim[n]);
  }
  nifti.Set<std::int64_t>(168, 544);
  nifti.Set<std::int32_t>(348, 1);
  for (std::size_t n = 0; n < 12; ++n)
  {
    nifti.Set<double>(400 + 8 * n, sform[n]);
  }
  nifti.bytes.insert(nifti.bytes.end(), voxels.begin(), voxels.end());
  this->ExpectPlace(this->Write(nifti), -6, -16, 33);
  this->ExpectPlace(this->Write(nifti, "x.nii.gz"), -6, -16, 33);
}

TEST_F(VolumeFileReader, FreeSurferIsRead)
{
  std::string bytes(284, '\0');
  const auto  set = [&](std::size_t offset, auto value) {
    std::memcpy(&bytes[offset], &value, sizeof value);
    std::reverse(bytes.begin() + std::ptrdiff_t(offset), bytes.begin() + std::ptrdiff_t(offset + sizeof value));
  };
  const std::int32_t integers[6] = { 1, 6, 5, 4, 1, 0 };
  for (std::size_t n = 0; n < 6; ++n)
  {
    set(4 * n, integers[n]);
  }
  set(28, std::int16_t{ 1 });
  // 1, 2 and 3 mm, axes to -x, -y and z, the center
  const float numbers[15] = { 1, 2, 3, -1, 0, 0, 0, -1, 0, 0, 0, 1, 7, 15, 36 };
  for (std::size_t n = 0; n < 15; ++n)
  {
    set(30 + 4 * n, numbers[n]);
  }
  std::string voxels(6 * 5 * 4, '\0');
  voxels[(1 * 5 + 2) * 6 + 4] = 7;
  this->ExpectPlace(this->WriteText("x.mgh", bytes + voxels), -6, -16, 33);
  const auto   name = this->Path("x.mgz");
  const gzFile file = gzopen(name.c_str(), "wb");
  gzwrite(file, (bytes + voxels).data(), unsigned(bytes.size() + voxels.size()));
  gzclose(file);
  this->ExpectPlace(name, -6, -16, 33);
}

TEST_F(VolumeFileReader, HeaderThatLiesIsFoundOutBeforeMemoryIsTaken)
{
  TestNifti nifti;
  for (int d = 1; d < 4; ++d)
  {
    nifti.Set<std::int16_t>(40 + 2 * d, 30000);
  }
  this->ExpectError(this->Write(nifti), { "it may be damaged", "header" });
}

TEST_F(VolumeFileReader, MetaImagesWithoutAllOfTheirDataAreRefused)
{
  const auto image = mmmtest::MakeBall<itk::Image<short, 3>>(16, 5.0);
  for (const bool isCompressed : { false, true })
  {
    for (const char * const name : { "x.mha", "x.mhd" })
    {
      itk::WriteImage(image, this->Path(name), isCompressed);
      EXPECT_EQ(this->Read(this->Path(name))->GetBufferedRegion().GetNumberOfPixels(), 4096u);
      const auto data = this->Path(std::string(name) == "x.mha" ? "x.mha" : isCompressed ? "x.zraw" : "x.raw");
      std::filesystem::resize_file(data, std::filesystem::file_size(data) - 9);
      mmmtest::ExpectException([&] { this->Read(this->Path(name)); }, "its data is broken or incomplete");
    }
  }
}

TEST_F(VolumeFileReader, MetaImagesWithoutTheFileOfTheirDataAreRefused)
{
  for (const std::string name : { "x.raw", ".", "" })
  {
    const auto file = this->WriteText("x.mhd",
                                      "ObjectType = Image\nNDims = 3\nDimSize = 4 4 4\nElementType = MET_SHORT\n"
                                      "ElementDataFile = " +
                                        name + "\n");
    mmmtest::ExpectException([&] { this->Read(file); }, "there is no file '" + name + "' with its data");
  }
}

TEST_F(VolumeFileReader, MetaImagesOfSenselessDimensionsAreRefused)
{
  for (const std::string dimensions : { "1152921504606846976", "-3", "0", "x" })
  {
    const auto file = this->WriteText("x.mha",
                                      "ObjectType = Image\nNDims = " + dimensions +
                                        "\nDimSize = 4 4 4\nElementType = MET_SHORT\nElementDataFile = LOCAL\n");
    mmmtest::ExpectException([&] { this->Read(file); }, "its header says that it has " + dimensions + " dimensions");
  }
}

TEST_F(VolumeFileReader, VoxelsOfAnUnknownTypeAreRefused)
{
  const auto file = this->WriteText("x.mha",
                                    "ObjectType = Image\nNDims = 3\nDimSize = 4 4 4\nElementType = MET_SHRT\n"
                                    "ElementDataFile = LOCAL\n" +
                                      std::string(128, '\0'));
  mmmtest::ExpectException([&] { this->Read(file); }, "its header says of no known type what the voxels are");
}

TEST_F(VolumeFileReader, DicomIsToldByTheCommandThatConvertsIt)
{
  this->ExpectError(this->WriteText("seg.dcm", std::string(128, '\0') + "DICM" + std::string(500, '\0')),
                    { "this is a DICOM file", "segimage2itkimage", "dcm2niix" });
}
