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
#include "itkLabelImageToIndicatorImagesFilter.h"
#include "support/TestLabelImages.h"

#include "itkCastImageFilter.h"
#include "itkImageRegionConstIteratorWithIndex.h"

#include <algorithm>
#include <cmath>

namespace
{
using LabelImage = itk::Image<short, 3>;
using IndicatorImage = itk::Image<float, 3>;
using FilterType = itk::LabelImageToIndicatorImagesFilter<LabelImage, IndicatorImage>;

FilterType::Pointer
MakeFilter(const LabelImage * image)
{
  const auto filter = FilterType::New();
  filter->SetInput(image);
  return filter;
}

std::vector<float>
ValuesOf(const IndicatorImage * image)
{
  const float * values = image->GetBufferPointer();
  return std::vector<float>(values, values + image->GetBufferedRegion().GetNumberOfPixels());
}
} // namespace

TEST(LabelImageToIndicatorImagesFilter, SphereIndicatorIsTheDistance)
{
  constexpr int    size = 40;
  constexpr double radius = 14.0;
  const auto       filter = MakeFilter(mmmtest::MakeBall<LabelImage>(size, radius));
  filter->Update();
  const auto * indicator = filter->GetOutputForLabel(1);
  const double c = 0.5 * (size - 1);
  double       sum = 0.0;
  double       largest = 0.0;
  int          count = 0;
  for (itk::ImageRegionConstIteratorWithIndex<IndicatorImage> it(indicator, indicator->GetBufferedRegion());
       !it.IsAtEnd();
       ++it)
  {
    const auto & at = it.GetIndex();
    const double distance = radius - std::hypot(at[0] - c, at[1] - c, at[2] - c);
    if (std::abs(distance) < 2.0)
    {
      const double error = std::abs(it.Get() - distance);
      sum += error;
      largest = std::max(largest, error);
      ++count;
    }
  }
  EXPECT_LT(sum / count, 0.1);
  EXPECT_LT(largest, 0.4);
}

TEST(LabelImageToIndicatorImagesFilter, RadiusZeroGivesTheDistanceToVoxelFaces)
{
  const auto image = mmmtest::MakeImage<LabelImage>(12, 6, 6, [](int i, int, int) { return i < 6 ? 0 : 1; });
  const auto filter = MakeFilter(image);
  filter->SetRadius(0.0);
  filter->Update();
  const auto * indicator = filter->GetOutputForLabel(1);
  for (int i = 3; i < 9; ++i)
  {
    EXPECT_NEAR(indicator->GetPixel({ { i, 3, 3 } }), i - 5.5, 1e-6);
  }
}

TEST(LabelImageToIndicatorImagesFilter, IndicatorsOfTwoLabelsAreOpposite)
{
  const auto filter = MakeFilter(mmmtest::MakeBall<LabelImage>(20, 6.0));
  filter->CropToBandOff();
  filter->Update();
  const auto outside = ValuesOf(filter->GetOutputForLabel(0));
  const auto inside = ValuesOf(filter->GetOutputForLabel(1));
  ASSERT_EQ(outside.size(), inside.size());
  for (std::size_t n = 0; n < inside.size(); ++n)
  {
    ASSERT_NEAR(inside[n], -outside[n], 0.25);
  }
}

TEST(LabelImageToIndicatorImagesFilter, ValuesAreInMillimeters)
{
  const auto image = mmmtest::MakeBall<LabelImage>(16, 5.0);
  const auto filter = MakeFilter(image);
  filter->Update();
  const auto inVoxels = ValuesOf(filter->GetOutputForLabel(1));
  EXPECT_DOUBLE_EQ(filter->GetBandWidth(), 3.0);

  LabelImage::SpacingType spacing;
  spacing.Fill(0.125);
  image->SetSpacing(spacing);
  filter->Update();
  const auto inMillimeters = ValuesOf(filter->GetOutputForLabel(1));
  EXPECT_DOUBLE_EQ(filter->GetBandWidth(), 0.375);
  ASSERT_EQ(inMillimeters.size(), inVoxels.size());
  for (std::size_t n = 0; n < inVoxels.size(); ++n)
  {
    ASSERT_EQ(inMillimeters[n], 0.125f * inVoxels[n]);
  }
}

TEST(LabelImageToIndicatorImagesFilter, RadiusIsInMillimeters)
{
  const auto image = mmmtest::MakeBall<LabelImage>(20, 6.0);
  const auto filter = MakeFilter(image);
  filter->SetRadius(2.0);
  filter->Update();
  const auto              inVoxels = ValuesOf(filter->GetOutputForLabel(1));
  LabelImage::SpacingType spacing;
  spacing.Fill(0.25);
  image->SetSpacing(spacing);
  filter->SetRadius(0.5);
  filter->Update();
  const auto inMillimeters = ValuesOf(filter->GetOutputForLabel(1));
  ASSERT_EQ(inMillimeters.size(), inVoxels.size());
  for (std::size_t n = 0; n < inVoxels.size(); ++n)
  {
    ASSERT_EQ(inMillimeters[n], 0.25f * inVoxels[n]);
  }
}

TEST(LabelImageToIndicatorImagesFilter, OutputsEveryLabelOfASparseLabelSet)
{
  const auto filter = MakeFilter(mmmtest::MakeHalves<LabelImage>(20, 6.0, 255, 2035));
  filter->Update();
  EXPECT_EQ(filter->GetLabels(), (std::vector<int>{ 0, 255, 2035 }));
  EXPECT_EQ(filter->GetNumberOfIndexedOutputs(), 3u);
  EXPECT_EQ(filter->GetOutputForLabel(2035), filter->GetOutput(2));
  EXPECT_GT(filter->GetOutputForLabel(255)->GetPixel({ { 9, 9, 7 } }), 0.5f);
  EXPECT_LT(filter->GetOutputForLabel(2035)->GetPixel({ { 9, 9, 7 } }), -0.5f);
  mmmtest::ExpectException([&] { filter->GetOutputForLabel(1); }, "The image has no label 1");
}

TEST(LabelImageToIndicatorImagesFilter, CroppedImagesAreParts)
{
  const auto image = mmmtest::MakeHalves<LabelImage>(32, 6.0);
  auto       region = image->GetBufferedRegion();
  region.SetIndex({ { 5, -3, 100 } });
  image->SetRegions(region);
  const auto cropped = MakeFilter(image);
  const auto whole = MakeFilter(image);
  whole->CropToBandOff();
  cropped->Update();
  whole->Update();
  for (const int label : { 0, 1, 2 })
  {
    const auto * part = cropped->GetOutputForLabel(label);
    const auto * all = whole->GetOutputForLabel(label);
    EXPECT_EQ(all->GetBufferedRegion(), region);
    EXPECT_EQ(part->GetBufferedRegion(), part->GetLargestPossibleRegion());
    EXPECT_TRUE(region.IsInside(part->GetBufferedRegion()));
    for (itk::ImageRegionConstIteratorWithIndex<IndicatorImage> it(all, region); !it.IsAtEnd(); ++it)
    {
      const bool isInside = part->GetBufferedRegion().IsInside(it.GetIndex());
      ASSERT_EQ(it.Get(), isInside ? part->GetPixel(it.GetIndex()) : -3.0f) << label << it.GetIndex();
    }
  }
  EXPECT_LT(cropped->GetOutputForLabel(1)->GetBufferedRegion().GetNumberOfPixels(), region.GetNumberOfPixels() / 2);
}

TEST(LabelImageToIndicatorImagesFilter, PhysicalPositionsAreThoseOfTheInput)
{
  const auto image = mmmtest::MakeHalves<LabelImage>(24, 6.0);
  mmmtest::SetObliqueGeometry<LabelImage>(image, 1.0, true);
  const auto filter = MakeFilter(image);
  filter->Update();
  const auto *                indicator = filter->GetOutputForLabel(2);
  const LabelImage::IndexType at{ { 12, 12, 14 } };
  LabelImage::PointType       inImage;
  LabelImage::PointType       inIndicator;
  image->TransformIndexToPhysicalPoint(at, inImage);
  indicator->TransformIndexToPhysicalPoint(at, inIndicator);
  EXPECT_EQ(inImage, inIndicator);
  EXPECT_EQ(indicator->GetDirection(), image->GetDirection());
}

TEST(LabelImageToIndicatorImagesFilter, ReadsNoPixelsForTheSakeOfInformation)
{
  using CopyFilter = itk::CastImageFilter<LabelImage, LabelImage>;
  const auto image = mmmtest::MakeHalves<LabelImage>(20, 6.0);
  const auto copy = CopyFilter::New();
  copy->SetInput(image);
  copy->InPlaceOff();
  const auto filter = MakeFilter(copy->GetOutput());
  filter->UpdateOutputInformation();
  EXPECT_EQ(copy->GetOutput()->GetBufferedRegion().GetNumberOfPixels(), 0u);
  EXPECT_EQ(filter->GetOutput()->GetLargestPossibleRegion(), image->GetLargestPossibleRegion());
  EXPECT_DOUBLE_EQ(filter->GetBandWidth(), 3.0);
}

TEST(LabelImageToIndicatorImagesFilter, LetsOthersFollowItsOutputsAfterTheUpdate)
{
  const auto                image = mmmtest::MakeHalves<LabelImage>(20, 6.0);
  const auto                filter = MakeFilter(image);
  const mmmtest::RunCounter runs(filter);
  filter->Update();
  ASSERT_EQ(filter->GetNumberOfIndexedOutputs(), 3u);

  using CastFilter = itk::CastImageFilter<IndicatorImage, itk::Image<double, 3>>;
  const auto cast = CastFilter::New();
  cast->SetInput(filter->GetOutput(2));
  cast->Update();
  EXPECT_EQ(runs.GetCount(), 1);
  // regions do not depend on the radius
  filter->SetRadius(0.7);
  cast->Update();
  EXPECT_EQ(runs.GetCount(), 2);
  EXPECT_EQ(cast->GetOutput()->GetBufferedRegion(), filter->GetOutput(2)->GetBufferedRegion());
  EXPECT_GT(cast->GetOutput()->GetPixel({ { 10, 10, 12 } }), 0.5);
}

TEST(LabelImageToIndicatorImagesFilter, LetsOthersFollowWholeOutputsAtOnce)
{
  const auto image = mmmtest::MakeHalves<LabelImage>(20, 6.0);
  const auto filter = MakeFilter(image);
  filter->CropToBandOff();
  using CastFilter = itk::CastImageFilter<IndicatorImage, itk::Image<double, 3>>;
  const auto cast = CastFilter::New();
  cast->SetInput(filter->GetOutput());
  cast->Update();
  EXPECT_EQ(cast->GetOutput()->GetBufferedRegion(), image->GetLargestPossibleRegion());
  EXPECT_GT(cast->GetOutput()->GetPixel({ { 1, 1, 1 } }), 0.5);
}

TEST(LabelImageToIndicatorImagesFilter, FollowsItsInput)
{
  const auto                image = mmmtest::MakeHalves<LabelImage>(20, 6.0);
  const auto                filter = MakeFilter(image);
  const mmmtest::RunCounter runs(filter);
  filter->Update();
  filter->Update();
  filter->GetOutput(2)->Update();
  EXPECT_EQ(runs.GetCount(), 1);
  EXPECT_EQ(filter->GetNumberOfIndexedOutputs(), 3u);

  filter->SetInput(mmmtest::MakeBall<LabelImage>(30, 4.0));
  filter->Update();
  EXPECT_EQ(runs.GetCount(), 2);
  EXPECT_EQ(filter->GetNumberOfIndexedOutputs(), 2u);
  EXPECT_EQ(filter->GetOutput(0)->GetBufferedRegion().GetSize()[0], 30u);
}

TEST(LabelImageToIndicatorImagesFilter, SameForAnyNumberOfThreads)
{
  const auto         image = mmmtest::MakeHalves<LabelImage>(20, 6.0);
  std::vector<float> first;
  for (const itk::ThreadIdType threads : { 1, 2, 4 })
  {
    const mmmtest::ThreadCount count(threads);
    const auto                 filter = MakeFilter(image);
    filter->Update();
    const auto values = ValuesOf(filter->GetOutputForLabel(2));
    if (first.empty())
    {
      first = values;
    }
    EXPECT_EQ(values, first) << threads;
  }
}

TEST(LabelImageToIndicatorImagesFilter, SameForAnyNumberOfThreadsWhereContactsAreKept)
{
  // layers of two labels that are narrow everywhere
  const auto image = mmmtest::MakeImage<LabelImage>(
    20, 20, 20, [](int i, int j, int k) { return 1 + (std::sin(0.9 * i) + std::sin(0.8 * j + 0.9 * k) > 0.0); });
  std::vector<float> first;
  for (const itk::ThreadIdType threads : { 1, 2, 4 })
  {
    const mmmtest::ThreadCount count(threads);
    const auto                 filter = MakeFilter(image);
    filter->KeepContactsOn();
    filter->Update();
    const auto values = ValuesOf(filter->GetOutputForLabel(2));
    if (first.empty())
    {
      first = values;
    }
    EXPECT_EQ(values, first) << threads;
  }
}

TEST(LabelImageToIndicatorImagesFilter, ThrowsOnASingleValue)
{
  const auto filter = MakeFilter(mmmtest::MakeImage<LabelImage>(6, 6, 6, [](int, int, int) { return 7; }));
  mmmtest::ExpectException([&] { filter->Update(); }, "The label image has a single value, 7");
}

TEST(LabelImageToIndicatorImagesFilter, ThrowsOnANegativeRadius)
{
  const auto filter = MakeFilter(mmmtest::MakeBall<LabelImage>(10, 3.0));
  filter->SetRadius(-1.0);
  mmmtest::ExpectException([&] { filter->Update(); }, "The radius is -1 mm");
}

TEST(LabelImageToIndicatorImagesFilter, ThrowsWherePositionsAreNotExact)
{
  const auto   image = mmmtest::MakeBall<LabelImage>(12, 4.0);
  const double origin[] = { 0.0, 1e18, 0.0 };
  image->SetOrigin(origin);
  const auto filter = FilterType::New();
  filter->SetInput(image);
  mmmtest::ExpectException([&] { filter->Update(); }, "The image is too far away: its origin is [0, 1e+18, 0] mm");
}

TEST(LabelImageToIndicatorImagesFilter, ThrowsOnMoreLabelsThanAreSupported)
{
  using LargeImage = itk::Image<int, 3>;
  const auto filter = itk::LabelImageToIndicatorImagesFilter<LargeImage>::New();
  filter->SetInput(
    mmmtest::MakeImage<LargeImage>(41, 40, 40, [](int i, int j, int k) { return (i * 40 + j) * 40 + k; }));
  mmmtest::ExpectException([&] { filter->Update(); }, "The image has 65600 labels");
}

TEST(LabelImageToIndicatorImagesFilter, AbortsWhenAsked)
{
  const auto filter = MakeFilter(mmmtest::MakeBall<LabelImage>(10, 3.0));
  mmmtest::AbortOnProgress(filter);
  EXPECT_THROW(filter->Update(), itk::ProcessAborted);
}

TEST(LabelImageToIndicatorImagesFilter, PrintsItsParameters)
{
  const auto filter = MakeFilter(mmmtest::MakeBall<LabelImage>(10, 3.0));
  filter->SetRadius(0.75);
  const auto text = mmmtest::Printed(filter.GetPointer());
  EXPECT_NE(text.find("Radius: 0.75"), std::string::npos) << text;
  EXPECT_STREQ(filter->GetNameOfClass(), "LabelImageToIndicatorImagesFilter");
}
