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
// What users add to the sizes, in the two filters that take it.
#include "itkIndicatorImagesToSizingImageFilter.h"
#include "itkLabelImageToIndicatorImagesFilter.h"
#include "itkLabelImageToTetrahedralMeshFilter.h"
#include "support/TestLabelImages.h"
#include "support/TestMeshes.h"

#include "itkImageRegionConstIteratorWithIndex.h"

#include <cmath>
#include <functional>
#include <limits>

namespace
{
using LabelImage = itk::Image<unsigned char, 3>;
using FloatImage = itk::Image<float, 3>;
using MaskImage = itk::Image<unsigned char, 3>;
using SizingFilter = itk::IndicatorImagesToSizingImageFilter<FloatImage>;
using MeshFilter = itk::LabelImageToTetrahedralMeshFilter<LabelImage>;

constexpr float Infinity = std::numeric_limits<float>::infinity();

/** Three slabs of 10 voxels, of the labels 2, 3 and 5, in a box of 30 x 12 x 12 voxels. */
int
LabelOfSlab(int i, int, int)
{
  return i < 10 ? 2 : (i < 20 ? 3 : 5);
}

/** The sizing filter on the slabs, with nothing exterior and 1.5 mm asked for throughout. */
SizingFilter::Pointer
MakeSlabFilter()
{
  const auto indicators = itk::LabelImageToIndicatorImagesFilter<LabelImage>::New();
  indicators->SetInput(mmmtest::MakeImage<LabelImage>(30, 12, 12, LabelOfSlab));
  indicators->Update();
  const auto filter = SizingFilter::New();
  for (unsigned int n = 0; n < 3; ++n)
  {
    const FloatImage::Pointer image = indicators->GetOutputForLabel(indicators->GetLabels()[n]);
    image->DisconnectPipeline();
    filter->SetInput(n, image);
  }
  filter->SetLabels({ 2, 3, 5 });
  filter->SetMinimumSize(1.5);
  filter->SetMaximumSize(1.5);
  return filter;
}

FloatImage::Pointer
MakeSizes(const std::function<float(int, int, int)> & size)
{
  return mmmtest::MakeImage<FloatImage>(30, 12, 12, size);
}

MaskImage::Pointer
MakeMask(const std::function<bool(int, int, int)> & isIn)
{
  return mmmtest::MakeImage<MaskImage>(30, 12, 12, isIn);
}

/** The computed size along the middle of the slabs. */
float
SizeAt(SizingFilter * filter, int i)
{
  filter->Update();
  return filter->GetOutput()->GetPixel({ { i, 6, 6 } });
}

void
ExpectLimitedGradient(const FloatImage * sizes, double limit)
{
  const auto region = sizes->GetBufferedRegion();
  for (itk::ImageRegionConstIteratorWithIndex<FloatImage> it(sizes, region); !it.IsAtEnd(); ++it)
  {
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      auto after = it.GetIndex();
      ++after[axis];
      if (region.IsInside(after))
      {
        ASSERT_LE(std::abs(it.Get() - sizes->GetPixel(after)), limit + 1e-3) << it.GetIndex();
      }
    }
  }
}

MeshFilter::Pointer
MakeMeshFilter(const LabelImage * labels)
{
  const auto filter = MeshFilter::New();
  filter->SetInput(labels);
  return filter;
}

std::size_t
CountTetrahedra(MeshFilter * filter, int label)
{
  filter->Update();
  const auto labels = mmmtest::CellDataOf(filter->GetOutput());
  return static_cast<std::size_t>(std::count(labels.begin(), labels.end(), label));
}
} // namespace

TEST(SizingControl, ImageThatReplacesDecidesBothWays)
{
  const auto filter = MakeSlabFilter();
  filter->SetMinimumSize(0.5);
  filter->SetMaximumSize(20.0);
  filter->SetSizingImage(MakeSizes([](int, int, int) { return 15.0f; }));
  EXPECT_LT(SizeAt(filter, 0), 14.0f) << "epsilon times half of the slab";
  filter->SizingImageReplacesOn();
  for (const int i : { 0, 9, 15, 29 })
  {
    EXPECT_FLOAT_EQ(SizeAt(filter, i), 15.0f) << i;
  }
}

TEST(SizingControl, ImageThatReplacesIsClampedAndItsGradientLimited)
{
  const auto filter = MakeSlabFilter();
  filter->SetMinimumSize(1.0);
  filter->SetMaximumSize(6.0);
  filter->SetGradientLimit(0.4);
  filter->SetSizingImage(MakeSizes([](int i, int, int) { return i < 15 ? 0.1f : 50.0f; }));
  filter->SizingImageReplacesOn();
  EXPECT_FLOAT_EQ(SizeAt(filter, 3), 1.0f);
  EXPECT_NEAR(SizeAt(filter, 18), 1.0f + 4 * 0.4f, 1e-3f);
  EXPECT_FLOAT_EQ(SizeAt(filter, 29), 6.0f);
  ExpectLimitedGradient(filter->GetOutput(), 0.4);
}

TEST(SizingControl, ImageThatReplacesLeavesTheRestToUs)
{
  const auto computed = MakeSlabFilter();
  computed->SetMaximumSize(20.0);
  const float expected = SizeAt(computed, 29);
  const auto  filter = MakeSlabFilter();
  filter->SetMaximumSize(20.0);
  filter->SetSizingImage(MakeSizes([](int i, int, int) { return i < 8 ? 5.0f : Infinity; }));
  filter->SizingImageReplacesOn();
  EXPECT_FLOAT_EQ(SizeAt(filter, 29), expected);
}

TEST(SizingControl, FactorOfALabelHoldsAtItsInterfaces)
{
  for (const double factor : { 0.5, 2.0 })
  {
    const auto plain = MakeSlabFilter();
    plain->SetMinimumSize(0.1);
    plain->SetMaximumSize(100.0);
    plain->SetGradientLimit(2.0);
    const auto filter = MakeSlabFilter();
    filter->SetMinimumSize(0.1);
    filter->SetMaximumSize(100.0);
    filter->SetGradientLimit(2.0);
    filter->SetLabelSizes(std::map<int, mmm::SizeRule>{ { 5, { factor } } });
    EXPECT_NEAR(SizeAt(filter, 29), factor * SizeAt(plain, 29), 0.25 * factor * SizeAt(plain, 29));
    EXPECT_FLOAT_EQ(SizeAt(filter, 0), SizeAt(plain, 0));
  }
}

TEST(SizingControl, BoundsOfALabelStandInPlaceOfTheGeneralOnes)
{
  const auto filter = MakeSlabFilter();
  filter->SetGradientLimit(0.2);
  filter->SetLabelSizes("3:max=0.5");
  for (const int i : { 10, 15, 19 })
  {
    EXPECT_FLOAT_EQ(SizeAt(filter, i), 0.5f) << i;
  }
  EXPECT_NEAR(SizeAt(filter, 22), 0.5f + 3 * 0.2f, 0.2f) << "sizes fade out of the label";
  EXPECT_FLOAT_EQ(SizeAt(filter, 0), 1.5f);
  ExpectLimitedGradient(filter->GetOutput(), 0.2);

  filter->SetGradientLimit(1.0);
  filter->SetLabelSizes("5:min=4");
  EXPECT_FLOAT_EQ(SizeAt(filter, 29), 4.0f);
  EXPECT_FLOAT_EQ(SizeAt(filter, 5), 1.5f);
}

TEST(SizingControl, SmallerSizeHoldsBetweenTwoLabelsWithSizes)
{
  const auto filter = MakeSlabFilter();
  filter->SetLabelSizes("3:max=1:min=1,5:max=0.6:min=0.6");
  EXPECT_NEAR(SizeAt(filter, 19), 0.6f + 0.25f, 0.1f);
  EXPECT_FLOAT_EQ(SizeAt(filter, 20), 0.6f);
}

TEST(SizingControl, WithoutLabelsInputsAreNumbered)
{
  const auto filter = MakeSlabFilter();
  filter->SetLabels({});
  filter->SetLabelSizes("1:max=0.5");
  EXPECT_FLOAT_EQ(SizeAt(filter, 15), 0.5f);
  EXPECT_FLOAT_EQ(SizeAt(filter, 0), 1.5f);
}

TEST(SizingControl, RegionHasItsOwnBoundsAndFadesOut)
{
  const auto filter = MakeSlabFilter();
  filter->SetGradientLimit(0.2);
  filter->SetRegionOfInterest(MakeMask([](int i, int, int) { return i >= 12 && i < 16; }));
  filter->SetRegionMaximumSize(0.5);
  for (const int i : { 12, 15 })
  {
    EXPECT_FLOAT_EQ(SizeAt(filter, i), 0.5f) << i;
  }
  EXPECT_NEAR(SizeAt(filter, 17), 0.9f, 1e-3f);
  EXPECT_FLOAT_EQ(SizeAt(filter, 29), 1.5f);
  ExpectLimitedGradient(filter->GetOutput(), 0.2);
}

TEST(SizingControl, RegionGoesBeforeLabels)
{
  const auto filter = MakeSlabFilter();
  filter->SetGradientLimit(2.0);
  filter->SetLabelSizes("3:max=0.5");
  filter->SetRegionOfInterest(MakeMask([](int i, int, int) { return i >= 5 && i < 25; }));
  filter->SetRegionMinimumSize(1.0);
  filter->SetRegionMaximumSize(1.0);
  EXPECT_FLOAT_EQ(SizeAt(filter, 15), 1.0f);
}

TEST(SizingControl, LargestVolumeBoundsAllSizes)
{
  const auto filter = MakeSlabFilter();
  filter->SetMinimumSize(SizingFilter::Automatic);
  filter->SetMaximumVolume(0.05);
  filter->SetLabelSizes("3:min=3");
  EXPECT_LT(SizeAt(filter, 0), 0.6f);
  EXPECT_FLOAT_EQ(SizeAt(filter, 15), SizeAt(filter, 0));
}

TEST(SizingControl, SmallestSizeMayBeJustThatOfTheLargestVolume)
{
  const auto filter = MakeSlabFilter();
  filter->SetMinimumSize(1.0);
  filter->SetMaximumVolume(0.6 * (1.0 - 1e-6));
  EXPECT_NO_THROW(filter->Update());
}

TEST(SizingControl, SizingFilterThrowsOnWhatContradicts)
{
  const auto expect = [](const std::function<void(SizingFilter *)> & set, const std::string & words) {
    const auto filter = MakeSlabFilter();
    set(filter);
    mmmtest::ExpectException([&] { filter->Update(); }, words);
  };
  expect([](SizingFilter * filter) { filter->SizingImageReplacesOn(); }, "There is no sizing image");
  expect([](SizingFilter * filter) { filter->SetLabels({ 1, 2 }); }, "There are 2 labels for 3 indicator images");
  expect([](SizingFilter * filter) { filter->SetLabelSizes("0:max=1"); }, "The labels are 2, 3, 5.");
  expect([](SizingFilter * filter) { filter->SetLabelSizes("3:factor=0"); }, "The factor of label 3 is 0. It must be");
  expect([](SizingFilter * filter) { filter->SetLabelSizes("3:min=-1"); }, "The smallest size in label 3 is -1 mm");
  expect([](SizingFilter * filter) { filter->SetLabelSizes("3:max=0"); }, "The largest size in label 3 is 0 mm");
  expect([](SizingFilter * filter) { filter->SetLabelSizes("3:min=2:max=1"); },
         "The smallest size in label 3, 2 mm, is above the largest, 1 mm");
  expect([](SizingFilter * filter) { filter->SetMaximumVolume(0.0); }, "The largest volume is 0 mm^3");
  expect([](SizingFilter * filter) { filter->SetMaximumVolume(0.01); }, "which is below the smallest size, 1.5 mm");
  expect([](SizingFilter * filter) { filter->SetRegionMaximumSize(1.0); }, "but no image of that region");
  expect([](SizingFilter * filter) { filter->SetRegionOfInterest(MakeMask([](int, int, int) { return true; })); },
         "The region of interest has no smallest or largest size");
}

TEST(SizingControl, ThrowsOnASizingImageThatIsNotANumber)
{
  const auto filter = MakeSlabFilter();
  filter->SetSizingImage(MakeSizes([](int i, int, int) { return i == 4 ? std::nanf("") : 2.0f; }));
  for (const bool replaces : { false, true })
  {
    filter->SetSizingImageReplaces(replaces);
    mmmtest::ExpectException([&] { filter->Update(); }, "The sizing image has the value nan at [4, 0, 0]");
  }
}

TEST(SizingControl, SameForAnyNumberOfThreads)
{
  std::vector<float> first;
  for (const itk::ThreadIdType threads : { 1, 2, 4 })
  {
    const mmmtest::ThreadCount count(threads);
    const auto                 filter = MakeSlabFilter();
    filter->SetLabelSizes("3:max=0.5,5:factor=0.7");
    filter->SetRegionOfInterest(MakeMask([](int i, int j, int) { return i > 3 && j < 6; }));
    filter->SetRegionMaximumSize(0.8);
    filter->SetSizingImage(MakeSizes([](int i, int, int k) { return i == k ? 0.4f : Infinity; }));
    filter->Update();
    const float *            values = filter->GetOutput()->GetBufferPointer();
    const std::vector<float> sizes(values, values + filter->GetOutput()->GetBufferedRegion().GetNumberOfPixels());
    first = first.empty() ? sizes : first;
    EXPECT_EQ(sizes, first) << threads;
  }
}

TEST(SizingControl, SizingFilterThrowsOnARegionElsewhere)
{
  const auto filter = MakeSlabFilter();
  filter->SetRegionMaximumSize(1.0);
  filter->SetRegionOfInterest(MakeMask([](int, int, int) { return false; }));
  mmmtest::ExpectException([&] { filter->Update(); }, "No voxel of the region of interest is in what is meshed");
  filter->SetExteriorIndex(0);
  filter->SetRegionOfInterest(MakeMask([](int i, int, int) { return i < 9; }));
  mmmtest::ExpectException([&] { filter->Update(); }, "No voxel of the region of interest is in what is meshed");
  filter->SetRegionOfInterest(mmmtest::MakeImage<MaskImage>(30, 12, 11, [](int, int, int) { return 1; }));
  mmmtest::ExpectException([&] { filter->Update(); }, "The region of interest covers");
}

TEST(SizingControl, MeshFollowsTheSizesOfALabel)
{
  const auto image = mmmtest::MakeHalves<LabelImage>(24, 9.0);
  const auto plain = MakeMeshFilter(image);
  const auto finer = MakeMeshFilter(image);
  finer->SetLabelSizes("2:max=1");
  EXPECT_GT(CountTetrahedra(finer, 2), 2 * CountTetrahedra(plain, 2));
  const auto coarser = MakeMeshFilter(image);
  coarser->SetLabelSizes(std::map<int, mmm::SizeRule>{ { 2, { 1.5 } } });
  EXPECT_LT(CountTetrahedra(coarser, 2), CountTetrahedra(plain, 2));
}

TEST(SizingControl, MeshFollowsTheRegionAndTheImageInAnyGeometry)
{
  std::size_t counts[3] = { 0, 0, 0 };
  for (const double unit : { 1.0, 0.25 })
  {
    const auto place = [unit](auto image) {
      mmmtest::SetObliqueGeometry(image.GetPointer(), unit, true);
      typename std::decay_t<decltype(*image)>::SpacingType spacing;
      spacing.Fill(unit);
      image->SetSpacing(spacing);
      auto region = image->GetBufferedRegion();
      region.SetIndex({ { 7, -3, 2 } });
      image->SetRegions(region);
      return image;
    };
    const auto labels = place(mmmtest::MakeHalves<LabelImage>(24, 9.0));
    const auto plain = MakeMeshFilter(labels);
    const auto inRegion = MakeMeshFilter(labels);
    inRegion->SetRegionOfInterest(
      place(mmmtest::MakeImage<MaskImage>(24, 24, 24, [](int i, int, int) { return i < 10; })));
    inRegion->SetRegionMaximumSize(unit);
    const auto replaced = MakeMeshFilter(labels);
    replaced->SetSizingImage(
      place(mmmtest::MakeImage<FloatImage>(24, 24, 24, [unit](int, int, int) { return 4.0 * unit; })));
    replaced->SizingImageReplacesOn();
    const std::size_t now[3] = { CountTetrahedra(plain, 1),
                                 CountTetrahedra(inRegion, 1),
                                 CountTetrahedra(replaced, 1) };
    EXPECT_GT(now[1], now[0] + now[0] / 2);
    EXPECT_LT(now[2], now[0]);
    for (int n = 0; n < 3; ++n)
    {
      EXPECT_TRUE(counts[n] == 0 || counts[n] == now[n]) << n;
      counts[n] = now[n];
    }
  }
}

TEST(SizingControl, MeshFilterThrowsOnWhatContradicts)
{
  const auto image = mmmtest::MakeImage<LabelImage>(
    12, 12, 12, [](int i, int j, int k) { return mmmtest::IsInBall(i, j, k, 12, 4.0) ? 1 : (i < 6 ? 0 : 9); });
  const auto expect = [&](const std::function<void(MeshFilter *)> & set, const std::string & words) {
    const auto filter = MakeMeshFilter(image);
    filter->SetExteriorLabels({ 4, 9, 0 });
    set(filter);
    mmmtest::ExpectException([&] { filter->Update(); }, words);
  };
  const auto mask = [](int count, int value) {
    return mmmtest::MakeImage<MaskImage>(count, 12, 12, [value](int, int, int) { return value; });
  };
  expect([](MeshFilter * filter) { filter->SetLabelSizes("7:max=1"); },
         "Sizes are given for 7, which is no label here");
  expect([](MeshFilter * filter) { filter->SetLabelSizes("0:max=1"); }, "The labels are 1, 9.");
  expect([](MeshFilter * filter) { filter->SetLabelSizes("1:min=3:max=2"); }, "is above the largest, 2 mm");
  expect([](MeshFilter * filter) { filter->SizingImageReplacesOn(); }, "There is no sizing image");
  expect([](MeshFilter * filter) { filter->SetRegionMinimumSize(1.0); }, "but no image of that region");
  expect([&](MeshFilter * filter) { filter->SetRegionOfInterest(mask(12, 1)); }, "has no smallest or largest size");
  expect(
    [&](MeshFilter * filter) {
      filter->SetRegionMaximumSize(1.0);
      filter->SetRegionOfInterest(mask(12, 0));
    },
    "No voxel of the region of interest is in what is meshed");
  expect(
    [&](MeshFilter * filter) {
      filter->SetRegionMaximumSize(1.0);
      filter->SetRegionOfInterest(mask(11, 1));
    },
    "The region of interest has [11, 12, 12] voxels and the label image [12, 12, 12]");
  expect(
    [&](MeshFilter * filter) {
      filter->SetRegionMinimumSize(2.0);
      filter->SetRegionMaximumSize(1.0);
      filter->SetRegionOfInterest(mask(12, 1));
    },
    "The smallest size in the region of interest, 2 mm, is above the largest, 1 mm");
}
