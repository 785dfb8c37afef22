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
// Meshes that go on into the air around.
#include "itkLabelImageToTetrahedralMeshFilter.h"
#include "support/TestLabelImages.h"
#include "support/TestMeshes.h"

#include <algorithm>
#include <cmath>

namespace
{
using LabelImage = itk::Image<unsigned char, 3>;
using FloatImage = itk::Image<float, 3>;
using MaskImage = itk::Image<unsigned char, 3>;
using FilterType = itk::LabelImageToTetrahedralMeshFilter<LabelImage>;

FilterType::Pointer
MakeFilter(const LabelImage * image)
{
  const auto filter = FilterType::New();
  filter->SetInput(image);
  return filter;
}

/** The box of a mesh's points: lower and upper corner. */
std::array<mmm::Vector, 2>
BoundsOf(FilterType * filter)
{
  std::array<mmm::Vector, 2> bounds{ { mmm::Vector::Constant(1e9), mmm::Vector::Constant(-1e9) } };
  for (const auto & point : mmmtest::PointsOf(filter->GetOutput()))
  {
    bounds[0] = bounds[0].cwiseMin(point);
    bounds[1] = bounds[1].cwiseMax(point);
  }
  return bounds;
}

void
ExpectBounds(FilterType * filter, const mmm::Vector & lower, const mmm::Vector & upper)
{
  const auto bounds = BoundsOf(filter);
  EXPECT_LT((bounds[0] - lower).norm(), 1e-9) << bounds[0].transpose();
  EXPECT_LT((bounds[1] - upper).norm(), 1e-9) << bounds[1].transpose();
}
} // namespace

TEST(ExteriorFilling, FillsTheBoxOfTheImage)
{
  const auto filter = MakeFilter(mmmtest::MakeHalves<LabelImage>(20, 7.0));
  filter->FillExteriorOn();
  filter->Update();
  const auto volumes = mmmtest::VolumesOf(filter->GetOutput());
  ASSERT_EQ(volumes.size(), 3u);
  EXPECT_NEAR(volumes.at(0) + volumes.at(1) + volumes.at(2), 8000.0, 1e-6);
  ExpectBounds(filter, mmm::Vector::Constant(-0.5), mmm::Vector::Constant(19.5));
  EXPECT_EQ(filter->GetOutsideLabel(), -1);
  EXPECT_TRUE(filter->GetVanishedLabels().empty());
}

TEST(ExteriorFilling, IsOneLabelForAllExteriorOnes)
{
  const auto image = mmmtest::MakeImage<LabelImage>(
    20, 20, 20, [](int i, int j, int k) { return mmmtest::IsInBall(i, j, k, 20, 7.0) ? 1 : (i < 10 ? 0 : 9); });
  const auto filter = MakeFilter(image);
  filter->SetExteriorLabels({ 9, 0 });
  filter->FillExteriorOn();
  filter->Update();
  EXPECT_EQ(filter->GetLabels(), (std::vector<int>{ 1, 9 }));
  EXPECT_NEAR(mmmtest::VolumesOf(filter->GetOutput()).at(9), 8000.0 - 4.0 / 3.0 * itk::Math::pi * 343.0, 150.0);
}

TEST(ExteriorFilling, PocketsAreAir)
{
  const auto image = mmmtest::MakeImage<LabelImage>(24, 24, 24, [](int i, int j, int k) {
    return mmmtest::IsInBall(i, j, k, 24, 9.0) && !mmmtest::IsInBall(i, j, k, 24, 4.0) ? 1 : 0;
  });
  const auto filter = MakeFilter(image);
  filter->FillExteriorOn();
  filter->Update();
  const auto volumes = mmmtest::VolumesOf(filter->GetOutput());
  EXPECT_NEAR(volumes.at(0) + volumes.at(1), 13824.0, 1e-6);
}

TEST(ExteriorFilling, MarginExtendsTheImageOrCutsIt)
{
  // the ball is 12 voxels wide, from 4 to 15
  const auto              image = mmmtest::MakeBall<LabelImage>(20, 6.0);
  LabelImage::SpacingType spacing;
  spacing.Fill(0.5);
  image->SetSpacing(spacing);
  auto region = image->GetBufferedRegion();
  region.SetIndex({ { 3, -4, 5 } });
  image->SetRegions(region);
  const mmm::Vector start(1.5, -2.0, 2.5);
  for (const double margin : { 0.0, 1.0, 3.5 })
  {
    const auto filter = MakeFilter(image);
    filter->SetAirMargin(margin);
    filter->Update();
    ExpectBounds(filter,
                 start + mmm::Vector::Constant(4 * 0.5 - 0.25 - margin),
                 start + mmm::Vector::Constant(15 * 0.5 + 0.25 + margin));
    const auto   volumes = mmmtest::VolumesOf(filter->GetOutput());
    const double box = std::pow(6.0 + 2.0 * margin, 3);
    EXPECT_NEAR(volumes.at(0) + volumes.at(1), box, 1e-6 * box);
    EXPECT_NEAR(volumes.at(1), 4.0 / 3.0 * itk::Math::pi * 27.0, 0.05 * 113.0);
  }
}

TEST(ExteriorFilling, AirFollowsWhereTheBorderCutsALabel)
{
  const auto image = mmmtest::MakeImage<LabelImage>(
    16, 16, 12, [](int i, int j, int) { return i >= 4 && i < 12 && j >= 4 && j < 12 ? 1 : 0; });
  const auto filter = MakeFilter(image);
  filter->SetAirMargin(2.0);
  filter->Update();
  ExpectBounds(filter, mmm::Vector(1.5, 1.5, -2.5), mmm::Vector(13.5, 13.5, 13.5));
  // what smoothing takes from the edges of so small a box it more than gives back to the faces
  EXPECT_NEAR(mmmtest::VolumesOf(filter->GetOutput()).at(1), 768.0, 0.08 * 768.0);
}

TEST(ExteriorFilling, AirIsTheFirstExteriorLabelIfTheImageHasNone)
{
  const auto filter =
    MakeFilter(mmmtest::MakeImage<LabelImage>(10, 10, 10, [](int i, int, int) { return i < 5 ? 1 : 2; }));
  filter->SetExteriorLabels({ 7, 0 });
  filter->SetAirMargin(3.0);
  filter->SetLabelSizes("7:max=3");
  filter->Update();
  EXPECT_EQ(filter->GetLabels(), (std::vector<int>{ 1, 2, 7 }));
  EXPECT_GT(mmmtest::VolumesOf(filter->GetOutput()).at(7), 3000.0);
}

TEST(ExteriorFilling, SizesAndRegionStayInPlace)
{
  const auto image = mmmtest::MakeBall<LabelImage>(20, 6.0);
  const auto filter = MakeFilter(image);
  filter->SetAirMargin(8.0);
  filter->SetSizingImage(mmmtest::MakeImage<FloatImage>(
    20, 20, 20, [](int i, int j, int k) { return i == 10 && j == 10 && k == 10 ? 0.7f : 100.0f; }));
  filter->SetRegionOfInterest(
    mmmtest::MakeImage<MaskImage>(20, 20, 20, [](int i, int j, int k) { return i == 4 && j == 9 && k == 9; }));
  filter->SetRegionMaximumSize(0.5);
  filter->SurfaceOnlyOn();
  filter->KeepIntermediatesOn();
  filter->Update();
  const auto * sizes = filter->GetComputedSizingImage();
  EXPECT_EQ(sizes->GetBufferedRegion().GetIndex(), (FloatImage::IndexType{ { -4, -4, -4 } }));
  EXPECT_EQ(sizes->GetBufferedRegion().GetSize(), (FloatImage::SizeType{ { 28, 28, 28 } }));
  EXPECT_FLOAT_EQ(sizes->GetPixel({ { 10, 10, 10 } }), 0.7f);
  EXPECT_FLOAT_EQ(sizes->GetPixel({ { 4, 9, 9 } }), 0.5f);
  EXPECT_GT(sizes->GetPixel({ { -4, -4, -4 } }), 2.0f);
}

TEST(ExteriorFilling, MeshedRegionIsTheImageOrTheBoxWithItsMargin)
{
  // the ball is 12 voxels wide, from 4 to 15
  const auto image = mmmtest::MakeBall<LabelImage>(20, 6.0);
  const auto filter = MakeFilter(image);
  filter->SurfaceOnlyOn();
  filter->FillExteriorOn();
  filter->Update();
  EXPECT_EQ(filter->GetMeshedRegion(), image->GetLargestPossibleRegion());
  filter->SetAirMargin(6.5);
  filter->Update();
  EXPECT_EQ(filter->GetMeshedRegion(), LabelImage::RegionType({ { -3, -3, -3 } }, { { 26, 26, 26 } }));
}

TEST(ExteriorFilling, ThrowsOnAMarginThatTakesMoreThanTheLimitOfMemory)
{
  const auto filter = MakeFilter(mmmtest::MakeBall<LabelImage>(20, 6.0));
  filter->SetAirMargin(2000.0);
  filter->SetMaximumMemory(4.0);
  mmmtest::ExpectException([&] { filter->Update(); }, "With an air margin of 2000 mm, the image has");
}

TEST(ExteriorFilling, ThrowsOnWhatContradicts)
{
  const auto image = mmmtest::MakeBall<LabelImage>(12, 4.0);
  const auto filter = MakeFilter(image);
  filter->SetAirMargin(-1.0);
  mmmtest::ExpectException([&] { filter->Update(); }, "The air margin is -1 mm. It must be finite and not negative");
  filter->SetAirMargin(1e9);
  mmmtest::ExpectException([&] { filter->Update(); }, "voxels wide, which is too much");
  filter->SetAirMargin(3.0);
  filter->SetExteriorLabels({});
  mmmtest::ExpectException([&] { filter->Update(); }, "The exterior is to be filled, but no label is exterior");
}

TEST(ExteriorFilling, AirMayHaveALabelBeyondTheRangeOfThePixels)
{
  const auto filter = MakeFilter(mmmtest::MakeBall<LabelImage>(12, 4.0));
  filter->SetAirMargin(3.0);
  filter->SetExteriorLabels({ 300 });
  filter->Update();
  EXPECT_EQ(filter->GetLabels(), (std::vector<int>{ 0, 1, 300 }));
}
