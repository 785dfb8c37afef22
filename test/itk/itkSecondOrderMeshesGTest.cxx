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

namespace
{
using LabelImage = itk::Image<short, 3>;
using FilterType = itk::LabelImageToTetrahedralMeshFilter<LabelImage>;

FilterType::Pointer
RunFilter(const LabelImage * image, unsigned int order = 2)
{
  const auto filter = FilterType::New();
  filter->SetInput(image);
  filter->SetElementOrder(order);
  filter->Update();
  return filter;
}
} // namespace

TEST(SecondOrderMeshes, FirstOrderHasNoMidNodes)
{
  const auto filter = RunFilter(mmmtest::MakeBall<LabelImage>(16, 5.0), 1);
  EXPECT_EQ(filter->GetMidNodes()->GetNumberOfPoints(), 0u);
  EXPECT_TRUE(filter->GetReport().curving.volumes.empty());
}

TEST(SecondOrderMeshes, AreTheSameForAnyNumberOfThreads)
{
  const auto               image = mmmtest::MakeHalves<LabelImage>(22, 7.5);
  std::vector<mmm::Vector> points;
  std::vector<mmm::Vector> middles;
  for (const itk::ThreadIdType threads : { 1, 3 })
  {
    const mmmtest::ThreadCount count(threads);
    const auto                 filter = RunFilter(image);
    if (points.empty())
    {
      points = mmmtest::PointsOf(filter->GetOutput());
      middles = mmmtest::PointsOf(filter->GetMidNodes());
      EXPECT_GT(middles.size(), 400u);
    }
    EXPECT_EQ(mmmtest::PointsOf(filter->GetOutput()), points);
    EXPECT_EQ(mmmtest::PointsOf(filter->GetMidNodes()), middles);
  }
}

TEST(SecondOrderMeshes, MidNodesAndVolumesFollowTheImage)
{
  const auto image = mmmtest::MakeHalves<LabelImage>(22, 7.5);
  const auto plain = RunFilter(image);
  mmmtest::SetObliqueGeometry(image.GetPointer(), 0.5, true);
  const auto oblique = RunFilter(image);
  const auto middles = mmmtest::PointsOf(oblique->GetMidNodes());
  const auto expected = mmmtest::PointsOf(plain->GetMidNodes());
  ASSERT_EQ(middles.size(), expected.size());
  for (std::size_t n = 0; n < middles.size(); ++n)
  {
    itk::ContinuousIndex<double, 3> index;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      index[axis] = expected[n][axis];
    }
    itk::Point<double, 3> place;
    image->TransformContinuousIndexToPhysicalPoint(index, place);
    EXPECT_LT((middles[n] - mmm::Vector(place.GetDataPointer())).norm(), 1e-6);
  }
  double unit = 1.0;
  for (const double spacing : image->GetSpacing())
  {
    unit *= spacing;
  }
  for (const auto & [label, volume] : plain->GetReport().curving.volumes)
  {
    EXPECT_NEAR(oblique->GetReport().curving.volumes.at(label), unit * volume, 1e-6 * unit * volume);
  }
}

TEST(SecondOrderMeshes, EndsAreSortedPointsOfTheSurface)
{
  const auto   filter = RunFilter(mmmtest::MakeHalves<LabelImage>(22, 7.5));
  const auto & ends = filter->GetMidNodes()->GetPointData()->CastToSTLConstContainer();
  const int    points = static_cast<int>(filter->GetSurface()->GetNumberOfPoints());
  for (std::size_t n = 0; n < ends.size(); ++n)
  {
    EXPECT_TRUE(0 <= ends[n][0] && ends[n][0] < ends[n][1] && ends[n][1] < points);
    EXPECT_TRUE(n == 0 || ends[n - 1][0] < ends[n][0] || (ends[n - 1][0] == ends[n][0] && ends[n - 1][1] < ends[n][1]));
  }
}

TEST(SecondOrderMeshes, OtherOrdersAreRefused)
{
  for (const unsigned int order : { 0u, 3u })
  {
    EXPECT_THROW(RunFilter(mmmtest::MakeBall<LabelImage>(12, 4.0), order), itk::ExceptionObject);
  }
}
