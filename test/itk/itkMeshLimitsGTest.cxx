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
// What is expected of a mesh before it is made, and limits on it.
#include "itkLabelImageToTetrahedralMeshFilter.h"
#include "support/TestLabelImages.h"
#include "support/TestMeshes.h"

#include <limits>
#include <set>
#include <string>
#include <utility>

namespace
{
using LabelImage = itk::Image<unsigned char, 3>;
using FilterType = itk::LabelImageToTetrahedralMeshFilter<LabelImage>;

FilterType::Pointer
MakeFilter(const LabelImage * image)
{
  const auto filter = FilterType::New();
  filter->SetInput(image);
  return filter;
}

LabelImage::Pointer
MakeScaledHalves(double unit)
{
  const auto              image = mmmtest::MakeHalves<LabelImage>(28, 11.0);
  LabelImage::SpacingType spacing;
  spacing.Fill(unit);
  image->SetSpacing(spacing);
  return image;
}

/** The smallest size that the filter proposes when it refuses a mesh. */
double
ProposedSize(FilterType * filter)
{
  try
  {
    filter->Update();
  }
  catch (const itk::ExceptionObject & error)
  {
    const std::string words = error.GetDescription();
    const std::string before = "A smallest size of ";
    const auto        place = words.find(before);
    EXPECT_NE(place, std::string::npos) << words;
    return place == std::string::npos ? 0.0 : std::stod(words.substr(place + before.size()));
  }
  ADD_FAILURE() << "no exception";
  return 0.0;
}
} // namespace

TEST(MeshLimits, ExpectationIsNearTheMesh)
{
  const auto filter = MakeFilter(MakeScaledHalves(1.0));
  for (const double size : { 1.5, 3.0 })
  {
    filter->SetMaximumSize(size);
    filter->Update();
    const auto & estimate = filter->GetReport().estimate;
    const auto   tetrahedra = static_cast<double>(filter->GetOutput()->GetNumberOfCells());
    const auto   points = static_cast<double>(filter->GetOutput()->GetNumberOfPoints());
    const auto   triangles = static_cast<double>(filter->GetSurface()->GetNumberOfCells());
    EXPECT_NEAR(estimate.tetrahedra, tetrahedra, 0.3 * tetrahedra) << size;
    EXPECT_NEAR(estimate.points, points, 0.4 * points) << size;
    EXPECT_NEAR(estimate.triangles, triangles, 0.3 * triangles) << size;
  }
}

TEST(MeshLimits, EdgesAreOnAverageAsLongAsTheMaximum)
{
  constexpr double size = 2.0;
  const auto       filter = MakeFilter(MakeScaledHalves(1.0));
  filter->SetMinimumSize(size);
  filter->SetMaximumSize(size);
  filter->Update();
  const auto                                    points = mmmtest::PointsOf(filter->GetOutput());
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (const auto & c : mmmtest::CellsOf<4>(filter->GetOutput()))
  {
    for (int a = 0; a < 4; ++a)
    {
      for (int b = 0; b < a; ++b)
      {
        edges.insert(std::minmax<std::size_t>(c[a], c[b]));
      }
    }
  }
  double      sum = 0.0;
  std::size_t tooLong = 0;
  for (const auto & edge : edges)
  {
    const double length = (points[edge.first] - points[edge.second]).norm();
    sum += length;
    tooLong += length > 1.4 * size;
  }
  const auto count = static_cast<double>(edges.size());
  EXPECT_NEAR(sum / count, size, 0.08 * size);
  EXPECT_LT(static_cast<double>(tooLong), 0.05 * count);
}

TEST(MeshLimits, ExpectationIsKnownToObserversBeforeTheLongStages)
{
  const auto filter = MakeFilter(MakeScaledHalves(1.0));
  filter->SurfaceOnlyOn();
  double expected = 0.0;
  filter->AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) {
    if (filter->GetCurrentStage() == "seeding of particles")
    {
      expected = filter->GetReport().estimate.triangles;
    }
  });
  filter->Update();
  EXPECT_GT(expected, 0.0);
  EXPECT_EQ(filter->GetReport().estimate.triangles, expected);
}

TEST(MeshLimits, TooManyTetrahedraAreRefusedBeforeTheLongStages)
{
  const auto filter = MakeFilter(MakeScaledHalves(1.0));
  filter->SetMaximumSize(1.5);
  filter->SetMaximumNumberOfTetrahedra(2000);
  mmmtest::ExpectException([&] { filter->Update(); }, "more than the limit of 2000 tetrahedra");
  EXPECT_EQ(filter->GetCurrentStage(), "preparation");
  EXPECT_GT(filter->GetReport().estimate.tetrahedra, 2000.0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0u);
}

TEST(MeshLimits, SizeThatIsProposedIsInMillimetersAndAccepted)
{
  double first = 0.0;
  for (const double unit : { 1.0, 0.01 })
  {
    const auto filter = MakeFilter(MakeScaledHalves(unit));
    filter->SetMaximumNumberOfTetrahedra(3000);
    filter->SetMaximumSize(1.5 * unit);
    const double size = ProposedSize(filter);
    first = first > 0.0 ? first : size;
    EXPECT_NEAR(size, first * unit, 1e-9);
    filter->SetMaximumSize(std::numeric_limits<double>::infinity());
    filter->SetMinimumSize(size);
    EXPECT_NO_THROW(filter->Update());
  }
}

TEST(MeshLimits, TooMuchMemoryIsRefused)
{
  const auto filter = MakeFilter(MakeScaledHalves(1.0));
  filter->SetMaximumMemory(1e-3);
  mmmtest::ExpectException([&] { filter->Update(); }, "more than the limit of 0.001 GB. No smallest size is expected");
  filter->SetMaximumMemory(0.0);
  mmmtest::ExpectException([&] { filter->Update(); }, "The largest memory is 0 GB. It must be positive");
}

TEST(MeshLimits, NoTetrahedronExceedsTheLargestVolume)
{
  const auto filter = MakeFilter(MakeScaledHalves(2.0));
  filter->SetMaximumVolume(20.0);
  filter->Update();
  const auto points = mmmtest::PointsOf(filter->GetOutput());
  double     largest = 0.0;
  for (const auto & c : mmmtest::CellsOf<4>(filter->GetOutput()))
  {
    largest = std::max(largest, mmm::TetrahedronVolume(points[c[0]], points[c[1]], points[c[2]], points[c[3]]));
  }
  EXPECT_LE(largest, 20.0);
  EXPECT_GT(largest, 10.0);
}
