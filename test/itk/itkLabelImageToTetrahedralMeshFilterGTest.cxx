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

#include <algorithm>
#include <cmath>
#include <functional>

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

FilterType::Pointer
RunFilter(const LabelImage * image)
{
  const auto filter = MakeFilter(image);
  filter->Update();
  return filter;
}

/** A column of label 1, 10 x 8 voxels wide, that the upper and the lower face of the box cut, in exterior. */
LabelImage::Pointer
MakeColumn()
{
  return mmmtest::MakeImage<LabelImage>(
    20, 20, 12, [](int i, int j, int) { return i >= 5 && i < 15 && j >= 6 && j < 14 ? 1 : 0; });
}

/** The corners of each cell, sorted: the cells whatever their orientation. */
std::vector<std::array<std::size_t, 4>>
SortedCells(const itk::LabelTetrahedralMesh * mesh)
{
  auto cells = mmmtest::CellsOf<4>(mesh);
  for (auto & cell : cells)
  {
    std::sort(cell.begin(), cell.end());
  }
  return cells;
}
} // namespace

TEST(LabelImageToTetrahedralMeshFilter, VolumeOfASphereIsRight)
{
  const auto   filter = RunFilter(mmmtest::MakeBall<LabelImage>(28, 10.0));
  const double volume = 4.0 / 3.0 * itk::Math::pi * 1000.0;
  EXPECT_NEAR(mmmtest::VolumesOf(filter->GetOutput()).at(1), volume, 0.03 * volume);
  double     area = 0.0;
  const auto points = mmmtest::PointsOf(filter->GetSurface());
  for (const auto & corners : mmmtest::CellsOf<3>(filter->GetSurface()))
  {
    area += mmmtest::TriangleNormal(points, corners).norm();
  }
  EXPECT_NEAR(area, 400.0 * itk::Math::pi, 0.03 * 400.0 * itk::Math::pi);
}

TEST(LabelImageToTetrahedralMeshFilter, ACubeOfThreeVoxelsKeepsItsVolume)
{
  const auto filter = RunFilter(mmmtest::MakeImage<LabelImage>(
    15, 15, 15, [](int i, int j, int k) { return std::min({ i, j, k }) >= 6 && std::max({ i, j, k }) < 9 ? 1 : 0; }));
  EXPECT_NEAR(mmmtest::VolumesOf(filter->GetOutput()).at(1), 27.0, 2.7);
}

TEST(LabelImageToTetrahedralMeshFilter, SmallLabelsAreSampledFinelyUnlessCoarseMeshesAreAskedFor)
{
  const auto image = mmmtest::MakeImage<LabelImage>(
    15, 15, 15, [](int i, int j, int k) { return std::min({ i, j, k }) >= 5 && std::max({ i, j, k }) < 9 ? 1 : 0; });
  // edges of a voxel make some 70 triangles, edges of two voxels 30
  EXPECT_GT(RunFilter(image)->GetSurface()->GetNumberOfCells(), 100u);
  const auto coarse = MakeFilter(image);
  coarse->SetMinimumSize(2.0);
  coarse->Update();
  EXPECT_LT(coarse->GetSurface()->GetNumberOfCells(), 50u);
}

TEST(LabelImageToTetrahedralMeshFilter, TetrahedraArePositiveAndEveryPointIsUsed)
{
  const auto            filter = RunFilter(mmmtest::MakeHalves<LabelImage>(24, 8.0));
  const auto            points = mmmtest::PointsOf(filter->GetOutput());
  std::set<std::size_t> used;
  for (const auto & cell : mmmtest::CellsOf<4>(filter->GetOutput()))
  {
    EXPECT_GT(mmm::TetrahedronVolume(points[cell[0]], points[cell[1]], points[cell[2]], points[cell[3]]), 0.0);
    used.insert(cell.begin(), cell.end());
  }
  EXPECT_EQ(used.size(), points.size());
  EXPECT_EQ(*used.rbegin(), points.size() - 1);
}

TEST(LabelImageToTetrahedralMeshFilter, EveryFaceHasOneOrTwoTetrahedra)
{
  const auto filter = RunFilter(mmmtest::MakeHalves<LabelImage>(24, 8.0));
  for (const auto & face : mmmtest::FacesOf(filter->GetOutput()))
  {
    ASSERT_LE(face.second.size(), 2u);
  }
}

TEST(LabelImageToTetrahedralMeshFilter, InterfacesAreClosed)
{
  const auto image = mmmtest::MakeHalves<LabelImage>(24, 8.0);
  for (const bool surfaceOnly : { false, true })
  {
    const auto filter = MakeFilter(image);
    filter->SetSurfaceOnly(surfaceOnly);
    filter->Update();
    const auto open = mmmtest::OpenEdges(filter->GetSurface());
    EXPECT_EQ(open, (std::map<int, std::size_t>{ { 0, 0u }, { 1, 0u }, { 2, 0u } }));
    for (const auto & entry : mmmtest::OrientedAreas(filter->GetSurface()))
    {
      EXPECT_LT(entry.second.norm(), 1e-9) << entry.first;
    }
  }
}

TEST(LabelImageToTetrahedralMeshFilter, OutputsTheLabelsOfTheImage)
{
  using WideImage = itk::Image<unsigned int, 3>;
  const auto filter = itk::LabelImageToTetrahedralMeshFilter<WideImage>::New();
  filter->SetInput(mmmtest::MakeHalves<WideImage>(24, 8.0, 255, 2147483647));
  filter->Update();
  const auto volumes = mmmtest::VolumesOf(filter->GetOutput());
  EXPECT_EQ(volumes.size(), 2u);
  EXPECT_GT(volumes.at(255), 900.0);
  EXPECT_GT(volumes.at(2147483647), 900.0);
  EXPECT_EQ(filter->GetLabels(), (std::vector<int>{ 0, 255, 2147483647 }));
}

template <typename TPixel>
class LabelImageToTetrahedralMeshFilterPixels : public testing::Test
{};
using PixelTypes = testing::Types<unsigned short, short, int, unsigned int>;
TYPED_TEST_SUITE(LabelImageToTetrahedralMeshFilterPixels, PixelTypes);

template <typename TPixel>
auto
PointsOfHalves()
{
  using TypedImage = itk::Image<TPixel, 3>;
  const auto filter = itk::LabelImageToTetrahedralMeshFilter<TypedImage>::New();
  filter->SetInput(mmmtest::MakeHalves<TypedImage>(20, 6.0));
  filter->Update();
  return mmmtest::PointsOf(filter->GetOutput());
}

TYPED_TEST(LabelImageToTetrahedralMeshFilterPixels, GiveTheMeshOfBytes)
{
  const auto ofBytes = PointsOfHalves<unsigned char>();
  ASSERT_FALSE(ofBytes.empty());
  EXPECT_EQ(PointsOfHalves<TypeParam>(), ofBytes);
}

TEST(LabelImageToTetrahedralMeshFilter, NegativeLabelsAreLabels)
{
  using SignedImage = itk::Image<short, 3>;
  const auto filter = itk::LabelImageToTetrahedralMeshFilter<SignedImage>::New();
  filter->SetInput(mmmtest::MakeHalves<SignedImage>(20, 6.0, -5, 3));
  filter->Update();
  EXPECT_EQ(filter->GetLabels(), (std::vector<int>{ -5, 0, 3 }));
  EXPECT_GT(mmmtest::VolumesOf(filter->GetOutput()).at(-5), 300.0);
  for (const auto & sides : mmmtest::CellDataOf(filter->GetSurface()))
  {
    ASSERT_LT(sides[0], sides[1]);
  }
}

TEST(LabelImageToTetrahedralMeshFilter, FillsMeshesOfOtherTypes)
{
  using MeshType = itk::Mesh<float, 3>;
  const auto filter = itk::LabelImageToTetrahedralMeshFilter<LabelImage, MeshType>::New();
  filter->SetInput(mmmtest::MakeHalves<LabelImage>(20, 6.0));
  filter->Update();
  EXPECT_EQ(mmmtest::VolumesOf(filter->GetOutput()).size(), 2u);
}

TEST(LabelImageToTetrahedralMeshFilter, MeshCommutesWithOriginDirectionSpacing)
{
  LabelImage::SpacingType spacing;
  spacing[0] = 1.0;
  spacing[1] = 1.25;
  spacing[2] = 0.8;
  const auto image = mmmtest::MakeHalves<LabelImage>(20, 7.0);
  image->SetSpacing(spacing);
  const auto first = RunFilter(image);
  const auto points = mmmtest::PointsOf(first->GetOutput());
  const auto cells = SortedCells(first->GetOutput());

  struct Case
  {
    double unit;
    bool   reflect;
    int    start;
  };
  for (const Case & other : { Case{ 0.001, false, 0 }, Case{ 1.0 / 3.0, true, 0 }, Case{ 7.3, true, -11 } })
  {
    const auto moved = mmmtest::MakeHalves<LabelImage>(20, 7.0);
    moved->SetSpacing(spacing * other.unit);
    mmmtest::SetObliqueGeometry<LabelImage>(moved, other.unit, other.reflect);
    auto region = moved->GetBufferedRegion();
    region.SetIndex({ { other.start, 2 * other.start, 3 * other.start } });
    moved->SetRegions(region);
    const auto second = RunFilter(moved);

    const auto movedPoints = mmmtest::PointsOf(second->GetOutput());
    ASSERT_EQ(movedPoints.size(), points.size());
    for (std::size_t p = 0; p < points.size(); ++p)
    {
      itk::ContinuousIndex<double, 3> index;
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        index[axis] = points[p][axis] / spacing[axis] + (int(axis) + 1) * other.start;
      }
      LabelImage::PointType expected;
      moved->TransformContinuousIndexToPhysicalPoint(index, expected);
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        ASSERT_NEAR(movedPoints[p][axis], expected[axis], 1e-9 * 100.0 * other.unit);
      }
    }
    EXPECT_EQ(SortedCells(second->GetOutput()), cells);
    EXPECT_EQ(mmmtest::CellDataOf(second->GetOutput()), mmmtest::CellDataOf(first->GetOutput()));
    EXPECT_EQ(mmmtest::CellDataOf(second->GetSurface()), mmmtest::CellDataOf(first->GetSurface()));
    const double scale = std::pow(other.unit, 3);
    const auto   volumes = mmmtest::VolumesOf(first->GetOutput());
    for (const auto & entry : mmmtest::VolumesOf(second->GetOutput()))
    {
      EXPECT_NEAR(entry.second, scale * volumes.at(entry.first), 1e-6 * scale * volumes.at(entry.first));
    }
    // normals are turned over together with the cells
    double     flux = 0.0;
    const auto sides = mmmtest::CellDataOf(second->GetSurface());
    const auto triangles = mmmtest::CellsOf<3>(second->GetSurface());
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
      if (sides[t][0] == 0)
      {
        flux += mmmtest::TriangleNormal(movedPoints, triangles[t]).dot(movedPoints[triangles[t][0]]) / 3.0;
      }
    }
    EXPECT_NEAR(-flux, scale * (volumes.at(1) + volumes.at(2)), 1e-6 * scale * volumes.at(1));
  }
}

TEST(LabelImageToTetrahedralMeshFilter, MeshCommutesWhenLengthsAreGiven)
{
  std::vector<std::array<std::size_t, 4>> cells;
  for (const double unit : { 1.0, 0.001 })
  {
    const auto              image = mmmtest::MakeHalves<LabelImage>(20, 6.0);
    LabelImage::SpacingType spacing;
    spacing.Fill(unit);
    image->SetSpacing(spacing);
    const auto sizes =
      mmmtest::MakeImage<itk::Image<float, 3>>(20, 20, 20, [unit](int i, int, int) { return (1.3 + 0.2 * i) * unit; });
    sizes->SetSpacing(spacing);
    const auto filter = MakeFilter(image);
    filter->SetSizingImage(sizes);
    filter->SetRadius(0.7 * unit);
    filter->SetChordTolerance(0.07 * unit);
    filter->SetMinimumSize(1.1 * unit);
    filter->SetMaximumSize(3.3 * unit);
    filter->Update();
    if (cells.empty())
    {
      cells = SortedCells(filter->GetOutput());
    }
    EXPECT_EQ(SortedCells(filter->GetOutput()), cells);
  }
}

TEST(LabelImageToTetrahedralMeshFilter, SameMeshForAnyNumberOfThreads)
{
  const auto                              image = mmmtest::MakeHalves<LabelImage>(24, 8.0);
  std::vector<mmm::Vector>                points;
  std::vector<std::array<std::size_t, 4>> cells;
  std::vector<std::array<std::size_t, 2>> junctions;
  for (const itk::ThreadIdType threads : { 1, 2, 4 })
  {
    const mmmtest::ThreadCount count(threads);
    const auto                 filter = RunFilter(image);
    if (points.empty())
    {
      points = mmmtest::PointsOf(filter->GetOutput());
      cells = mmmtest::CellsOf<4>(filter->GetOutput());
      junctions = mmmtest::CellsOf<2>(filter->GetJunctions());
      EXPECT_GT(junctions.size(), 10u);
    }
    EXPECT_EQ(mmmtest::PointsOf(filter->GetOutput()), points) << threads;
    EXPECT_EQ(mmmtest::CellsOf<4>(filter->GetOutput()), cells) << threads;
    EXPECT_EQ(mmmtest::CellsOf<2>(filter->GetJunctions()), junctions) << threads;
  }
}

TEST(LabelImageToTetrahedralMeshFilter, BoxCutIsFlat)
{
  const auto filter = RunFilter(MakeColumn());
  const auto points = mmmtest::PointsOf(filter->GetSurface());
  double     lowest = 1e9;
  double     highest = -1e9;
  for (const auto & point : points)
  {
    lowest = std::min(lowest, point[2]);
    highest = std::max(highest, point[2]);
  }
  EXPECT_EQ(lowest, -0.5);
  EXPECT_EQ(highest, 11.5);
  double cut = 0.0;
  for (const auto & corners : mmmtest::CellsOf<3>(filter->GetSurface()))
  {
    if (std::all_of(corners.begin(), corners.end(), [&](std::size_t c) { return points[c][2] == 11.5; }))
    {
      cut += mmmtest::TriangleNormal(points, corners).norm();
    }
  }
  // smoothing rounds the column's edges and lets its sides bulge by less than half a voxel
  EXPECT_NEAR(cut, 80.0, 4.0);
  EXPECT_NEAR(mmmtest::VolumesOf(filter->GetOutput()).at(1), 12.0 * cut, 12.0 * 4.0);
}

TEST(LabelImageToTetrahedralMeshFilter, MeshesTheWholeBoxWithoutExterior)
{
  const auto image = mmmtest::MakeImage<LabelImage>(12, 10, 8, [](int i, int, int) { return i < 6 ? 0 : 3; });
  const auto filter = MakeFilter(image);
  filter->SetExteriorLabels({});
  filter->SetMaximumSize(2.5);
  filter->Update();
  const auto volumes = mmmtest::VolumesOf(filter->GetOutput());
  EXPECT_NEAR(volumes.at(0) + volumes.at(3), 960.0, 1e-9);
  EXPECT_NEAR(volumes.at(0), 480.0, 5.0);
  EXPECT_EQ(filter->GetOutsideLabel(), -1);
  std::set<std::array<double, 3>> corners;
  for (const auto & point : mmmtest::PointsOf(filter->GetOutput()))
  {
    corners.insert({ { point[0], point[1], point[2] } });
  }
  for (int corner = 0; corner < 8; ++corner)
  {
    EXPECT_TRUE(corners.count({ { corner & 1 ? 11.5 : -0.5, corner & 2 ? 9.5 : -0.5, corner & 4 ? 7.5 : -0.5 } }))
      << corner;
  }
}

TEST(LabelImageToTetrahedralMeshFilter, SeveralExteriorLabelsAreOneMaterial)
{
  // exterior 0 and 9 around a ball: no interface between them
  const auto image = mmmtest::MakeImage<LabelImage>(
    24, 24, 24, [](int i, int j, int k) { return mmmtest::IsInBall(i, j, k, 24, 8.0) ? 1 : (i < 12 ? 0 : 9); });
  const auto filter = MakeFilter(image);
  filter->SetExteriorLabels({ 9, 0 });
  filter->Update();
  EXPECT_EQ(filter->GetLabels(), (std::vector<int>{ 1, 9 }));
  EXPECT_EQ(filter->GetOutsideLabel(), 9);
  for (const auto & sides : mmmtest::CellDataOf(filter->GetSurface()))
  {
    ASSERT_EQ(sides[0], 1);
    ASSERT_EQ(sides[1], 9);
  }
  EXPECT_TRUE(filter->GetAbsentExteriorLabels().empty());
  EXPECT_TRUE(filter->GetVanishedLabels().empty());
}

TEST(LabelImageToTetrahedralMeshFilter, ReportsExteriorLabelsThatAreAbsent)
{
  const auto filter = MakeFilter(mmmtest::MakeHalves<LabelImage>(20, 6.0, 1, 2));
  filter->SetExteriorLabels({ 7, 0, 8 });
  filter->Update();
  EXPECT_EQ(filter->GetAbsentExteriorLabels(), (std::vector<int>{ 7, 8 }));
  EXPECT_EQ(filter->GetOutsideLabel(), 0);

  filter->SetExteriorLabels({ 7 });
  filter->Update();
  EXPECT_EQ(filter->GetAbsentExteriorLabels(), (std::vector<int>{ 7 }));
  EXPECT_EQ(filter->GetOutsideLabel(), 7);
  EXPECT_EQ(mmmtest::VolumesOf(filter->GetOutput()).size(), 3u);
}

TEST(LabelImageToTetrahedralMeshFilter, ReportsIslands)
{
  const auto image = mmmtest::MakeBall<LabelImage>(20, 6.0);
  image->SetPixel({ { 9, 9, 9 } }, 0);
  const auto filter = RunFilter(image);
  EXPECT_EQ(filter->GetIslandRecords().at(0).components, 1u);
  EXPECT_EQ(filter->GetIslandRecords().at(0).destinations.at(1), 1u);
  EXPECT_EQ(mmmtest::OpenEdges(filter->GetSurface()).at(0), 0u);
}

TEST(LabelImageToTetrahedralMeshFilter, ReportsVanishedLabels)
{
  // a single voxel that heavy tightening removes
  const auto image = mmmtest::MakeBall<LabelImage>(24, 8.0);
  image->SetPixel({ { 11, 11, 11 } }, 5);
  for (const bool surfaceOnly : { false, true })
  {
    const auto filter = MakeFilter(image);
    filter->SetRadius(3.0);
    filter->SetSurfaceOnly(surfaceOnly);
    filter->Update();
    EXPECT_EQ(filter->GetVanishedLabels(), (std::map<int, std::size_t>{ { 5, 1u } }));
    EXPECT_EQ(filter->GetLabels(), (std::vector<int>{ 0, 1, 5 }));
  }
}

TEST(LabelImageToTetrahedralMeshFilter, RefusesToLoseALargeLabel)
{
  // a layer of a voxel between two balls, smoothed with edges that are far too long for it
  const auto image = mmmtest::MakeImage<LabelImage>(40, 40, 40, [](int i, int j, int k) {
    const double radius = std::sqrt(std::pow(i - 19.5, 2) + std::pow(j - 19.5, 2) + std::pow(k - 19.5, 2));
    return radius < 12.0 ? 1 : radius < 12.8 ? 5 : radius < 17.0 ? 2 : 0;
  });
  const auto filter = MakeFilter(image);
  filter->SetMinimumSize(15.0);
  filter->SetRadius(2.0);
  try
  {
    filter->Update();
    ADD_FAILURE() << "no exception";
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_NE(std::string(error.GetDescription()).find("Label 5 ("), std::string::npos) << error;
  }
  filter->AllowVanishedLabelsOn();
  filter->Update();
  EXPECT_EQ(filter->GetVanishedLabels().count(5), 1u);
}

TEST(LabelImageToTetrahedralMeshFilter, HonorsTheSizingImage)
{
  const auto image = mmmtest::MakeBall<LabelImage>(20, 6.0);
  const auto coarse = RunFilter(image);
  const auto sizes = mmmtest::MakeImage<itk::Image<float, 3>>(20, 20, 20, [](int, int, int) { return 0.8; });
  const auto fine = MakeFilter(image);
  fine->SetSizingImage(sizes);
  fine->Update();
  EXPECT_GT(fine->GetOutput()->GetNumberOfCells(), 2 * coarse->GetOutput()->GetNumberOfCells());
}

TEST(LabelImageToTetrahedralMeshFilter, ParametersReachTheStages)
{
  const auto image = mmmtest::MakeBall<LabelImage>(24, 8.0);
  const auto cellsWith = [&](const std::function<void(FilterType *)> & set) {
    const auto filter = MakeFilter(image);
    set(filter);
    filter->Update();
    return filter->GetOutput()->GetNumberOfCells();
  };
  const auto standard = cellsWith([](FilterType *) {});
  EXPECT_LT(cellsWith([](FilterType * filter) { filter->SetChordTolerance(0.3); }), standard);
  EXPECT_GT(cellsWith([](FilterType * filter) { filter->SetEpsilon(0.15); }), standard);
  EXPECT_GT(cellsWith([](FilterType * filter) { filter->SetGradientLimit(0.05); }), standard);
  EXPECT_LT(cellsWith([](FilterType * filter) { filter->SetMinimumSize(4.0); }), standard);
  EXPECT_GT(cellsWith([](FilterType * filter) { filter->SetMaximumSize(1.5); }), standard);
}

TEST(LabelImageToTetrahedralMeshFilter, KeepsIntermediatesIfAsked)
{
  const auto image = mmmtest::MakeHalves<LabelImage>(20, 6.0);
  mmmtest::SetObliqueGeometry<LabelImage>(image, 0.5, true);
  LabelImage::SpacingType spacing;
  spacing.Fill(0.5);
  image->SetSpacing(spacing);
  auto region = image->GetBufferedRegion();
  region.SetIndex({ { 3, -4, 5 } });
  image->SetRegions(region);
  const auto filter = MakeFilter(image);
  filter->SurfaceOnlyOn();
  filter->Update();
  EXPECT_EQ(filter->GetComputedSizingImage(), nullptr);
  mmmtest::ExpectException([&] { filter->GetIndicatorImage(1); }, "KeepIntermediates is off");

  filter->KeepIntermediatesOn();
  filter->Update();
  EXPECT_EQ(filter->GetComputedSizingImage()->GetBufferedRegion(), region);
  EXPECT_EQ(filter->GetComputedSizingImage()->GetDirection(), image->GetDirection());
  EXPECT_GE(filter->GetComputedSizingImage()->GetPixel({ { 13, 6, 15 } }), 0.5f);

  const auto * indicator = filter->GetIndicatorImage(2);
  EXPECT_TRUE(region.IsInside(indicator->GetBufferedRegion()));
  EXPECT_EQ(indicator->GetOrigin(), image->GetOrigin());
  EXPECT_EQ(indicator->GetSpacing(), image->GetSpacing());
  const LabelImage::IndexType inside{ { 3 + 10, -4 + 10, 5 + 12 } };
  ASSERT_EQ(image->GetPixel(inside), 2);
  EXPECT_GT(indicator->GetPixel(inside), 0.8f);
  EXPECT_LE(indicator->GetPixel(inside), 1.5f);
  mmmtest::ExpectException([&] { filter->GetIndicatorImage(9); }, "There is no indicator image for label 9");
}

TEST(LabelImageToTetrahedralMeshFilter, LeavesItsInputAlone)
{
  const auto image = mmmtest::MakeBall<LabelImage>(20, 6.0);
  mmmtest::SetObliqueGeometry<LabelImage>(image, 1.0, false);
  image->SetPixel({ { 9, 9, 9 } }, 3);
  const auto origin = image->GetOrigin();
  const auto time = image->GetMTime();
  RunFilter(image);
  EXPECT_EQ(image->GetOrigin(), origin);
  EXPECT_EQ(image->GetMTime(), time);
  EXPECT_EQ(image->GetPixel({ { 9, 9, 9 } }), 3);
}

TEST(LabelImageToTetrahedralMeshFilter, RunsOnceForAllOutputs)
{
  const auto                filter = MakeFilter(mmmtest::MakeBall<LabelImage>(16, 5.0));
  const mmmtest::RunCounter runs(filter);
  filter->Update();
  filter->GetSurface()->Update();
  filter->GetParticles()->Update();
  EXPECT_EQ(runs.GetCount(), 1);
}

TEST(LabelImageToTetrahedralMeshFilter, ProgressNeverFallsAndNamesTheStages)
{
  const auto               filter = MakeFilter(mmmtest::MakeHalves<LabelImage>(20, 6.0));
  std::vector<std::string> stages;
  float                    last = 0.0f;
  filter->AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) {
    EXPECT_GE(filter->GetProgress(), last) << filter->GetCurrentStage();
    EXPECT_GE(filter->GetStageProgress(), 0.0f);
    EXPECT_LE(filter->GetStageProgress(), 1.0f);
    last = filter->GetProgress();
    if (stages.empty() || stages.back() != filter->GetCurrentStage())
    {
      stages.push_back(filter->GetCurrentStage());
    }
  });
  filter->Update();
  EXPECT_FLOAT_EQ(last, 1.0f);
  std::vector<std::string> recorded;
  for (const auto & record : filter->GetStageRecords())
  {
    recorded.push_back(record.name);
  }
  EXPECT_EQ(stages, recorded);
  ASSERT_GE(stages.size(), 4u);
  EXPECT_EQ(stages[0], "merging of islands");
  EXPECT_EQ(stages[1], "indicators");
  EXPECT_EQ(stages[2], "sizing");
}

TEST(LabelImageToTetrahedralMeshFilter, AbortsInEveryStage)
{
  const auto image = mmmtest::MakeHalves<LabelImage>(20, 6.0);
  const auto complete = RunFilter(image);
  for (const auto & record : complete->GetStageRecords())
  {
    const auto filter = MakeFilter(image);
    filter->AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) {
      if (filter->GetCurrentStage() == record.name)
      {
        filter->AbortGenerateDataOn();
      }
    });
    EXPECT_THROW(filter->Update(), itk::ProcessAborted) << record.name;
    EXPECT_EQ(filter->GetCurrentStage(), record.name);
  }
}

TEST(LabelImageToTetrahedralMeshFilter, KeepsTheSurfaceWhenTetrahedralizationFails)
{
  const auto filter = MakeFilter(mmmtest::MakeHalves<LabelImage>(20, 6.0));
  filter->AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) {
    if (filter->GetCurrentStage() == "constrained tetrahedralization")
    {
      itkGenericExceptionMacro("a failure for the test");
    }
  });
  mmmtest::ExpectException([&] { filter->Update(); }, "a failure for the test");
  EXPECT_GT(filter->GetSurface()->GetNumberOfCells(), 100u);
  EXPECT_GT(filter->GetParticles()->GetNumberOfPoints(), 50u);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0u);
}

TEST(LabelImageToTetrahedralMeshFilter, RecoversFromAnException)
{
  const auto filter = MakeFilter(mmmtest::MakeHalves<LabelImage>(20, 6.0));
  filter->SetEpsilon(-1.0);
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
  filter->SetEpsilon(2.5);
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetNumberOfCells(), 100u);
}

TEST(LabelImageToTetrahedralMeshFilter, ThrowsOnASingleValue)
{
  const auto filter = MakeFilter(mmmtest::MakeImage<LabelImage>(6, 6, 6, [](int, int, int) { return 7; }));
  mmmtest::ExpectException([&] { filter->Update(); }, "The label image has a single value, 7");
}

TEST(LabelImageToTetrahedralMeshFilter, ThrowsOnAnIntensityImage)
{
  const auto filter = MakeFilter(
    mmmtest::MakeImage<LabelImage>(20, 20, 20, [](int i, int j, int k) { return (97 * i + 31 * j + 57 * k) % 200; }));
  mmmtest::ExpectException([&] { filter->Update(); },
                           "The image has 200 values, from 0 to 199 that change from voxel to voxel, and looks like an "
                           "intensity image");
}

TEST(LabelImageToTetrahedralMeshFilter, TakesAnAtlasOfManyLabels)
{
  const auto filter = MakeFilter(mmmtest::MakeImage<LabelImage>(
    20, 20, 20, [](int i, int j, int k) { return 1 + i / 4 + 5 * (j / 4) + 25 * (k / 4); }));
  filter->SurfaceOnlyOn();
  filter->SetMinimumSize(2.0);
  filter->Update();
  EXPECT_EQ(filter->GetLabels().size(), 125u);
}

TEST(LabelImageToTetrahedralMeshFilter, ThrowsOnNothingButExterior)
{
  const auto filter = MakeFilter(mmmtest::MakeBall<LabelImage>(10, 3.0));
  filter->SetExteriorLabels({ 0, 1 });
  mmmtest::ExpectException([&] { filter->Update(); }, "All labels of the image are exterior");
}

TEST(LabelImageToTetrahedralMeshFilter, ThrowsOnParametersOutOfRange)
{
  const auto image = mmmtest::MakeBall<LabelImage>(10, 3.0);
  const auto expect = [&](const std::function<void(FilterType *)> & set, const std::string & words) {
    const auto filter = MakeFilter(image);
    set(filter);
    mmmtest::ExpectException([&] { filter->Update(); }, words);
    EXPECT_TRUE(filter->GetStageRecords().empty()) << "before any work";
  };
  expect([](FilterType * filter) { filter->SetRadius(-0.5); }, "The radius is -0.5 mm");
  expect([](FilterType * filter) { filter->SetEpsilon(0.0); }, "The epsilon is 0");
  expect([](FilterType * filter) { filter->SetChordTolerance(0.0); }, "The chord tolerance is 0 mm");
  expect([](FilterType * filter) { filter->SetGradientLimit(-1.0); }, "The gradient limit is -1");
  expect([](FilterType * filter) { filter->SetMinimumSize(0.0); }, "The smallest size is 0 mm");
  expect([](FilterType * filter) { filter->SetMaximumSize(-3.0); }, "The largest size is -3 mm");
  expect(
    [](FilterType * filter) {
      filter->SetMinimumSize(2.0);
      filter->SetMaximumSize(1.0);
    },
    "The smallest size, 2 mm, is above the largest, 1 mm");
}

TEST(LabelImageToTetrahedralMeshFilter, ThrowsOnSizingImagesThatDoNotFit)
{
  const auto filter = MakeFilter(mmmtest::MakeBall<LabelImage>(10, 3.0));
  const auto sizes = mmmtest::MakeImage<itk::Image<float, 3>>(10, 10, 10, [](int i, int, int) { return i - 1; });
  filter->SetSizingImage(sizes);
  mmmtest::ExpectException([&] { filter->Update(); }, "The sizing image has the value -1 at [0, 0, 0]");

  filter->SetSizingImage(mmmtest::MakeImage<itk::Image<float, 3>>(10, 10, 9, [](int, int, int) { return 1; }));
  mmmtest::ExpectException([&] { filter->Update(); }, "They must be on the same grid");

  mmmtest::SetObliqueGeometry<itk::Image<float, 3>>(sizes, 1.0, false);
  filter->SetSizingImage(sizes);
  mmmtest::ExpectException([&] { filter->Update(); }, "The sizing image differs from the label image");
}

TEST(LabelImageToTetrahedralMeshFilter, ThrowsWithoutInput)
{
  EXPECT_THROW(FilterType::New()->Update(), itk::ExceptionObject);
}

TEST(LabelImageToTetrahedralMeshFilter, PrintsItsParameters)
{
  const auto filter = RunFilter(mmmtest::MakeBall<LabelImage>(10, 3.0));
  const auto text = mmmtest::Printed(filter.GetPointer());
  EXPECT_NE(text.find("MinimumIslandSize: 8"), std::string::npos) << text;
  EXPECT_NE(std::min(text.find(" Labels: (0, 1)"), text.find(" Labels: [0, 1]")), std::string::npos)
    << text; // ITK 5, 6
  EXPECT_STREQ(filter->GetNameOfClass(), "LabelImageToTetrahedralMeshFilter");
}

TEST(LabelImageToTetrahedralMeshFilter, SaysWhatToDoIfMemoryRunsOut)
{
  for (const char * const stage : { "indicators", "surface", "optimization" })
  {
    const auto filter = MakeFilter(mmmtest::MakeBall<LabelImage>(14, 5.0));
    filter->AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) {
      if (filter->GetCurrentStage() == stage)
      {
        throw std::bad_alloc();
      }
    });
    mmmtest::ExpectException([&] { filter->Update(); }, "Ask for larger elements");
  }
}

namespace
{
/** A sheet of label 2, one voxel thick, between labels 1 and 3, which share a face of voxels in a hole of it. */
LabelImage::Pointer
MakeSheetWithHole()
{
  return mmmtest::MakeImage<LabelImage>(13, 13, 13, [](int i, int j, int k) {
    const bool isInHole = i == 6 && j == 6;
    return k < 6 || (k == 6 && isInHole) ? 1 : k == 6 ? 2 : 3;
  });
}

/** The tunnels of label 2 in the mesh. */
std::ptrdiff_t
CountTunnels(FilterType * filter)
{
  filter->SetMinimumIslandSize(0);
  filter->SetExteriorLabels({});
  filter->SetCompareTopology(true);
  filter->Update();
  return filter->GetReport().topology.labels.at(1).mesh[1];
}
} // namespace

TEST(LabelImageToTetrahedralMeshFilter, ContactsStayWhereTopologyIsKept)
{
  const auto image = MakeSheetWithHole();
  const auto any = MakeFilter(image);
  any->SetTopologyMode(mmm::TopologyMode::Any);
  EXPECT_EQ(CountTunnels(any), 0);
  const auto keep = MakeFilter(image);
  keep->SetTopologyMode("keep");
  EXPECT_EQ(keep->GetTopologyMode(), mmm::TopologyMode::Keep);
  EXPECT_EQ(CountTunnels(keep), 1);
}

TEST(LabelImageToTetrahedralMeshFilter, TopologyIsKeptWithEpsilonOneUnlessAnyIsAskedFor)
{
  const auto image = MakeSheetWithHole();
  const auto automatic = MakeFilter(image);
  EXPECT_EQ(CountTunnels(automatic), 0);
  automatic->SetEpsilon(1.0);
  EXPECT_EQ(CountTunnels(automatic), 1);
  automatic->SetTopologyMode("any");
  EXPECT_EQ(CountTunnels(automatic), 0);
}

TEST(LabelImageToTetrahedralMeshFilter, ThrowsOnUnknownTopologyModes)
{
  const auto filter = FilterType::New();
  EXPECT_THROW(filter->SetTopologyMode("both"), itk::ExceptionObject);
}
