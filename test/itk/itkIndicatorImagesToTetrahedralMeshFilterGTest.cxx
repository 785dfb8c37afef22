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
#include "itkIndicatorImagesToTetrahedralMeshFilter.h"
#include "support/TestLabelImages.h"
#include "support/TestMeshes.h"

#include "itkImageRegionConstIteratorWithIndex.h"

#include <cmath>
#include <functional>
#include <limits>

namespace
{
using FunctionImage = itk::Image<float, 3>;
using FilterType = itk::IndicatorImagesToTetrahedralMeshFilter<FunctionImage>;
using PartitionType = itk::IndicatorImagesToLabelImageFilter<FunctionImage>;

constexpr int    Size = 28;
constexpr double Radius = 9.3;

/** The distance to the sphere around a place between the voxels, positive inside. */
double
BallDistance(int i, int j, int k)
{
  return Radius - std::hypot(i - 13.3, j - 13.6, k - 13.45);
}

/** The probability of what is at a distance from an interface that is blurred over about two voxels. */
double
Probability(double distance)
{
  return 1.0 / (1.0 + std::exp(-2.0 * distance));
}

FunctionImage::Pointer
MakeBall(const std::function<double(double)> & function)
{
  return mmmtest::MakeImage<FunctionImage>(
    Size, Size, Size, [&](int i, int j, int k) { return function(BallDistance(i, j, k)); });
}

FilterType::Pointer
RunFilter(const std::vector<FunctionImage::Pointer> & images)
{
  const auto filter = FilterType::New();
  for (std::size_t n = 0; n < images.size(); ++n)
  {
    filter->SetInput(static_cast<unsigned int>(n), images[n]);
  }
  filter->Update();
  return filter;
}

/** The root mean square of the distances of particles, which lie on the interface, to the sphere. */
template <typename TMesh>
double
DeviationFromSphere(const TMesh * particles)
{
  double     sum = 0.0;
  const auto points = mmmtest::PointsOf(particles);
  for (const auto & p : points)
  {
    sum += std::pow(std::hypot(p[0] - 13.3, p[1] - 13.6, p[2] - 13.45) - Radius, 2);
  }
  return std::sqrt(sum / points.size());
}

const double SphereVolume = 4.0 / 3.0 * itk::Math::pi * std::pow(Radius, 3);

/** Three maps that add up to one: the halves of the ball, and what is around it. */
std::vector<FunctionImage::Pointer>
MakeHalves()
{
  const auto upper = [](int k) { return Probability(k - 13.2); };
  return {
    mmmtest::MakeImage<FunctionImage>(
      Size, Size, Size, [&](int i, int j, int k) { return Probability(BallDistance(i, j, k)) * (1.0 - upper(k)); }),
    mmmtest::MakeImage<FunctionImage>(
      Size, Size, Size, [&](int i, int j, int k) { return Probability(BallDistance(i, j, k)) * upper(k); }),
    mmmtest::MakeImage<FunctionImage>(
      Size, Size, Size, [&](int i, int j, int k) { return 1.0 - Probability(BallDistance(i, j, k)); })
  };
}

PartitionType::Pointer
MakePartition(const std::vector<FunctionImage::Pointer> & images)
{
  const auto filter = PartitionType::New();
  for (std::size_t n = 0; n < images.size(); ++n)
  {
    filter->SetInput(static_cast<unsigned int>(n), images[n]);
  }
  return filter;
}

void
ExpectUpdateException(const PartitionType::Pointer & filter, const std::string & words)
{
  mmmtest::ExpectException([&] { filter->Update(); }, words);
}
} // namespace

TEST(IndicatorImagesToTetrahedralMeshFilter, SphereOfAProbabilityMapIsWhereTheMapIsOneHalf)
{
  const auto filter = RunFilter({ MakeBall(Probability) });
  EXPECT_NEAR(mmmtest::VolumesOf(filter->GetOutput()).at(1), SphereVolume, 0.01 * SphereVolume);
  EXPECT_LT(DeviationFromSphere(filter->GetParticles()), 0.05);
}

TEST(IndicatorImagesToTetrahedralMeshFilter, IsCloserToTheSphereThanItsLabels)
{
  using LabelImage = itk::Image<unsigned char, 3>;
  const auto labels = itk::LabelImageToTetrahedralMeshFilter<LabelImage>::New();
  labels->SetInput(mmmtest::MakeImage<LabelImage>(
    Size, Size, Size, [](int i, int j, int k) { return BallDistance(i, j, k) > 0.0 ? 1 : 0; }));
  labels->Update();
  const auto filter = RunFilter({ MakeBall(Probability) });
  EXPECT_LT(DeviationFromSphere(filter->GetParticles()), 0.5 * DeviationFromSphere(labels->GetParticles()));
}

TEST(IndicatorImagesToTetrahedralMeshFilter, UnitOfTheFunctionDoesNotMatter)
{
  const auto distance = RunFilter({ MakeBall([](double d) { return d; }) });
  const auto scaled = RunFilter({ MakeBall([](double d) { return 1024.0 * d; }) });
  EXPECT_EQ(mmmtest::PointsOf(scaled->GetOutput()), mmmtest::PointsOf(distance->GetOutput()));
  EXPECT_LT(DeviationFromSphere(distance->GetParticles()), 0.05);
}

TEST(IndicatorImagesToTetrahedralMeshFilter, ExteriorMapGivesTheSameAsWhatTheOthersLeave)
{
  auto       maps = MakeHalves();
  const auto whole = FilterType::New();
  for (unsigned int n = 0; n < 3; ++n)
  {
    whole->SetInput(n, maps[n]);
  }
  whole->SetIndicatorLabels({ 5, 7, 0 });
  whole->Update();
  maps.pop_back();
  const auto open = RunFilter(maps);
  EXPECT_EQ(whole->GetLabels(), (std::vector<int>{ 0, 5, 7 }));
  EXPECT_EQ(open->GetLabels(), (std::vector<int>{ 0, 1, 2 }));
  for (auto * filter : { whole.GetPointer(), open.GetPointer() })
  {
    const auto volumes = mmmtest::VolumesOf(filter->GetOutput());
    // beside the cut each half has less than the exterior already within the ball
    EXPECT_NEAR(volumes.begin()->second + volumes.rbegin()->second, SphereVolume, 0.02 * SphereVolume);
    // the cut is 0.25 below the centre
    const double below = itk::Math::pi * Radius * Radius * 0.25;
    EXPECT_NEAR(volumes.rbegin()->second - volumes.begin()->second, 2.0 * below, 0.35 * below);
  }
}

TEST(IndicatorImagesToTetrahedralMeshFilter, WithoutExteriorTheBoxIsFull)
{
  const auto filter = FilterType::New();
  const auto maps = MakeHalves();
  for (unsigned int n = 0; n < 3; ++n)
  {
    filter->SetInput(n, maps[n]);
  }
  filter->SetExteriorLabels({});
  filter->Update();
  double sum = 0.0;
  for (const auto & entry : mmmtest::VolumesOf(filter->GetOutput()))
  {
    sum += entry.second;
  }
  EXPECT_NEAR(sum, std::pow(Size, 3), 1e-6);
}

TEST(IndicatorImagesToTetrahedralMeshFilter, InterfacesAreClosed)
{
  for (const auto & open : mmmtest::OpenEdges(RunFilter(MakeHalves())->GetSurface()))
  {
    EXPECT_EQ(open.second, 0u) << open.first;
  }
}

TEST(IndicatorImagesToTetrahedralMeshFilter, IndicatorOfALayerOfOneVoxelIsTheDistanceToItsNearerSide)
{
  const auto layer = [](double d) { return std::min(d, 1.0 - d); };
  const auto filter = FilterType::New();
  filter->SetInput(0, MakeBall([](double d) { return d - 1.0; }));
  filter->SetInput(1, MakeBall(layer));
  filter->SetSurfaceOnly(true);
  filter->KeepIntermediatesOn();
  filter->Update();
  double      squares = 0.0;
  std::size_t count = 0;
  const auto  image = filter->GetIndicatorImage(2);
  for (itk::ImageRegionConstIteratorWithIndex<FunctionImage> it(image, image->GetBufferedRegion()); !it.IsAtEnd(); ++it)
  {
    const auto & at = it.GetIndex();
    const double distance = layer(BallDistance(int(at[0]), int(at[1]), int(at[2])));
    if (distance > -0.5)
    {
      // but the interface stays away from the voxels' centres
      squares += std::pow(it.Get() - std::copysign(std::max(std::abs(distance), 0.2), distance), 2);
      ++count;
    }
  }
  EXPECT_LT(std::sqrt(squares / count), 0.07);
}

TEST(IndicatorImagesToTetrahedralMeshFilter, IslandsAreMerged)
{
  const auto map = MakeBall(Probability);
  map->SetPixel({ { 2, 2, 2 } }, 0.9f);
  const auto filter = RunFilter({ map });
  EXPECT_EQ(filter->GetIslandRecords().at(1).voxels, 1u);
  EXPECT_LT(DeviationFromSphere(filter->GetParticles()), 0.05);
}

TEST(IndicatorImagesToTetrahedralMeshFilter, MeshFollowsTheImagesGeometry)
{
  const auto plain = RunFilter({ MakeBall(Probability) });
  const auto map = MakeBall(Probability);
  mmmtest::SetObliqueGeometry(map.GetPointer(), 1.0, false);
  const auto oblique = RunFilter({ map });
  const auto expected = mmmtest::PointsOf(plain->GetOutput());
  const auto points = mmmtest::PointsOf(oblique->GetOutput());
  ASSERT_EQ(points.size(), expected.size());
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    itk::ContinuousIndex<double, 3> index;
    for (unsigned int a = 0; a < 3; ++a)
    {
      index[a] = expected[p][a];
    }
    FunctionImage::PointType place;
    map->TransformContinuousIndexToPhysicalPoint(index, place);
    for (unsigned int a = 0; a < 3; ++a)
    {
      ASSERT_NEAR(points[p][a], place[a], 1e-9);
    }
  }
}

TEST(IndicatorImagesToTetrahedralMeshFilter, RejectsAnAirMarginAsMapsEndAtTheirImages)
{
  const auto filter = itk::IndicatorImagesToTetrahedralMeshFilter<FunctionImage>::New();
  filter->SetInput(0, MakeBall(Probability));
  filter->SetAirMargin(3.0);
  mmmtest::ExpectException([&] { filter->Update(); }, "An air margin of 3 mm");
}

TEST(IndicatorImagesToTetrahedralMeshFilter, NumberOfThreadsDoesNotMatter)
{
  std::vector<mmm::Vector> expected;
  for (const itk::ThreadIdType threads : { 1, 3 })
  {
    const mmmtest::ThreadCount count(threads);
    const auto                 points = mmmtest::PointsOf(RunFilter(MakeHalves())->GetOutput());
    if (threads == 1)
    {
      expected = points;
    }
    EXPECT_EQ(points, expected);
  }
}

TEST(IndicatorImagesToTetrahedralMeshFilter, RunsAgainWhenAnImageChanges)
{
  const auto map = MakeBall(Probability);
  const auto filter = RunFilter({ map });
  const auto first = mmmtest::VolumesOf(filter->GetOutput()).at(1);
  filter->SetInput(0, MakeBall([](double d) { return Probability(d - 1.0); }));
  filter->Update();
  EXPECT_LT(mmmtest::VolumesOf(filter->GetOutput()).at(1), 0.8 * first);
}

TEST(IndicatorImagesToLabelImageFilter, TakesTheLargest)
{
  const auto filter = MakePartition(MakeHalves());
  filter->SetIndicatorLabels({ 4, 6, 0 });
  filter->Update();
  for (const auto & [k, label] : std::map<int, int>{ { 1, 0 }, { 9, 4 }, { 20, 6 } })
  {
    EXPECT_EQ(filter->GetOutput()->GetPixel({ { 13, 13, k } }), label);
  }
}

TEST(IndicatorImagesToLabelImageFilter, ExteriorComesFirstWhereAllAreEqual)
{
  const auto tissue = MakeBall([](double d) { return d > 0.0 ? 1.0 : 0.0; });
  const auto air = MakeBall([](double d) { return d < -3.0 ? 1.0 : 0.0; });
  const auto filter = MakePartition({ tissue, air });
  filter->SetIndicatorLabels({ 1, 0 });
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPixel({ { 13, 13, 3 } }), 0);
  EXPECT_EQ(filter->GetOutput()->GetPixel({ { 13, 13, 13 } }), 1);
}

TEST(IndicatorImagesToLabelImageFilter, InterpolatedProbabilitiesMayBeNegative)
{
  const auto filter = MakePartition({ MakeBall([](double d) { return 1.2 * Probability(d) - 0.1; }) });
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPixel({ { 0, 0, 0 } }), 0);
}

TEST(IndicatorImagesToLabelImageFilter, RejectsOtherUnitsWhereTheExteriorIsWhatTheyLeave)
{
  const auto percent = MakeBall([](double d) { return 100.0 * Probability(d); });
  ExpectUpdateException(MakePartition({ percent }), "they have to be probabilities from 0 to 1");
}

TEST(IndicatorImagesToLabelImageFilter, RejectsValuesThatAreNoNumbers)
{
  const auto map = MakeBall(Probability);
  map->SetPixel({ { 3, 4, 5 } }, std::numeric_limits<float>::quiet_NaN());
  map->SetObjectName("gm.nii");
  ExpectUpdateException(MakePartition({ map }), "Indicator image 1 (gm.nii) has the value nan at the index [3, 4, 5]");
}

TEST(IndicatorImagesToLabelImageFilter, RejectsAnImageThatIsTheSameEverywhere)
{
  const auto zero = MakeBall([](double) { return 0.0; });
  ExpectUpdateException(MakePartition({ MakeBall(Probability), zero }), "image 2 has the value 0 everywhere");
}

TEST(IndicatorImagesToLabelImageFilter, RejectsAnotherGrid)
{
  const auto other = mmmtest::MakeImage<FunctionImage>(Size, Size, Size - 1, [](int i, int, int) { return i / 99.0; });
  ExpectUpdateException(MakePartition({ MakeBall(Probability), other }), "They must be on the same grid");
  const auto moved = MakeBall(Probability);
  mmmtest::SetObliqueGeometry(moved.GetPointer(), 1.0, false);
  ExpectUpdateException(MakePartition({ MakeBall(Probability), moved }), "differs from the first one in origin");
}

TEST(IndicatorImagesToLabelImageFilter, RejectsLabelsThatDoNotFit)
{
  const auto map = MakeBall(Probability);
  auto       filter = MakePartition({ map, map });
  filter->SetIndicatorLabels({ 1, 2, 3 });
  ExpectUpdateException(filter, "There are 3 labels for 2 indicator images");
  filter->SetIndicatorLabels({ 3, 3 });
  ExpectUpdateException(filter, "The label 3 is given to more than one");
  filter->SetIndicatorLabels({ 0, 5 });
  filter->SetExteriorLabels({ 0, 5 });
  ExpectUpdateException(filter, "there is nothing to mesh");
  filter = MakePartition({ map });
  filter->SetExteriorLabels({});
  ExpectUpdateException(filter, "nothing borders on anything");
}
