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
#include "itkLabelImageToTetrahedralMeshFilter.h"
#include "support/TestLabelImages.h"
#include "support/TestMeshes.h"

#include "itkTetrahedralMeshQualityCalculator.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace
{
using LabelImage = itk::Image<unsigned char, 3>;
using FloatImage = itk::Image<float, 3>;
using FilterType = itk::LabelImageToTetrahedralMeshFilter<LabelImage>;

constexpr int    Size = 40;
constexpr int    Slices = 8;
constexpr double Thickness = 5.0;

/** A ball of 15 mm in one of 18.5 mm, in slices of 5 mm, turned and away from the origin. */
LabelImage::Pointer
MakeBalls()
{
  const auto   image = mmmtest::MakeImage<LabelImage>(Size, Size, Slices, [](int i, int j, int k) {
    const double r = std::hypot(i - 19.5, j - 19.5, Thickness * (k - 3.5));
    return r < 15.0 ? 1 : r < 18.5 ? 2 : 0;
  });
  const double spacing[] = { 1.0, 1.0, Thickness };
  image->SetSpacing(spacing);
  LabelImage::DirectionType direction;
  direction.Fill(0.0);
  direction(1, 0) = 0.8;
  direction(2, 0) = 0.6;
  direction(0, 2) = -1.0;
  direction(1, 1) = -0.6;
  direction(2, 1) = 0.8;
  image->SetDirection(direction);
  const double origin[] = { 30.0, -200.0, 7.0 };
  image->SetOrigin(origin);
  return image;
}

FilterType::Pointer
MakeMesh(const LabelImage * image, bool keepSlices = false)
{
  const auto filter = FilterType::New();
  filter->SetInput(image);
  filter->SetKeepSlices(keepSlices);
  filter->KeepIntermediatesOn();
  filter->Update();
  return filter;
}

/** How far the points of the outer surface are from a sphere of 18.5 mm around the middle of the image, root mean
 * square. */
double
RoughnessOf(const LabelImage * image, FilterType * filter)
{
  itk::ContinuousIndex<double, 3> middle;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    middle[axis] = 0.5 * (static_cast<double>(image->GetLargestPossibleRegion().GetSize(axis)) - 1.0);
  }
  itk::Point<double, 3> centre;
  image->TransformContinuousIndexToPhysicalPoint(middle, centre);
  const auto   points = mmmtest::PointsOf(filter->GetSurface());
  const auto & sides = mmmtest::CellDataOf(filter->GetSurface());
  const auto   triangles = mmmtest::CellsOf<3>(filter->GetSurface());
  double       sum = 0.0;
  double       area = 0.0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (std::min(sides[t][0], sides[t][1]) == 0)
    {
      const double own = mmmtest::TriangleNormal(points, triangles[t]).norm();
      for (const auto corner : triangles[t])
      {
        sum += own * std::pow((points[corner] - mmm::Vector(centre[0], centre[1], centre[2])).norm() - 18.5, 2);
      }
      area += 3.0 * own;
    }
  }
  return std::sqrt(sum / area);
}

bool
SaysThatSlicesAreDivided(FilterType * filter)
{
  const auto & warnings = filter->GetReport().warnings;
  return std::any_of(warnings.begin(), warnings.end(), [](const std::string & text) {
    return text.find("Voxels of 1 x 1 x 5 mm are divided into 1 x 1 x 3") == 0;
  });
}
} // namespace

TEST(ThickSlices, BallsOfThemAreRound)
{
  const auto   image = MakeBalls();
  const double divided = RoughnessOf(image, MakeMesh(image));
  EXPECT_LT(divided, 0.6);
  EXPECT_LT(divided, 0.8 * RoughnessOf(image, MakeMesh(image, true)));
}

TEST(ThickSlices, MeshesOfThemHaveNoFlatTetrahedra)
{
  const auto filter = MakeMesh(MakeBalls());
  const auto calculator = itk::TetrahedralMeshQualityCalculator<FilterType::OutputMeshType>::New();
  calculator->SetMesh(filter->GetOutput());
  calculator->Compute();
  EXPECT_GT(calculator->GetReport().tetrahedra.smallestAngle.minimum, 15.0);
  EXPECT_EQ(calculator->GetReport().tetrahedra.nonPositive, 0u);
}

TEST(ThickSlices, VolumesAreThoseOfTheVoxels)
{
  const auto filter = MakeMesh(MakeBalls());
  for (const auto & [label, volume] : mmmtest::VolumesOf(filter->GetOutput()))
  {
    EXPECT_NEAR(volume / (Thickness * double(filter->GetIslandRecords().at(label).voxelsAfter)), 1.0, 0.03) << label;
  }
}

TEST(ThickSlices, WhatIsDoneIsSaid)
{
  const auto image = MakeBalls();
  EXPECT_TRUE(SaysThatSlicesAreDivided(MakeMesh(image)));
  EXPECT_FALSE(SaysThatSlicesAreDivided(MakeMesh(image, true)));
}

TEST(ThickSlices, ThinnerOnesThanFourVoxelsStay)
{
  const auto   image = MakeBalls();
  const double spacing[] = { 1.0, 1.0, 3.9 };
  image->SetSpacing(spacing);
  const auto filter = MakeMesh(image);
  EXPECT_EQ(filter->GetComputedSizingImage()->GetSpacing(), image->GetSpacing());
}

TEST(ThickSlices, KeptImagesAreDivided)
{
  const auto   image = MakeBalls();
  const auto   filter = MakeMesh(image);
  const auto * sizes = filter->GetComputedSizingImage();
  const auto & region = sizes->GetLargestPossibleRegion();
  EXPECT_EQ(region.GetSize(2), static_cast<itk::SizeValueType>(Slices * 3));
  EXPECT_DOUBLE_EQ(sizes->GetSpacing()[2], Thickness / 3.0);
  // the same corner of the box
  itk::ContinuousIndex<double, 3> corner;
  corner.Fill(-0.5);
  itk::Point<double, 3> expected;
  image->TransformContinuousIndexToPhysicalPoint(corner, expected);
  itk::Point<double, 3> found;
  sizes->TransformContinuousIndexToPhysicalPoint(corner, found);
  EXPECT_LT(found.EuclideanDistanceTo(expected), 1e-9);
  EXPECT_EQ(filter->GetMeshedRegion(), image->GetLargestPossibleRegion());
}

TEST(ThickSlices, IslandsCountInVoxelsOfTheImage)
{
  const auto image = MakeBalls();
  for (const int i : { 1, 2, 3 })
  {
    image->SetPixel({ { i, 1, 4 } }, 7);
  }
  for (int i = 2; i < 12; ++i)
  {
    image->SetPixel({ { i, 38, 4 } }, 2);
  }
  image->SetPixel({ { 20, 20, 4 } }, 2);
  const auto   filter = MakeMesh(image);
  const auto & records = filter->GetIslandRecords();
  EXPECT_EQ(records.at(2).components, 1u);
  EXPECT_EQ(records.at(2).voxels, 1u);
  EXPECT_EQ(records.at(2).voxelsAfter + 1, records.at(2).voxelsBefore);
  EXPECT_EQ(records.at(7).voxelsAfter, 3u); // a label's largest part stays
}

TEST(ThickSlices, AllExteriorLabelsAreFound)
{
  const auto image = MakeBalls();
  image->SetPixel({ { 0, 0, 0 } }, 9);
  const auto filter = FilterType::New();
  filter->SetInput(image);
  filter->SetExteriorLabels({ 0, 8, 9 });
  filter->Update();
  EXPECT_EQ(filter->GetAbsentExteriorLabels(), std::vector<int>{ 8 });
}

TEST(ThickSlices, SizesOnTheGridOfTheImageAreTaken)
{
  const auto image = MakeBalls();
  const auto sizes =
    mmmtest::MakeImage<FloatImage>(Size, Size, Slices, [](int, int, int k) { return k < Slices / 2 ? 1.5F : 100.0F; });
  sizes->CopyInformation(image);
  const auto filter = FilterType::New();
  filter->SetInput(image);
  filter->SetSizingImage(sizes);
  filter->KeepIntermediatesOn();
  filter->Update();
  const auto * result = filter->GetComputedSizingImage();
  EXPECT_LE(result->GetPixel({ { 20, 20, 10 } }), 1.5F);
  EXPECT_GT(result->GetPixel({ { 20, 20, 15 } }), 1.5F);
}

TEST(ThickSlices, IntensitiesAreRefusedAsEver)
{
  const auto image = mmmtest::MakeImage<LabelImage>(
    30, 30, 6, [](int i, int j, int k) { return (37 * i + 101 * j + 17 * k + i * j * 13) % 251; });
  const double spacing[] = { 1.0, 1.0, Thickness };
  image->SetSpacing(spacing);
  const auto filter = FilterType::New();
  filter->SetInput(image);
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
}
