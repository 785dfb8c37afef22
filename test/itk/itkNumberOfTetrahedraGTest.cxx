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
// Meshes with as many tetrahedra as are asked for.
#include "itkLabelImageToTetrahedralMeshFilter.h"
#include "itkTetrahedralMeshQualityCalculator.h"
#include "support/TestLabelImages.h"
#include "support/TestMeshes.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{
using LabelImage = itk::Image<unsigned char, 3>;
using FilterType = itk::LabelImageToTetrahedralMeshFilter<LabelImage>;
using Calculator = itk::TetrahedralMeshQualityCalculator<FilterType::OutputMeshType>;

constexpr double Ball = 11.0;

/** A ball of two halves. */
FilterType::Pointer
MakeFilter(std::size_t number)
{
  const auto filter = FilterType::New();
  filter->SetInput(mmmtest::MakeHalves<LabelImage>(28, Ball));
  filter->SetMaximumSize(2.0);
  filter->SetNumberOfTetrahedra(number);
  filter->CompareTopologyOn();
  return filter;
}

double
NumberIn(FilterType * filter)
{
  filter->Update();
  return static_cast<double>(filter->GetOutput()->GetNumberOfCells());
}

mmm::MeshQualityReport
QualityOf(FilterType * filter)
{
  const auto calculator = Calculator::New();
  calculator->SetMesh(filter->GetOutput());
  calculator->Compute();
  return calculator->GetReport();
}
} // namespace

TEST(NumberOfTetrahedra, IsTheNumberThatIsAskedFor)
{
  const double usual = NumberIn(MakeFilter(0));
  for (const double share : { 0.5, 3.0 })
  {
    const double wanted = std::round(share * usual);
    EXPECT_NEAR(NumberIn(MakeFilter(static_cast<std::size_t>(wanted))), wanted, 0.05 * wanted) << share;
  }
}

TEST(NumberOfTetrahedra, FewerKeepVolumesConnectionsAndAngles)
{
  const auto filter = MakeFilter(3000);
  filter->Update();
  const auto & topology = filter->GetReport().topology;
  ASSERT_EQ(topology.labels.size(), 2u);
  for (const auto & label : topology.labels)
  {
    EXPECT_EQ(label.mesh, label.partition) << label.label;
  }
  const auto   quality = QualityOf(filter);
  const double half = 2.0 / 3.0 * itk::Math::pi * Ball * Ball * Ball;
  ASSERT_EQ(quality.labels.size(), 2u);
  for (const auto & label : quality.labels)
  {
    EXPECT_NEAR(label.tetrahedra.volume, half, 0.03 * half) << label.label;
  }
  EXPECT_GE(quality.tetrahedra.smallestAngle.minimum, 15.0);
}

TEST(NumberOfTetrahedra, TooFewAreAWarningAndLoseNoLabel)
{
  const auto filter = MakeFilter(2);
  EXPECT_GT(NumberIn(filter), 2.0);
  EXPECT_EQ(QualityOf(filter).labels.size(), 2u);
  const auto & warnings = filter->GetReport().warnings;
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const std::string & warning) {
    return warning.find("2 tetrahedra were asked for") == 0;
  }));
}

TEST(NumberOfTetrahedra, SameForAnyNumberOfThreads)
{
  std::vector<mmm::Vector> first;
  for (const itk::ThreadIdType threads : { 1, 3 })
  {
    const mmmtest::ThreadCount count(threads);
    const auto                 filter = MakeFilter(3000);
    filter->Update();
    const auto points = mmmtest::PointsOf(filter->GetOutput());
    first = first.empty() ? points : first;
    EXPECT_EQ(points, first) << threads;
  }
}

TEST(NumberOfTetrahedra, NoneOfASurfaceAlone)
{
  const auto filter = MakeFilter(1000);
  filter->SurfaceOnlyOn();
  mmmtest::ExpectException([&] { filter->Update(); }, "1000 tetrahedra are asked for, and the surface only");
}

TEST(NumberOfTetrahedra, DoesNotGoWithALargestVolume)
{
  const auto filter = MakeFilter(1000);
  filter->SetMaximumVolume(1.0);
  mmmtest::ExpectException([&] { filter->Update(); }, "1000 tetrahedra are asked for, and none above 1 mm^3");
}
