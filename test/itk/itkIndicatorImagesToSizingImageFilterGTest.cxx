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
#include "itkIndicatorImagesToSizingImageFilter.h"
#include "itkLabelImageToIndicatorImagesFilter.h"
#include "support/TestLabelImages.h"

#include "itkImageRegionConstIteratorWithIndex.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using LabelImage = itk::Image<unsigned char, 3>;
using IndicatorImage = itk::Image<float, 3>;
using SizingImage = itk::Image<float, 3>;
using FilterType = itk::IndicatorImagesToSizingImageFilter<IndicatorImage>;
using IndicatorImages = std::vector<IndicatorImage::Pointer>;

IndicatorImages
MakeIndicators(const LabelImage * labels)
{
  const auto filter = itk::LabelImageToIndicatorImagesFilter<LabelImage>::New();
  filter->SetInput(labels);
  filter->Update();
  IndicatorImages images;
  for (const int label : filter->GetLabels())
  {
    images.emplace_back(filter->GetOutputForLabel(label));
    images.back()->DisconnectPipeline();
  }
  return images;
}

/** The first indicator is that of the exterior. */
FilterType::Pointer
MakeFilter(const IndicatorImages & indicators)
{
  const auto filter = FilterType::New();
  for (unsigned int n = 0; n < indicators.size(); ++n)
  {
    filter->SetInput(n, indicators[n]);
  }
  filter->SetExteriorIndex(0);
  return filter;
}

FilterType::Pointer
MakeBallFilter(int size, double radius)
{
  return MakeFilter(MakeIndicators(mmmtest::MakeBall<LabelImage>(size, radius)));
}

float
Smallest(const SizingImage * image)
{
  const float * values = image->GetBufferPointer();
  return *std::min_element(values, values + image->GetBufferedRegion().GetNumberOfPixels());
}

float
Largest(const SizingImage * image)
{
  const float * values = image->GetBufferPointer();
  return *std::max_element(values, values + image->GetBufferedRegion().GetNumberOfPixels());
}

SizingImage::Pointer
MakeSizes(int size, float value)
{
  return mmmtest::MakeImage<SizingImage>(size, size, size, [value](int, int, int) { return value; });
}
} // namespace

TEST(IndicatorImagesToSizingImageFilter, ChordToleranceDecidesOnASphere)
{
  const auto filter = MakeBallFilter(36, 12.0);
  filter->SetMaximumSize(std::numeric_limits<double>::infinity());
  for (const double tolerance : { 0.1, 0.2 })
  {
    filter->SetChordTolerance(tolerance);
    filter->Update();
    const double expected = std::sqrt(8.0 * tolerance * 12.0);
    EXPECT_NEAR(filter->GetOutput()->GetPixel({ { 6, 18, 18 } }), expected, 0.25 * expected);
  }
}

TEST(IndicatorImagesToSizingImageFilter, EpsilonDecidesOnALayer)
{
  // a layer of 6 voxels: the interfaces are 3 voxels from its medial axis
  const auto indicators = MakeIndicators(
    mmmtest::MakeImage<LabelImage>(24, 24, 24, [](int, int, int k) { return k < 9 || k >= 15 ? 0 : 1; }));
  for (const double epsilon : { 0.5, 1.0 })
  {
    const auto filter = MakeFilter(indicators);
    filter->SetEpsilon(epsilon);
    filter->Update();
    EXPECT_NEAR(filter->GetOutput()->GetPixel({ { 12, 12, 9 } }), epsilon * 3.0, 0.4);
  }
}

TEST(IndicatorImagesToSizingImageFilter, GradientIsLimited)
{
  const auto filter = MakeBallFilter(30, 6.0);
  filter->SetGradientLimit(0.3);
  filter->Update();
  const auto * sizes = filter->GetOutput();
  const auto   region = sizes->GetBufferedRegion();
  for (itk::ImageRegionConstIteratorWithIndex<SizingImage> it(sizes, region); !it.IsAtEnd(); ++it)
  {
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      auto after = it.GetIndex();
      ++after[axis];
      if (region.IsInside(after))
      {
        ASSERT_LE(std::abs(it.Get() - sizes->GetPixel(after)), 0.3 + 1e-3);
      }
    }
  }
  EXPECT_GT(Largest(sizes), Smallest(sizes) + 1.0f);
}

TEST(IndicatorImagesToSizingImageFilter, IsWithinItsBounds)
{
  const auto filter = MakeBallFilter(30, 6.0);
  filter->SetMinimumSize(2.5);
  filter->SetMaximumSize(3.0);
  filter->Update();
  EXPECT_GE(Smallest(filter->GetOutput()), 2.5f);
  EXPECT_LE(Largest(filter->GetOutput()), 3.0f);
}

TEST(IndicatorImagesToSizingImageFilter, MaximumBelowTheSpacingIsHeeded)
{
  const auto filter = MakeBallFilter(20, 5.0);
  filter->SetMaximumSize(0.5);
  filter->Update();
  EXPECT_FLOAT_EQ(Largest(filter->GetOutput()), 0.5f);
}

TEST(IndicatorImagesToSizingImageFilter, IsInMillimeters)
{
  const auto              labels = mmmtest::MakeBall<LabelImage>(20, 6.0);
  LabelImage::SpacingType spacing;
  std::vector<float>      relative[2];
  for (const int n : { 0, 1 })
  {
    const double unit = n ? 0.125 : 1.0;
    spacing.Fill(unit);
    labels->SetSpacing(spacing);
    const auto filter = MakeFilter(MakeIndicators(labels));
    filter->SetMinimumSize(1.25 * unit);
    filter->SetMaximumSize(2.0 * unit);
    filter->SetChordTolerance(0.05 * unit);
    filter->Update();
    const float * values = filter->GetOutput()->GetBufferPointer();
    for (std::size_t v = 0; v < filter->GetOutput()->GetBufferedRegion().GetNumberOfPixels(); ++v)
    {
      relative[n].push_back(static_cast<float>(values[v] / unit));
    }
  }
  EXPECT_EQ(relative[0], relative[1]);
}

TEST(IndicatorImagesToSizingImageFilter, CoversTheUnionOfItsInputs)
{
  const auto labels = mmmtest::MakeHalves<LabelImage>(30, 6.0);
  auto       region = labels->GetBufferedRegion();
  region.SetIndex({ { 5, -3, 100 } });
  labels->SetRegions(region);
  mmmtest::SetObliqueGeometry<LabelImage>(labels, 1.0, false);
  const auto filter = MakeFilter(MakeIndicators(labels));
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetBufferedRegion(), region);
  EXPECT_EQ(filter->GetOutput()->GetOrigin(), labels->GetOrigin());
  EXPECT_EQ(filter->GetOutput()->GetDirection(), labels->GetDirection());
}

TEST(IndicatorImagesToSizingImageFilter, DoesNotExceedTheSizingImage)
{
  const auto filter = MakeBallFilter(24, 8.0);
  const auto sizes = MakeSizes(24, std::numeric_limits<float>::infinity());
  sizes->SetPixel({ { 12, 12, 12 } }, 0.75f); // below the smallest size, too
  filter->SetSizingImage(sizes);
  filter->Update();
  EXPECT_FLOAT_EQ(filter->GetOutput()->GetPixel({ { 12, 12, 12 } }), 0.75f);
  EXPECT_LE(filter->GetOutput()->GetPixel({ { 12, 12, 14 } }), 1.75f + 1e-3f);
}

TEST(IndicatorImagesToSizingImageFilter, ExteriorAtTheBorderIsNoInterface)
{
  const auto indicators =
    MakeIndicators(mmmtest::MakeImage<LabelImage>(24, 24, 24, [](int, int, int k) { return k < 12 ? 0 : 1; }));
  for (const int exterior : { 0, -1 })
  {
    const auto filter = MakeFilter(indicators);
    filter->SetExteriorIndex(exterior);
    filter->SetMaximumSize(std::numeric_limits<double>::infinity());
    filter->Update();
    const float size = filter->GetOutput()->GetPixel({ { 0, 12, 1 } });
    if (exterior == 0)
    {
      EXPECT_GT(size, 5.0f) << "the interface is 10 voxels away";
    }
    EXPECT_LE(filter->GetOutput()->GetPixel({ { 0, 12, 18 } }), 30.0f);
  }
}

TEST(IndicatorImagesToSizingImageFilter, SameForAnyNumberOfThreads)
{
  const auto         indicators = MakeIndicators(mmmtest::MakeHalves<LabelImage>(24, 8.0));
  std::vector<float> first;
  for (const itk::ThreadIdType threads : { 1, 2, 4 })
  {
    const mmmtest::ThreadCount count(threads);
    const auto                 filter = MakeFilter(indicators);
    filter->Update();
    const float *            values = filter->GetOutput()->GetBufferPointer();
    const std::vector<float> sizes(values, values + filter->GetOutput()->GetBufferedRegion().GetNumberOfPixels());
    if (first.empty())
    {
      first = sizes;
    }
    EXPECT_EQ(sizes, first) << threads;
  }
}

TEST(IndicatorImagesToSizingImageFilter, ThrowsOnParametersOutOfRange)
{
  const auto indicators = MakeIndicators(mmmtest::MakeBall<LabelImage>(12, 4.0));
  const auto expect = [&](const std::function<void(FilterType *)> & set, const std::string & words) {
    const auto filter = MakeFilter(indicators);
    set(filter);
    mmmtest::ExpectException([&] { filter->Update(); }, words);
  };
  expect([](FilterType * filter) { filter->SetEpsilon(0.0); }, "The epsilon is 0. It must be positive and finite.");
  expect([](FilterType * filter) { filter->SetEpsilon(FilterType::Automatic); }, "The epsilon is nan");
  expect([](FilterType * filter) { filter->SetChordTolerance(-0.1); }, "The chord tolerance is -0.1 mm");
  expect([](FilterType * filter) { filter->SetGradientLimit(0.0); }, "The gradient limit is 0");
  expect([](FilterType * filter) { filter->SetMinimumSize(-2.0); }, "The smallest size is -2 mm");
  expect([](FilterType * filter) { filter->SetMaximumSize(0.0); }, "The largest size is 0 mm. It must be positive.");
  expect(
    [](FilterType * filter) {
      filter->SetMinimumSize(3.0);
      filter->SetMaximumSize(2.0);
    },
    "The smallest size, 3 mm, is above the largest, 2 mm");
  expect([](FilterType * filter) { filter->SetExteriorIndex(2); }, "ExteriorIndex is 2, but there are 2");
}

TEST(IndicatorImagesToSizingImageFilter, ThrowsOnASizingImageThatIsNotPositive)
{
  const auto filter = MakeBallFilter(12, 4.0);
  const auto sizes = MakeSizes(12, 2.0f);
  sizes->SetPixel({ { 3, 4, 5 } }, 0.0f);
  filter->SetSizingImage(sizes);
  mmmtest::ExpectException([&] { filter->Update(); }, "The sizing image has the value 0 at [3, 4, 5]");
}

TEST(IndicatorImagesToSizingImageFilter, ThrowsOnASizingImageOfAnotherGrid)
{
  const auto filter = MakeBallFilter(12, 4.0);
  filter->SetSizingImage(MakeSizes(13, 2.0f));
  mmmtest::ExpectException([&] { filter->Update(); }, "The sizing image covers");

  const auto               sizes = MakeSizes(12, 2.0f);
  SizingImage::SpacingType spacing;
  spacing.Fill(2.0);
  sizes->SetSpacing(spacing);
  filter->SetSizingImage(sizes);
  mmmtest::ExpectException([&] { filter->Update(); }, "Inputs do not occupy the same physical space");
}

TEST(IndicatorImagesToSizingImageFilter, ThrowsOnInputsOfDifferentGeometry)
{
  const auto indicators = MakeIndicators(mmmtest::MakeBall<LabelImage>(12, 4.0));
  mmmtest::SetObliqueGeometry<IndicatorImage>(indicators[1], 1.0, false);
  const auto filter = MakeFilter(indicators);
  mmmtest::ExpectException([&] { filter->Update(); }, "Inputs do not occupy the same physical space");
}

TEST(IndicatorImagesToSizingImageFilter, ThrowsOnMissingInputs)
{
  const auto filter = FilterType::New();
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
  const auto indicators = MakeIndicators(mmmtest::MakeBall<LabelImage>(12, 4.0));
  filter->SetInput(0, indicators[0]);
  filter->SetInput(2, indicators[1]);
  mmmtest::ExpectException([&] { filter->Update(); }, "Input 1 of 3 is missing");
}

TEST(IndicatorImagesToSizingImageFilter, AbortsWhenAsked)
{
  const auto filter = MakeBallFilter(12, 4.0);
  mmmtest::AbortOnProgress(filter);
  EXPECT_THROW(filter->Update(), itk::ProcessAborted);
}

TEST(IndicatorImagesToSizingImageFilter, RunsOnce)
{
  const auto                filter = MakeBallFilter(12, 4.0);
  const mmmtest::RunCounter runs(filter);
  filter->Update();
  filter->Update();
  EXPECT_EQ(runs.GetCount(), 1);
}

TEST(IndicatorImagesToSizingImageFilter, PrintsItsParameters)
{
  const auto filter = MakeBallFilter(12, 4.0);
  const auto text = mmmtest::Printed(filter.GetPointer());
  EXPECT_NE(text.find("Epsilon: 2.5"), std::string::npos) << text;
  EXPECT_STREQ(filter->GetNameOfClass(), "IndicatorImagesToSizingImageFilter");
}
