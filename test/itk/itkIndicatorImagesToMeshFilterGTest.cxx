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
#include "itkIndicatorImagesToMeshFilter.h"
#include "itkIndicatorImagesToSizingImageFilter.h"
#include "itkLabelImageToIndicatorImagesFilter.h"
#include "support/TestLabelImages.h"
#include "support/TestMeshes.h"

#include <cmath>
#include <numeric>

namespace
{
using LabelImage = itk::Image<short, 3>;
using IndicatorImage = itk::Image<float, 3>;
using FilterType = itk::IndicatorImagesToMeshFilter<IndicatorImage>;

/** The inputs of the filter, made by the filters before it. */
struct Inputs
{
  std::vector<IndicatorImage::Pointer> indicators;
  std::vector<int>                     labels;
  IndicatorImage::Pointer              sizes;
};

Inputs
MakeInputs(const LabelImage * labels, int exterior)
{
  const auto indicatorFilter = itk::LabelImageToIndicatorImagesFilter<LabelImage>::New();
  indicatorFilter->SetInput(labels);
  indicatorFilter->Update();
  Inputs inputs;
  inputs.labels = indicatorFilter->GetLabels();
  const auto sizingFilter = itk::IndicatorImagesToSizingImageFilter<IndicatorImage>::New();
  for (unsigned int n = 0; n < inputs.labels.size(); ++n)
  {
    inputs.indicators.emplace_back(indicatorFilter->GetOutput(n));
    inputs.indicators.back()->DisconnectPipeline();
    sizingFilter->SetInput(n, inputs.indicators[n]);
  }
  sizingFilter->SetExteriorIndex(exterior);
  sizingFilter->Update();
  inputs.sizes = sizingFilter->GetOutput();
  inputs.sizes->DisconnectPipeline();
  return inputs;
}

FilterType::Pointer
MakeFilter(const Inputs & inputs, int exterior)
{
  const auto filter = FilterType::New();
  for (unsigned int n = 0; n < inputs.indicators.size(); ++n)
  {
    filter->SetInput(n, inputs.indicators[n]);
  }
  filter->SetLabels(inputs.labels);
  filter->SetSizingImage(inputs.sizes);
  filter->SetExteriorIndex(exterior);
  return filter;
}

/** Labels 0, 3 and 7: two halves of a ball that meet, in exterior. */
const Inputs &
HalvesInputs()
{
  static const Inputs inputs = MakeInputs(mmmtest::MakeHalves<LabelImage>(24, 8.0, 3, 7), 0);
  return inputs;
}

std::set<std::array<int, 2>>
PairsOf(const itk::LabelInterfaceMesh * surface)
{
  std::set<std::array<int, 2>> pairs;
  for (const auto & sides : mmmtest::CellDataOf(surface))
  {
    pairs.insert({ { sides[0], sides[1] } });
  }
  return pairs;
}
} // namespace

TEST(IndicatorImagesToMeshFilter, MeshesTheMaterialsAndTheirInterfaces)
{
  const auto filter = MakeFilter(HalvesInputs(), 0);
  filter->Update();
  const auto   volumes = mmmtest::VolumesOf(filter->GetOutput());
  const double half = 2.0 / 3.0 * itk::Math::pi * 8.0 * 8.0 * 8.0;
  ASSERT_EQ(volumes.size(), 2u);
  EXPECT_NEAR(volumes.at(3), half, 0.06 * half);
  EXPECT_NEAR(volumes.at(7), half, 0.06 * half);
  EXPECT_EQ(PairsOf(filter->GetSurface()), (std::set<std::array<int, 2>>{ { 0, 3 }, { 0, 7 }, { 3, 7 } }));
  EXPECT_EQ(filter->GetUsedOutsideLabel(), 0);
  EXPECT_GT(filter->GetReport().particles[1], 10u);
}

TEST(IndicatorImagesToMeshFilter, NormalsPointFromTheFirstLabelToTheSecond)
{
  const auto filter = MakeFilter(HalvesInputs(), 0);
  filter->Update();
  const auto points = mmmtest::PointsOf(filter->GetSurface());
  const auto cells = mmmtest::CellsOf<3>(filter->GetSurface());
  const auto sides = mmmtest::CellDataOf(filter->GetSurface());
  double     area = 0.0;
  double     outwards = 0.0;
  double     upwards = 0.0;
  double     cut = 0.0;
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    const mmm::Vector normal = mmmtest::TriangleNormal(points, cells[c]);
    if (sides[c][0] == 0)
    {
      // from outside into the ball
      const mmm::Vector center =
        (points[cells[c][0]] + points[cells[c][1]] + points[cells[c][2]]) / 3.0 - mmm::Vector::Constant(11.5);
      area += normal.norm();
      outwards += normal.dot(center.normalized());
    }
    else
    {
      cut += normal.norm();
      upwards += normal[2];
    }
  }
  EXPECT_LT(outwards, -0.9 * area);
  EXPECT_GT(upwards, 0.9 * cut);
}

TEST(IndicatorImagesToMeshFilter, SurfacePointsAreTheFirstOfTheMesh)
{
  const auto filter = MakeFilter(HalvesInputs(), 0);
  filter->Update();
  const auto points = mmmtest::PointsOf(filter->GetOutput());
  const auto surface = mmmtest::PointsOf(filter->GetSurface());
  const auto particles = mmmtest::PointsOf(filter->GetParticles());
  ASSERT_GT(points.size(), surface.size());
  ASSERT_EQ(surface.size(), particles.size());
  for (std::size_t p = 0; p < surface.size(); ++p)
  {
    ASSERT_EQ(points[p], surface[p]);
    // points of curved surfaces leave the particles' places for the sake of the volumes
    for (int axis = 0; axis < 3; ++axis)
    {
      ASSERT_NEAR(points[p][axis], particles[p][axis], 0.6);
    }
  }
  std::set<std::size_t> used;
  for (const auto & corners : mmmtest::CellsOf<3>(filter->GetSurface()))
  {
    used.insert(corners.begin(), corners.end());
  }
  EXPECT_EQ(used.size(), surface.size());
  EXPECT_EQ(*used.rbegin(), surface.size() - 1);
}

TEST(IndicatorImagesToMeshFilter, SurfaceIsThatOfTheTetrahedra)
{
  const auto filter = MakeFilter(HalvesInputs(), 0);
  filter->Update();
  const auto &                                             labels = mmmtest::CellDataOf(filter->GetOutput());
  std::map<std::array<std::size_t, 3>, std::array<int, 2>> expected;
  for (const auto & face : mmmtest::FacesOf(filter->GetOutput()))
  {
    const int a = labels[face.second.front()];
    const int b = face.second.size() > 1 ? labels[face.second.back()] : 0;
    if (a != b)
    {
      expected[face.first] = { { std::min(a, b), std::max(a, b) } };
    }
  }
  std::map<std::array<std::size_t, 3>, std::array<int, 2>> found;
  const auto                                               cells = mmmtest::CellsOf<3>(filter->GetSurface());
  const auto &                                             sides = mmmtest::CellDataOf(filter->GetSurface());
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    auto corners = cells[c];
    std::sort(corners.begin(), corners.end());
    found[corners] = { { sides[c][0], sides[c][1] } };
  }
  EXPECT_EQ(found, expected);
  EXPECT_EQ(found.size(), cells.size());
}

TEST(IndicatorImagesToMeshFilter, ParticlesTellWhichLabelsMeet)
{
  const auto filter = MakeFilter(HalvesInputs(), 0);
  filter->Update();
  const auto *                      data = filter->GetParticles()->GetPointData();
  std::map<std::array<int, 5>, int> counts;
  for (auto it = data->Begin(); it != data->End(); ++it)
  {
    const auto & value = it.Value();
    ++counts[{ { value[0], value[1], value[2], value[3], value[4] } }];
  }
  EXPECT_EQ(counts.size(), 4u);
  EXPECT_GT((counts[{ { 2, 0, 3, 3, 3 } }]), 0);
  EXPECT_GT((counts[{ { 2, 0, 7, 7, 7 } }]), 0);
  EXPECT_GT((counts[{ { 2, 3, 7, 7, 7 } }]), 0);
  EXPECT_GT((counts[{ { 1, 0, 3, 7, 7 } }]), 0);
}

TEST(IndicatorImagesToMeshFilter, JunctionsAreLinesThatFollowEachOther)
{
  const auto filter = MakeFilter(HalvesInputs(), 0);
  filter->Update();
  const auto * junctions = filter->GetJunctions();
  const auto   lines = mmmtest::CellsOf<2>(junctions);
  const auto & data = mmmtest::CellDataOf(junctions);
  ASSERT_GT(lines.size(), 10u);
  ASSERT_EQ(data.size(), lines.size());
  EXPECT_EQ(junctions->GetNumberOfPoints(), lines.size());
  for (std::size_t n = 0; n < lines.size(); ++n)
  {
    EXPECT_EQ(lines[n][1], lines[(n + 1) % lines.size()][0]);
    const int expected[] = { 0, 3, 0, 3, 7, 7 };
    EXPECT_TRUE(std::equal(data[n].Begin(), data[n].End(), expected));
  }
}

TEST(IndicatorImagesToMeshFilter, JunctionPointsAreVerticesWithoutCurve)
{
  const auto filter = MakeFilter(HalvesInputs(), -1);
  filter->Update();
  const auto * junctions = filter->GetJunctions();
  const auto & data = mmmtest::CellDataOf(junctions);
  std::size_t  corners = 0;
  for (auto cell = junctions->GetCells()->Begin(); cell != junctions->GetCells()->End(); ++cell)
  {
    const bool isVertex = cell.Value()->GetNumberOfPoints() == 1;
    EXPECT_EQ(isVertex, data[cell.Index()][0] == -1);
    corners += isVertex;
  }
  // of the image's box, where label 0 meets the outside
  EXPECT_EQ(corners, 8u);
  EXPECT_EQ(data[0][1], 2);
  EXPECT_EQ(data[0][2], -1);
  EXPECT_EQ(data[0][3], 0);
}

TEST(IndicatorImagesToMeshFilter, LabelsNeedNotBeSorted)
{
  const auto & sorted = HalvesInputs();
  Inputs       inputs;
  inputs.sizes = sorted.sizes;
  for (const std::size_t n : { 2, 0, 1 })
  {
    inputs.indicators.push_back(sorted.indicators[n]);
    inputs.labels.push_back(sorted.labels[n]);
  }
  const auto filter = MakeFilter(inputs, 1);
  filter->Update();
  EXPECT_EQ(PairsOf(filter->GetSurface()), (std::set<std::array<int, 2>>{ { 0, 3 }, { 0, 7 }, { 3, 7 } }));
  const auto points = mmmtest::PointsOf(filter->GetSurface());
  const auto cells = mmmtest::CellsOf<3>(filter->GetSurface());
  const auto sides = mmmtest::CellDataOf(filter->GetSurface());
  double     upwards = 0.0;
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    upwards += sides[c][0] == 3 ? mmmtest::TriangleNormal(points, cells[c])[2] : 0.0;
  }
  EXPECT_GT(upwards, 100.0) << "from label 3, below, to label 7";
  EXPECT_GT(mmmtest::VolumesOf(filter->GetOutput()).at(7), 900.0);
}

TEST(IndicatorImagesToMeshFilter, OutsideGetsALabelThatIsNotTaken)
{
  const auto labels = mmmtest::MakeImage<LabelImage>(10, 10, 10, [](int i, int, int) { return i < 5 ? 0 : 4; });
  Inputs     inputs = MakeInputs(labels, -1);
  const auto outsideFor = [&](int first, int second, int wanted) {
    inputs.labels = { first, second };
    const auto filter = MakeFilter(inputs, -1);
    filter->SetOutsideLabel(wanted);
    filter->SurfaceOnlyOn();
    filter->Update();
    EXPECT_EQ(PairsOf(filter->GetSurface()).size(), 3u);
    return filter->GetUsedOutsideLabel();
  };
  EXPECT_EQ(outsideFor(1, 4, 0), 0);
  EXPECT_EQ(outsideFor(1, 4, 9), 9);
  EXPECT_EQ(outsideFor(1, 4, 4), 0);
  EXPECT_EQ(outsideFor(0, 4, 0), -1);
  EXPECT_EQ(outsideFor(0, -3, -3), -4);
}

TEST(IndicatorImagesToMeshFilter, ReferenceImageGivesThePlace)
{
  const auto filter = MakeFilter(HalvesInputs(), 0);
  filter->Update();
  const auto before = mmmtest::PointsOf(filter->GetOutput());
  const auto volumes = mmmtest::VolumesOf(filter->GetOutput());

  const auto reference = mmmtest::MakeBall<LabelImage>(24, 3.0);
  mmmtest::SetObliqueGeometry<LabelImage>(reference, 1.0, true);
  filter->SetReferenceImage(reference);
  filter->Update();
  const auto after = mmmtest::PointsOf(filter->GetOutput());
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t p = 0; p < before.size(); ++p)
  {
    itk::ContinuousIndex<double, 3> index;
    std::copy_n(before[p].data(), 3, index.GetDataPointer());
    LabelImage::PointType point;
    reference->TransformContinuousIndexToPhysicalPoint(index, point);
    ASSERT_LT((mmm::Vector(point[0], point[1], point[2]) - after[p]).norm(), 1e-9);
  }
  for (const auto & entry : mmmtest::VolumesOf(filter->GetOutput()))
  {
    EXPECT_NEAR(entry.second, volumes.at(entry.first), 1e-6);
  }
}

TEST(IndicatorImagesToMeshFilter, SurfaceOnlyMakesNoTetrahedra)
{
  const auto filter = MakeFilter(HalvesInputs(), 0);
  filter->SurfaceOnlyOn();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0u);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0u);
  EXPECT_GT(filter->GetSurface()->GetNumberOfCells(), 100u);
  EXPECT_GT(filter->GetJunctions()->GetNumberOfCells(), 10u);
}

TEST(IndicatorImagesToMeshFilter, KeepsTheSurfaceWhenTetrahedralizationFails)
{
  const auto filter = MakeFilter(HalvesInputs(), 0);
  filter->AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) {
    if (filter->GetCurrentStage() == "constrained tetrahedralization")
    {
      itkGenericExceptionMacro("a failure for the test");
    }
  });
  mmmtest::ExpectException([&] { filter->Update(); }, "a failure for the test");
  EXPECT_GT(filter->GetSurface()->GetNumberOfCells(), 100u);
  EXPECT_EQ(filter->GetSurface()->GetNumberOfPoints(), filter->GetParticles()->GetNumberOfPoints());
  EXPECT_EQ(filter->GetSurface()->GetNumberOfCells(), filter->GetSurface()->GetCellData()->Size());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0u);
  EXPECT_EQ(filter->GetStageRecords().back().name, "constrained tetrahedralization");
}

TEST(IndicatorImagesToMeshFilter, AbortsInEveryStage)
{
  const auto               filter = MakeFilter(HalvesInputs(), 0);
  std::vector<std::string> stages;
  filter->Update();
  for (const auto & record : filter->GetStageRecords())
  {
    EXPECT_GE(record.seconds, 0.0);
    EXPECT_GT(record.peakMemory, 1.0);
    stages.push_back(record.name);
  }
  ASSERT_GE(stages.size(), 8u);
  for (const auto & stage : stages)
  {
    const auto aborted = MakeFilter(HalvesInputs(), 0);
    aborted->AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) {
      if (aborted->GetCurrentStage() == stage)
      {
        aborted->AbortGenerateDataOn();
      }
    });
    EXPECT_THROW(aborted->Update(), itk::ProcessAborted) << stage;
    EXPECT_EQ(aborted->GetCurrentStage(), stage);
  }
}

TEST(IndicatorImagesToMeshFilter, ProgressNeverFalls)
{
  const auto filter = MakeFilter(HalvesInputs(), 0);
  filter->CompareTopologyOn();
  float last = 0.0f;
  filter->AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) {
    EXPECT_GE(filter->GetProgress(), last) << filter->GetCurrentStage();
    last = filter->GetProgress();
  });
  filter->Update();
  EXPECT_FLOAT_EQ(last, 1.0f);
}

TEST(IndicatorImagesToMeshFilter, RunsOnceForAllOutputs)
{
  const auto                filter = MakeFilter(HalvesInputs(), 0);
  const mmmtest::RunCounter runs(filter);
  filter->Update();
  filter->GetSurface()->Update();
  filter->GetParticles()->Update();
  filter->Update();
  EXPECT_EQ(runs.GetCount(), 1);
  filter->SetSeed(2);
  filter->GetSurface()->Update();
  EXPECT_EQ(runs.GetCount(), 2);
}

TEST(IndicatorImagesToMeshFilter, AnotherSeedGivesAnotherMesh)
{
  const auto filter = MakeFilter(HalvesInputs(), 0);
  filter->SurfaceOnlyOn();
  filter->Update();
  const auto first = mmmtest::PointsOf(filter->GetSurface());
  filter->SetSeed(2);
  filter->Update();
  EXPECT_NE(first, mmmtest::PointsOf(filter->GetSurface()));
}

TEST(IndicatorImagesToMeshFilter, ThrowsOnWrongInputs)
{
  const auto & inputs = HalvesInputs();
  auto         filter = MakeFilter(inputs, 0);
  filter->SetLabels({ 0, 3 });
  mmmtest::ExpectException([&] { filter->Update(); }, "There are 2 labels for 3 indicator images");
  filter->SetLabels({ 0, 3, 3 });
  mmmtest::ExpectException([&] { filter->Update(); }, "The label 3 is given to more than one");

  filter = MakeFilter(inputs, 3);
  mmmtest::ExpectException([&] { filter->Update(); }, "ExteriorIndex is 3, but there are 3");

  filter = MakeFilter(inputs, 0);
  filter->SetSizingImage(nullptr);
  mmmtest::ExpectException([&] { filter->Update(); }, "SizingImage");

  filter = MakeFilter(inputs, 0);
  filter->SetInput(4, inputs.indicators[0]);
  mmmtest::ExpectException([&] { filter->Update(); }, "Input 3 of 5 is missing");
}

TEST(IndicatorImagesToMeshFilter, ThrowsOnSizingImagesThatDoNotFit)
{
  const auto & inputs = HalvesInputs();
  auto         filter = MakeFilter(inputs, 0);
  filter->SetSizingImage(mmmtest::MakeImage<IndicatorImage>(23, 24, 24, [](int, int, int) { return 1; }));
  mmmtest::ExpectException([&] { filter->Update(); }, "The sizing image covers");

  filter = MakeFilter(inputs, 0);
  const auto moved = mmmtest::MakeImage<IndicatorImage>(24, 24, 24, [](int, int, int) { return 1; });
  mmmtest::SetObliqueGeometry<IndicatorImage>(moved, 1.0, false);
  filter->SetSizingImage(moved);
  mmmtest::ExpectException([&] { filter->Update(); }, "The sizing image differs from the indicator images");

  filter = MakeFilter(inputs, 0);
  filter->SetSizingImage(mmmtest::MakeImage<IndicatorImage>(24, 24, 24, [](int i, int, int) { return i; }));
  mmmtest::ExpectException([&] { filter->Update(); }, "The sizing image has the value 0");
}

TEST(IndicatorImagesToMeshFilter, PrintsItsParameters)
{
  const auto filter = MakeFilter(HalvesInputs(), 0);
  const auto text = mmmtest::Printed(filter.GetPointer());
  EXPECT_NE(text.find("ExteriorIndex: 0"), std::string::npos) << text;
  EXPECT_STREQ(filter->GetNameOfClass(), "IndicatorImagesToMeshFilter");
}
