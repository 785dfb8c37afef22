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
#include "itkTriangleSurfaceToDistanceImageFilter.h"
#include "support/TestLabelImages.h"
#include "support/TestSurfaces.h"

#include "itkImageRegionConstIteratorWithIndex.h"
#include "itkQuadrilateralCell.h"

#include <cmath>
#include <limits>

namespace
{
using mmm::Vector;
using MeshType = itk::LabelInterfaceMesh;
using ImageType = itk::Image<float, 3>;
using FilterType = itk::TriangleSurfaceToDistanceImageFilter<MeshType, ImageType>;
using GridType = itk::Image<short, 3>;

const Vector Centre(9.0, 10.0, 11.0);

GridType::Pointer
MakeGrid()
{
  return mmmtest::MakeImage<GridType>(20, 20, 20, [](int, int, int) { return 0; });
}

FilterType::Pointer
MakeFilter(const MeshType * mesh, const itk::ImageBase<3> * grid)
{
  const auto filter = FilterType::New();
  filter->SetInput(mesh);
  filter->SetReferenceImage(grid);
  return filter;
}

void
ExpectError(const mmm::TriangleSurface & surface, const std::string & words)
{
  const auto filter = MakeFilter(mmmtest::ToMesh(surface), MakeGrid());
  mmmtest::ExpectException([&] { filter->Update(); }, words);
}
} // namespace

TEST(TriangleSurfaceToDistanceImageFilter, DistanceIsInTheImagesPlaceAndUnit)
{
  for (const bool reflect : { false, true })
  {
    const auto grid = MakeGrid();
    grid->SetSpacing(itk::Vector<double, 3>(0.5).GetDataPointer());
    mmmtest::SetObliqueGeometry(grid.GetPointer(), 1.0, reflect);
    itk::ContinuousIndex<double, 3> middle;
    middle.Fill(9.3);
    ImageType::PointType centre;
    grid->TransformContinuousIndexToPhysicalPoint(middle, centre);

    const Vector place(centre.GetDataPointer());
    const auto   filter = MakeFilter(mmmtest::ToMesh(mmmtest::MakeSphere(place, 3.0, 40)), grid);
    filter->Update();
    const auto * distance = filter->GetOutput();
    EXPECT_EQ(distance->GetDirection(), grid->GetDirection());
    EXPECT_EQ(filter->GetNumberOfBoundaryEdges(), 0u);
    EXPECT_FALSE(filter->GetHasOverlaps());
    double                                            largest = 0.0;
    itk::ImageRegionConstIteratorWithIndex<ImageType> it(distance, distance->GetBufferedRegion());
    for (; !it.IsAtEnd(); ++it)
    {
      ImageType::PointType point;
      distance->TransformIndexToPhysicalPoint(it.GetIndex(), point);
      const double known = 3.0 - point.EuclideanDistanceTo(centre);
      largest = std::max(largest, std::abs(it.Get() - std::min(std::max(known, -1.5), 1.5)));
    }
    EXPECT_LT(largest, 0.01);
  }
}

TEST(TriangleSurfaceToDistanceImageFilter, TellsDefects)
{
  auto surface = mmmtest::MakeSphere(Centre, 6.0, 16);
  surface.triangles.pop_back();
  std::swap(surface.triangles[5][0], surface.triangles[5][1]);
  surface = mmmtest::Join(surface, mmmtest::MakeSphere(Vector(9.0, 10.0, 16.0), 6.0, 16));
  const auto filter = MakeFilter(mmmtest::ToMesh(surface), MakeGrid());
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfBoundaryEdges(), 3u);
  EXPECT_EQ(filter->GetNumberOfTurnedTriangles(), 1u);
  EXPECT_TRUE(filter->GetHasOverlaps());
  EXPECT_NEAR(filter->GetOvershoot(), 16.0 + 6.0 - 19.5, 1e-6);
  EXPECT_GT(filter->GetNumberOfVoxelsInside(), 904u);
}

TEST(TriangleSurfaceToDistanceImageFilter, RefusesAHemisphereAndSaysWhereItIsOpen)
{
  ExpectError(mmmtest::MakeSphere(Centre, 6.0, 16, [](const Vector & x) { return x[2] < 0.0; }),
              "The surface is open and encloses nothing for sure: 64 edges have one triangle only, for instance at [");
}

TEST(TriangleSurfaceToDistanceImageFilter, RefusesWhatIsNoSurface)
{
  ExpectError({}, "The surface has no triangles.");
  auto surface = mmmtest::MakeSphere(Centre, 6.0, 4);
  ExpectError(mmmtest::MakeSphere(Centre + Vector(100.0, 0.0, 0.0), 6.0, 4), "lies outside the image.");
  surface.points[3][1] = std::numeric_limits<double>::quiet_NaN();
  ExpectError(surface, "Coordinates must be finite numbers.");
}

TEST(TriangleSurfaceToDistanceImageFilter, RefusesOtherCells)
{
  const auto                mesh = mmmtest::ToMesh(mmmtest::MakeSphere(Centre, 6.0, 4));
  MeshType::CellAutoPointer cell;
  cell.TakeOwnership(new itk::QuadrilateralCell<MeshType::CellType>);
  mesh->SetCell(mesh->GetNumberOfCells(), cell);
  const auto filter = MakeFilter(mesh, MakeGrid());
  mmmtest::ExpectException([&] { filter->Update(); }, "has 4 points. A surface of triangles is needed.");
}

TEST(TriangleSurfaceToDistanceImageFilter, NeedsAGridAndAPositiveBand)
{
  const auto mesh = mmmtest::ToMesh(mmmtest::MakeSphere(Centre, 6.0, 4));
  const auto without = MakeFilter(mesh, nullptr);
  mmmtest::ExpectException([&] { without->Update(); }, "There is no ReferenceImage");
  const auto filter = MakeFilter(mesh, MakeGrid());
  filter->SetBandWidth(0.0);
  mmmtest::ExpectException([&] { filter->Update(); }, "The band width is 0 mm.");
}
