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
// What the program says of input that it cannot mesh, and what it takes.
#include "CommandLineTest.h"

#include "itkImageRegionIteratorWithIndex.h"
#include "itkVectorImage.h"

#include <fstream>

namespace
{
using FloatImage = itk::Image<float, 3>;

class CommandLineInput : public CommandLine
{
public:
  void
  ExpectInputError(const std::string & input, const std::string & message) const
  {
    this->ExpectError({ input, this->Path("out.vtu") }, 1, message);
  }

  void
  ExpectMeshed(const std::string & input) const
  {
    const auto result = Run({ input, this->Path("out.vtu"), "--quiet" });
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.error, "");
    EXPECT_TRUE(this->Files().count("out.vtu"));
  }

  /** Cuts the end off a file. */
  void
  Truncate(const std::string & fileName) const
  {
    std::filesystem::resize_file(fileName, std::filesystem::file_size(fileName) / 2);
  }

  template <typename TPixel>
  static typename itk::Image<TPixel, 3>::Pointer
  MakeBallsOf()
  {
    const auto balls = MakeBalls();
    auto       image = MakeImage<TPixel>(balls->GetBufferedRegion().GetSize());
    std::copy_n(balls->GetBufferPointer(), balls->GetBufferedRegion().GetNumberOfPixels(), image->GetBufferPointer());
    return image;
  }
};
} // namespace

TEST_F(CommandLineInput, MissingFile)
{
  this->ExpectInputError(this->Path("missing.nrrd"), "missing.nrrd: there is no such file");
}

TEST_F(CommandLineInput, Folder)
{
  this->ExpectInputError(std::filesystem::path(this->Path("x")).parent_path().string(), "this is a folder");
}

TEST_F(CommandLineInput, NoImage)
{
  for (const char * const name : { "text.txt", "text.nrrd", "text.nii", "text.nii.gz", "text.mha", "text.vtu" })
  {
    std::ofstream(this->Path(name)) << "Once upon a time there was no image.\n";
    this->ExpectInputError(this->Path(name), "not an image file");
  }
}

TEST_F(CommandLineInput, EmptyFile)
{
  const std::ofstream stream(this->Path("empty.nrrd"));
  this->ExpectInputError(this->Path("empty.nrrd"), "not an image file");
}

TEST_F(CommandLineInput, TruncatedFile)
{
  for (const char * const name : { "half.nrrd", "half.nii", "half.nii.gz", "half.mha" })
  {
    const auto file = this->WriteImage<LabelImage>(MakeBalls(), name);
    this->Truncate(file);
    this->ExpectInputError(file, std::string(name) + ": the image cannot be read, it may be damaged");
  }
}

TEST_F(CommandLineInput, DamagedCompressedFile)
{
  const auto   file = this->WriteImage<LabelImage>(MakeBalls(), "flip.nii.gz");
  std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
  // In the check sum, so that all else is as it was.
  stream.seekg(-6, std::ios::end);
  const char byte = char(stream.get() ^ 0x55);
  stream.seekp(-6, std::ios::end);
  stream.put(byte);
  stream.close();
  this->ExpectInputError(file, "it may be damaged: its compressed data is broken or incomplete");
}

TEST_F(CommandLineInput, TwoDimensions)
{
  const auto image = MakeImage<unsigned char>(itk::Size<2>{ { 8, 8 } });
  for (const char * const name : { "slice.png", "slice.nrrd", "slice.nii", "slice.mha" })
  {
    this->ExpectInputError(this->WriteImage<itk::Image<unsigned char, 2>>(image, name), "single slice (8x8");
  }
}

TEST_F(CommandLineInput, OneSlice)
{
  const auto image = MakeImage<unsigned char>(itk::Size<3>{ { 8, 8, 1 } });
  this->ExpectInputError(this->WriteImage<itk::Image<unsigned char, 3>>(image, "slice.nrrd"), "single slice (8x8x1)");
}

TEST_F(CommandLineInput, FourDimensions)
{
  const auto image = MakeImage<unsigned char>(itk::Size<4>{ { 4, 4, 4, 3 } });
  for (const char * const name : { "series.nrrd", "series.nii.gz", "series.mha" })
  {
    this->ExpectInputError(this->WriteImage<itk::Image<unsigned char, 4>>(image, name),
                           "more than three dimensions (4x4x4x3)");
  }
}

TEST_F(CommandLineInput, FourDimensionsWithOneVolumeAreMeshed)
{
  const auto balls = MakeBalls();
  const auto image = MakeImage<short>(itk::Size<4>{ { 16, 16, 16, 1 } });
  std::copy_n(balls->GetBufferPointer(), 16 * 16 * 16, image->GetBufferPointer());
  for (const char * const name : { "one.nrrd", "one.nii.gz", "one.mha" })
  {
    this->ExpectMeshed(this->WriteImage<itk::Image<short, 4>>(image, name));
  }
}

TEST_F(CommandLineInput, Vectors)
{
  using VectorImage = itk::VectorImage<unsigned char, 3>;
  auto image = VectorImage::New();
  image->SetRegions(itk::Size<3>{ { 4, 4, 4 } });
  image->SetVectorLength(3);
  image->Allocate(true);
  this->ExpectInputError(this->WriteImage<VectorImage>(image, "vectors.nrrd"), "3 components");
}

TEST_F(CommandLineInput, Fractions)
{
  const auto image = MakeBallsOf<float>();
  image->SetPixel({ { 3, 4, 5 } }, 0.37f);
  for (const char * const name : { "float.nrrd", "float.nii.gz" })
  {
    this->ExpectInputError(this->WriteImage<FloatImage>(image, name),
                           "voxel (3,4,5) has the value 0.37; a label image has integer values. Is this an intensity "
                           "or probability image?");
  }
}

TEST_F(CommandLineInput, NotANumber)
{
  const auto image = MakeBallsOf<float>();
  image->SetPixel({ { 1, 0, 0 } }, std::numeric_limits<float>::quiet_NaN());
  this->ExpectInputError(this->WriteImage<FloatImage>(image, "nan.nrrd"), "voxel (1,0,0) has the value nan");
}

TEST_F(CommandLineInput, WholeNumbersOfAnyTypeAreMeshed)
{
  this->ExpectMeshed(this->WriteImage<itk::Image<unsigned char, 3>>(MakeBallsOf<unsigned char>(), "uchar.nii.gz"));
  this->ExpectMeshed(this->WriteImage<itk::Image<unsigned int, 3>>(MakeBallsOf<unsigned int>(), "uint.mha"));
  this->ExpectMeshed(this->WriteImage<FloatImage>(MakeBallsOf<float>(), "float.nrrd"));
  this->ExpectMeshed(this->WriteImage<itk::Image<double, 3>>(MakeBallsOf<double>(), "double.nii"));
}

TEST_F(CommandLineInput, LabelBeyondInt)
{
  const auto image = MakeBallsOf<unsigned int>();
  image->SetPixel({ { 0, 0, 2 } }, 4000000000u);
  this->ExpectInputError(this->WriteImage<itk::Image<unsigned int, 3>>(image, "large.nrrd"),
                         "voxel (0,0,2) has the value 4000000000; labels have to be from");
}

TEST_F(CommandLineInput, Intensities)
{
  const auto image = MakeImage<short>(itk::Size<3>{ { 16, 16, 16 } });
  for (itk::ImageRegionIteratorWithIndex<LabelImage> it(image, image->GetBufferedRegion()); !it.IsAtEnd(); ++it)
  {
    it.Set(short(7 * it.GetIndex()[0] + it.GetIndex()[1] * it.GetIndex()[2]));
  }
  this->ExpectInputError(this->WriteImage<LabelImage>(image, "t1.nrrd"), "looks like an intensity image; segment it");
}

TEST_F(CommandLineInput, OneValue)
{
  const auto image = MakeImage<short>(itk::Size<3>{ { 4, 4, 4 } });
  image->FillBuffer(3);
  this->ExpectInputError(this->WriteImage<LabelImage>(image, "one.nrrd"), "one.nrrd: all voxels have the value 3");
}

TEST_F(CommandLineInput, NothingButExterior)
{
  this->ExpectError({ this->WriteBalls(), this->Path("out.vtu"), "--exterior", "0,2,5" }, 1, "xterior");
}

TEST_F(CommandLineInput, SizingImageOnAnotherGrid)
{
  const auto image = MakeImage<float>(itk::Size<3>{ { 4, 4, 4 } });
  image->FillBuffer(1.0f);
  const auto sizing = this->WriteImage<FloatImage>(image, "size.nrrd");
  this->ExpectError({ this->WriteBalls(), this->Path("out.vtu"), "--sizing-image", sizing }, 1, "izing");
}

TEST_F(CommandLineInput, SizingImageNotPositive)
{
  const auto image = MakeImage<float>(itk::Size<3>{ { 16, 16, 16 } });
  const auto sizing = this->WriteImage<FloatImage>(image, "size.nrrd");
  this->ExpectError({ this->WriteBalls(), this->Path("out.vtu"), "--sizing-image", sizing }, 1, "ositive");
}
