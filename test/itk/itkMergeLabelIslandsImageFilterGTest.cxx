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
#include "itkMergeLabelIslandsImageFilter.h"
#include "support/TestLabelImages.h"

#include <limits>

namespace
{
using ImageType = itk::Image<unsigned char, 3>;
using FilterType = itk::MergeLabelIslandsImageFilter<ImageType>;

FilterType::Pointer
MakeFilter(const ImageType * image)
{
  const auto filter = FilterType::New();
  filter->SetInput(image);
  return filter;
}

/** The label at a voxel of the filter's output. */
int
At(FilterType * filter, int i, int j, int k)
{
  return filter->GetOutput()->GetPixel({ { i, j, k } });
}

/** Label 1 everywhere, to draw on. */
ImageType::Pointer
MakeCanvas(int size)
{
  return mmmtest::MakeImage<ImageType>(size, size, size, [](int, int, int) { return 1; });
}

void
DrawRow(ImageType * image, int i, int j, int k, int length, int label)
{
  for (int step = 0; step < length; ++step)
  {
    image->SetPixel({ { i + step, j, k } }, static_cast<unsigned char>(label));
  }
}
} // namespace

TEST(MergeLabelIslandsImageFilter, MergesSmallComponents)
{
  const auto image = MakeCanvas(12);
  DrawRow(image, 1, 1, 1, 9, 2);
  DrawRow(image, 1, 5, 5, 7, 2);
  const auto filter = MakeFilter(image);
  filter->Update();
  EXPECT_EQ(At(filter, 1, 1, 1), 2);
  EXPECT_EQ(At(filter, 1, 5, 5), 1);
  EXPECT_EQ(At(filter, 7, 5, 5), 1);
}

TEST(MergeLabelIslandsImageFilter, KeepsComponentsOfTheMinimumSize)
{
  const auto image = MakeCanvas(12);
  DrawRow(image, 1, 1, 1, 9, 2);
  DrawRow(image, 1, 5, 5, 8, 2);
  const auto filter = MakeFilter(image);
  filter->Update();
  EXPECT_EQ(At(filter, 8, 5, 5), 2);
}

TEST(MergeLabelIslandsImageFilter, KeepsTheLargestComponentOfALabel)
{
  const auto image = MakeCanvas(8);
  DrawRow(image, 1, 1, 1, 2, 2);
  DrawRow(image, 1, 4, 4, 3, 2);
  const auto filter = MakeFilter(image);
  filter->Update();
  EXPECT_EQ(At(filter, 1, 1, 1), 1);
  EXPECT_EQ(At(filter, 1, 4, 4), 2);
}

TEST(MergeLabelIslandsImageFilter, KeepsTheFirstOfEquallyLargeComponents)
{
  const auto image = MakeCanvas(8);
  DrawRow(image, 5, 5, 1, 2, 2);
  DrawRow(image, 1, 1, 4, 2, 2);
  const auto filter = MakeFilter(image);
  filter->Update();
  EXPECT_EQ(At(filter, 5, 5, 1), 2);
  EXPECT_EQ(At(filter, 1, 1, 4), 1);
}

TEST(MergeLabelIslandsImageFilter, ConnectsVoxelsByTheirFacesOnly)
{
  const auto image = MakeCanvas(12);
  DrawRow(image, 1, 1, 1, 8, 2);
  DrawRow(image, 9, 2, 1, 2, 2); // touches the first row's end along an edge
  const auto filter = MakeFilter(image);
  filter->Update();
  EXPECT_EQ(At(filter, 8, 1, 1), 2);
  EXPECT_EQ(At(filter, 9, 2, 1), 1);
}

namespace
{
/** Voxels from (1, 1, 1) on that touch in corners only. */
void
DrawDiagonal(ImageType * image, int length)
{
  for (int n = 1; n <= length; ++n)
  {
    image->SetPixel({ { n, n, n } }, 2);
  }
}

std::size_t
CountMerged(FilterType * filter)
{
  filter->Update();
  const auto & records = filter->GetRecords();
  const auto   record = records.find(2);
  return record == records.end() ? 0 : record->second.voxels;
}
} // namespace

TEST(MergeLabelIslandsImageFilter, KeepsThreadsOfVoxelsThatTouchInCorners)
{
  const auto image = MakeCanvas(12);
  DrawDiagonal(image, 8);
  EXPECT_EQ(CountMerged(MakeFilter(image)), 0u);
}

TEST(MergeLabelIslandsImageFilter, MergesShortThreads)
{
  const auto image = MakeCanvas(12);
  DrawDiagonal(image, 7);
  EXPECT_EQ(CountMerged(MakeFilter(image)), 6u);
}

TEST(MergeLabelIslandsImageFilter, KeepsWhatLinksLargerPartsAcrossEdges)
{
  const auto image = MakeCanvas(24);
  DrawRow(image, 1, 1, 1, 9, 2);
  DrawRow(image, 10, 2, 1, 2, 2);
  DrawRow(image, 12, 1, 1, 9, 2);
  EXPECT_EQ(CountMerged(MakeFilter(image)), 0u);
}

namespace
{
/** A box of label 2 that is much larger than what else is drawn. */
void
DrawTrunk(ImageType * image)
{
  for (int n = 0; n < 64; ++n)
  {
    DrawRow(image, 12, 12 + n / 8, 12 + n % 8, 8, 2);
  }
}
} // namespace

TEST(MergeLabelIslandsImageFilter, KeepsLongThreadsOfThickLabels)
{
  const auto image = MakeCanvas(24);
  DrawTrunk(image);
  DrawDiagonal(image, 10);
  EXPECT_EQ(CountMerged(MakeFilter(image)), 0u);
}

TEST(MergeLabelIslandsImageFilter, MergesFrayedSheetsOfThickLabels)
{
  const auto image = MakeCanvas(24);
  DrawTrunk(image);
  for (int i = 0; i < 8; ++i)
  {
    for (int j = i % 2; j < 6; j += 2)
    {
      image->SetPixel({ { i + 1, j + 1, 4 } }, 2);
    }
  }
  EXPECT_EQ(CountMerged(MakeFilter(image)), 24u);
}

TEST(MergeLabelIslandsImageFilter, CountsTheFacesOfAllVoxelsOfAComponent)
{
  // the island's first voxel has more faces to label 1, the whole of it to label 3
  const auto image = mmmtest::MakeImage<ImageType>(10, 9, 9, [](int i, int, int) { return i < 4 ? 1 : 3; });
  DrawRow(image, 0, 0, 0, 4, 2);
  DrawRow(image, 0, 1, 0, 4, 2);
  DrawRow(image, 3, 4, 4, 3, 2);
  const auto filter = MakeFilter(image);
  filter->Update();
  EXPECT_EQ(At(filter, 0, 0, 0), 2);
  for (int i = 3; i < 6; ++i)
  {
    EXPECT_EQ(At(filter, i, 4, 4), 3);
  }
}

TEST(MergeLabelIslandsImageFilter, BreaksTiesByTheLowestLabel)
{
  const auto image = mmmtest::MakeImage<ImageType>(10, 9, 9, [](int i, int, int) { return i < 5 ? 4 : 3; });
  DrawRow(image, 0, 0, 0, 9, 2);
  DrawRow(image, 4, 4, 4, 2, 2);
  const auto filter = MakeFilter(image);
  filter->Update();
  EXPECT_EQ(At(filter, 4, 4, 4), 3);
  EXPECT_EQ(At(filter, 5, 4, 4), 3);
}

TEST(MergeLabelIslandsImageFilter, DecidesOnTheImageAsItWas)
{
  const auto image = MakeCanvas(9);
  DrawRow(image, 0, 0, 0, 9, 2);
  DrawRow(image, 0, 8, 8, 9, 3);
  DrawRow(image, 3, 4, 4, 1, 2);
  for (const auto & at : { ImageType::IndexType{ { 2, 4, 4 } },
                           ImageType::IndexType{ { 4, 4, 4 } },
                           ImageType::IndexType{ { 3, 3, 4 } },
                           ImageType::IndexType{ { 3, 5, 4 } } })
  {
    image->SetPixel(at, 3);
  }
  const auto filter = MakeFilter(image);
  filter->Update();
  EXPECT_EQ(At(filter, 3, 4, 4), 3) << "it touches four voxels of label 3 and two of label 1";
  EXPECT_EQ(At(filter, 2, 4, 4), 1) << "label 3 around it is gone, at the same time";
}

TEST(MergeLabelIslandsImageFilter, KeepsAllForMinimumSizesZeroAndOne)
{
  const auto image = MakeCanvas(6);
  DrawRow(image, 1, 1, 1, 1, 2);
  DrawRow(image, 1, 4, 4, 1, 2);
  for (const itk::SizeValueType size : { 0, 1 })
  {
    const auto filter = MakeFilter(image);
    filter->SetMinimumIslandSize(size);
    filter->Update();
    EXPECT_EQ(At(filter, 1, 1, 1), 2);
    EXPECT_EQ(At(filter, 1, 4, 4), 2);
  }
}

TEST(MergeLabelIslandsImageFilter, LeavesAnImageOfOneLabelAlone)
{
  const auto filter = MakeFilter(mmmtest::MakeImage<ImageType>(1, 2, 1, [](int, int, int) { return 5; }));
  filter->Update();
  EXPECT_EQ(At(filter, 0, 1, 0), 5);
}

TEST(MergeLabelIslandsImageFilter, MergesExteriorLabelsIntoTheFirstThatIsPresent)
{
  const auto image =
    mmmtest::MakeImage<ImageType>(9, 9, 9, [](int i, int, int) { return i < 3 ? 7 : (i < 6 ? 1 : 4); });
  const auto filter = MakeFilter(image);
  filter->SetExteriorLabels({ 9, 7, 4, 5 });
  filter->Update();
  EXPECT_EQ(At(filter, 0, 0, 0), 7);
  EXPECT_EQ(At(filter, 4, 0, 0), 1);
  EXPECT_EQ(At(filter, 8, 0, 0), 7);
  EXPECT_EQ(filter->GetAbsentExteriorLabels(), (std::vector<int>{ 9, 5 }));
  EXPECT_EQ(filter->GetRecords().at(4).voxelsBefore, 243u);
  EXPECT_EQ(filter->GetRecords().at(4).voxelsAfter, 0u);
  EXPECT_EQ(filter->GetRecords().at(7).voxelsAfter, 486u);
}

TEST(MergeLabelIslandsImageFilter, MergesExteriorLabelsBeforeIslands)
{
  // a voxel of label 9 beside label 0 is no island once both are exterior
  const auto image = mmmtest::MakeImage<ImageType>(8, 8, 8, [](int i, int, int) { return i < 4 ? 0 : 1; });
  image->SetPixel({ { 3, 4, 4 } }, 9);
  const auto filter = MakeFilter(image);
  filter->SetExteriorLabels({ 0, 9 });
  filter->Update();
  EXPECT_EQ(At(filter, 3, 4, 4), 0);
  EXPECT_EQ(filter->GetRecords().at(9).components, 0u);
}

TEST(MergeLabelIslandsImageFilter, AcceptsAnEmptyListOfExteriorLabels)
{
  const auto filter = MakeFilter(mmmtest::MakeBall<ImageType>(10, 3.0));
  filter->SetExteriorLabels({});
  filter->Update();
  EXPECT_TRUE(filter->GetAbsentExteriorLabels().empty());
  EXPECT_EQ(At(filter, 0, 0, 0), 0);
}

TEST(MergeLabelIslandsImageFilter, RecordsWhatWasMerged)
{
  const auto image = MakeCanvas(12);
  DrawRow(image, 1, 1, 1, 9, 2);
  DrawRow(image, 1, 5, 5, 7, 2);
  DrawRow(image, 1, 8, 8, 2, 2);
  const auto filter = MakeFilter(image);
  filter->Update();
  const auto & record = filter->GetRecords().at(2);
  EXPECT_EQ(record.components, 2u);
  EXPECT_EQ(record.voxels, 9u);
  EXPECT_EQ(record.destinations, (std::map<int, std::size_t>{ { 1, 9u } }));
  EXPECT_EQ(record.voxelsBefore, 18u);
  EXPECT_EQ(record.voxelsAfter, 9u);
  EXPECT_EQ(filter->GetRecords().at(1).components, 0u);
  EXPECT_EQ(filter->GetRecords().at(1).voxelsAfter, 1728u - 9u);
}

TEST(MergeLabelIslandsImageFilter, KeepsGeometryAndRegion)
{
  const auto image = mmmtest::MakeBall<ImageType>(10, 3.0);
  mmmtest::SetObliqueGeometry<ImageType>(image, 2.0, true);
  auto region = image->GetBufferedRegion();
  region.SetIndex({ { 5, -3, 100 } });
  image->SetRegions(region);
  const auto filter = MakeFilter(image);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetBufferedRegion(), region);
  EXPECT_EQ(filter->GetOutput()->GetOrigin(), image->GetOrigin());
  EXPECT_EQ(filter->GetOutput()->GetDirection(), image->GetDirection());
  EXPECT_EQ(At(filter, 10, 2, 105), 1);
}

template <typename TPixel>
class MergeLabelIslandsImageFilterPixels : public testing::Test
{};
using PixelTypes = testing::Types<unsigned char, unsigned short, short, int, unsigned int>;
TYPED_TEST_SUITE(MergeLabelIslandsImageFilterPixels, PixelTypes);

TYPED_TEST(MergeLabelIslandsImageFilterPixels, TellsTheExtremeLabelsApart)
{
  using TypedImage = itk::Image<TypeParam, 3>;
  const auto lowest = std::numeric_limits<TypeParam>::min();
  const auto highest =
    static_cast<TypeParam>(std::min<double>(std::numeric_limits<TypeParam>::max(), std::numeric_limits<int>::max()));
  const auto image = mmmtest::MakeImage<TypedImage>(8, 8, 8, [=](int i, int, int) { return i < 4 ? lowest : highest; });
  image->SetPixel({ { 1, 4, 4 } }, highest);
  const auto filter = itk::MergeLabelIslandsImageFilter<TypedImage>::New();
  filter->SetInput(image);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPixel({ { 1, 4, 4 } }), lowest);
  EXPECT_EQ(filter->GetOutput()->GetPixel({ { 7, 4, 4 } }), highest);
  EXPECT_EQ(filter->GetRecords().at(static_cast<int>(highest)).components, 1u);
}

TEST(MergeLabelIslandsImageFilter, ThrowsOnLabelsBeyondInt)
{
  using LargeImage = itk::Image<unsigned int, 3>;
  const auto filter = itk::MergeLabelIslandsImageFilter<LargeImage>::New();
  filter->SetInput(mmmtest::MakeImage<LargeImage>(4, 4, 4, [](int i, int, int) { return i ? 3000000000u : 0u; }));
  mmmtest::ExpectException([&] { filter->Update(); }, "The label 3000000000 is beyond the range of labels");
}

TEST(MergeLabelIslandsImageFilter, AbortsWhenAsked)
{
  const auto filter = MakeFilter(mmmtest::MakeBall<ImageType>(40, 10.0));
  mmmtest::AbortOnProgress(filter);
  EXPECT_THROW(filter->Update(), itk::ProcessAborted);
}

TEST(MergeLabelIslandsImageFilter, PrintsItsParameters)
{
  const auto filter = MakeFilter(mmmtest::MakeBall<ImageType>(10, 3.0));
  filter->Update();
  const auto text = mmmtest::Printed(filter.GetPointer());
  EXPECT_NE(text.find("MinimumIslandSize: 8"), std::string::npos) << text;
  EXPECT_STREQ(filter->GetNameOfClass(), "MergeLabelIslandsImageFilter");
}
