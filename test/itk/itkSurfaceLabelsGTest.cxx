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
// Surfaces on top of label images, in LabelImageToTetrahedralMeshFilter.
#include "itkLabelImageToTetrahedralMeshFilter.h"
#include "itkTetrahedralMeshQualityCalculator.h"
#include "itkTriangleSurfaceToDistanceImageFilter.h"
#include "support/TestLabelImages.h"
#include "support/TestMeshes.h"
#include "support/TestSurfaces.h"

#include <cmath>
#include <functional>
#include <map>
#include <random>

namespace
{
using mmm::Vector;
using LabelImage = itk::Image<short, 3>;
using FilterType = itk::LabelImageToTetrahedralMeshFilter<LabelImage>;
using Surfaces = std::vector<std::pair<int, mmm::TriangleSurface>>;

constexpr int Size = 24;
const Vector  Middle(11.3, 11.6, 11.4);

FilterType::Pointer
MakeFilter(const LabelImage * image, const Surfaces & surfaces)
{
  const auto       filter = FilterType::New();
  std::vector<int> labels;
  filter->SetInput(image);
  for (unsigned int n = 0; n < surfaces.size(); ++n)
  {
    const auto distance = itk::TriangleSurfaceToDistanceImageFilter<>::New();
    distance->SetInput(mmmtest::ToMesh(surfaces[n].second));
    distance->SetReferenceImage(image);
    distance->Update();
    filter->SetSurfaceDistanceImage(n, distance->GetOutput());
    labels.push_back(surfaces[n].first);
  }
  filter->SetSurfaceLabels(labels);
  return filter;
}

LabelImage::Pointer
MakeEmpty()
{
  return mmmtest::MakeImage<LabelImage>(Size, Size, Size, [](int, int, int) { return 0; });
}

std::map<int, double>
VolumesOf(FilterType & filter)
{
  const auto calculator = itk::TetrahedralMeshQualityCalculator<itk::LabelTetrahedralMesh>::New();
  calculator->SetMesh(filter.GetOutput());
  calculator->Compute();
  std::map<int, double> volumes;
  for (const auto & label : calculator->GetReport().labels)
  {
    volumes[label.label] = label.tetrahedra.volume;
  }
  return volumes;
}

/** The root mean square distance of the points of the triangles between two labels, for which isAsked(). */
double
InterfaceError(FilterType &                                  filter,
               int                                           first,
               int                                           last,
               const std::function<double(const Vector &)> & distance,
               const std::function<bool(const Vector &)> &   isAsked)
{
  const auto * surface = filter.GetSurface();
  const auto   points = mmmtest::PointsOf(surface);
  const auto   triangles = mmmtest::CellsOf<3>(surface);
  double       squares = 0.0;
  std::size_t  count = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const auto & sides = surface->GetCellData()->ElementAt(t);
    const Vector middle = (points[triangles[t][0]] + points[triangles[t][1]] + points[triangles[t][2]]) / 3.0;
    if (sides[0] == first && sides[1] == last && isAsked(middle))
    {
      for (const Vector & x : { middle, points[triangles[t][0]] })
      {
        squares += std::pow(distance(x), 2);
        ++count;
      }
    }
  }
  EXPECT_GT(count, 0u);
  return std::sqrt(squares / count);
}

bool
Always(const Vector &)
{
  return true;
}
} // namespace

TEST(SurfaceLabels, InterfaceOfASphereIsTheSurface)
{
  const auto filter = MakeFilter(MakeEmpty(), { { 4, mmmtest::MakeSphere(Middle, 7.0, 40) } });
  filter->Update();
  const auto volumes = VolumesOf(*filter);
  ASSERT_EQ(volumes.size(), 1u);
  EXPECT_NEAR(volumes.at(4) / (4.0 / 3.0 * EIGEN_PI * 343.0), 1.0, 0.015);
  const auto distance = [](const Vector & x) { return (x - Middle).norm() - 7.0; };
  EXPECT_LT(InterfaceError(*filter, 0, 4, distance, Always), 0.1);
}

TEST(SurfaceLabels, LaterSurfacesWin)
{
  const Vector other = Middle + Vector(4.0, 0.0, 0.0);
  const auto   filter = MakeFilter(
    MakeEmpty(), { { 1, mmmtest::MakeSphere(Middle, 6.0, 30) }, { 2, mmmtest::MakeSphere(other, 5.0, 30) } });
  filter->Update();
  auto volumes = VolumesOf(*filter);
  ASSERT_EQ(volumes.size(), 2u);
  EXPECT_NEAR(volumes[2] / (4.0 / 3.0 * EIGEN_PI * 125.0), 1.0, 0.02);
  // between them there is the second surface, whole
  const auto distance = [&](const Vector & x) { return (x - other).norm() - 5.0; };
  EXPECT_LT(InterfaceError(*filter, 1, 2, distance, Always), 0.15);
}

TEST(SurfaceLabels, WinOverTheImageWhoseInterfacesStayElsewhere)
{
  const auto halves = mmmtest::MakeImage<LabelImage>(Size, Size, Size, [](int, int, int k) { return k < 12 ? 1 : 2; });
  const auto filter = MakeFilter(halves, { { 7, mmmtest::MakeSphere(Middle, 6.0, 30) } });
  filter->Update();
  auto         volumes = VolumesOf(*filter);
  const double ball = 4.0 / 3.0 * EIGEN_PI * 216.0;
  ASSERT_EQ(volumes.size(), 3u);
  EXPECT_NEAR(volumes[7] / ball, 1.0, 0.02);
  EXPECT_NEAR(volumes[1] + volumes[2] + volumes[7], std::pow(Size, 3), 1e-6 * std::pow(Size, 3));
  const auto toSphere = [](const Vector & x) { return (x - Middle).norm() - 6.0; };
  EXPECT_LT(InterfaceError(*filter, 1, 7, toSphere, Always), 0.1);
  EXPECT_LT(InterfaceError(*filter, 2, 7, toSphere, Always), 0.1);
  const auto toPlane = [](const Vector & x) { return x[2] - 11.5; };
  EXPECT_LT(InterfaceError(*filter, 1, 2, toPlane, Always), 0.1);
}

TEST(SurfaceLabels, OfALabelOfTheImageAddToIt)
{
  const auto filter = MakeFilter(
    mmmtest::MakeImage<LabelImage>(
      Size, Size, Size, [](int i, int j, int k) { return k < 12 && mmmtest::IsInBall(i, j, k, Size, 9.0) ? 3 : 0; }),
    { { 3, mmmtest::MakeSphere(Middle, 7.0, 30) } });
  filter->Update();
  auto volumes = VolumesOf(*filter);
  ASSERT_EQ(volumes.size(), 1u);
  const double halves = 2.0 / 3.0 * EIGEN_PI * (729.0 + 343.0);
  EXPECT_NEAR(volumes[3] / halves, 1.0, 0.04);
}

TEST(SurfaceLabels, OfAnExteriorLabelCutAway)
{
  const auto filter =
    MakeFilter(mmmtest::MakeBall<LabelImage>(Size, 9.0), { { 6, mmmtest::MakeSphere(Middle, 5.0, 30) } });
  filter->SetExteriorLabels({ 0, 6 });
  filter->Update();
  const auto volumes = VolumesOf(*filter);
  ASSERT_EQ(volumes.size(), 1u);
  EXPECT_NEAR(volumes.at(1) / (4.0 / 3.0 * EIGEN_PI * (729.0 - 125.0)), 1.0, 0.03);
  const auto distance = [](const Vector & x) { return (x - Middle).norm() - 5.0; };
  EXPECT_LT(InterfaceError(*filter, 0, 1, distance, [](const Vector & x) { return (x - Middle).norm() < 7.0; }), 0.12);
}

TEST(SurfaceLabels, HideLabelsOfTheImageAltogether)
{
  const auto filter =
    MakeFilter(mmmtest::MakeBall<LabelImage>(Size, 4.0), { { 2, mmmtest::MakeSphere(Middle, 7.0, 30) } });
  filter->Update();
  const auto volumes = VolumesOf(*filter);
  ASSERT_EQ(volumes.size(), 1u);
  const auto distance = [](const Vector & x) { return (x - Middle).norm() - 7.0; };
  EXPECT_LT(InterfaceError(*filter, 0, 2, distance, Always), 0.1);
}

TEST(SurfaceLabels, OfFacesThroughVoxelCentresAreMeshed)
{
  // a cube whose faces are where the centres of voxels are
  mmm::TriangleSurface cube;
  for (int corner = 0; corner < 8; ++corner)
  {
    cube.points.emplace_back(corner & 1 ? 17.0 : 6.0, corner & 2 ? 17.0 : 6.0, corner & 4 ? 17.0 : 6.0);
  }
  cube.triangles = { { { 0, 2, 1 } }, { { 1, 2, 3 } }, { { 4, 5, 6 } }, { { 5, 7, 6 } },
                     { { 0, 1, 4 } }, { { 1, 5, 4 } }, { { 2, 6, 3 } }, { { 3, 6, 7 } },
                     { { 0, 4, 2 } }, { { 2, 4, 6 } }, { { 1, 3, 5 } }, { { 3, 7, 5 } } };
  const auto filter = MakeFilter(MakeEmpty(), { { 1, cube } });
  filter->Update();
  // edges are rounded
  EXPECT_GT(VolumesOf(*filter).at(1) / 1331.0, 0.85);
  EXPECT_LT(VolumesOf(*filter).at(1) / 1331.0, 1.0);
  const auto fromMiddle = [](const Vector & x) { return Vector((x - Vector::Constant(11.5)).cwiseAbs()); };
  const auto toFace = [&](const Vector & x) { return fromMiddle(x).maxCoeff() - 5.5; };
  const auto isInFace = [&](const Vector & x) { return (fromMiddle(x).array() > 3.0).count() == 1; };
  EXPECT_LT(InterfaceError(*filter, 0, 1, toFace, isInFace), 0.18);
}

TEST(SurfaceLabels, RandomPairsOfSurfacesAreMeshed)
{
  std::mt19937                           random(7);
  std::uniform_real_distribution<double> draw(-1.0, 1.0);
  for (int pair = 0; pair < 4; ++pair)
  {
    const auto vector = [&] { return Vector(draw(random), draw(random), draw(random)); };
    const auto first = mmmtest::MakeTorus(Middle + vector(), 6.0 + draw(random), 2.5 + 0.5 * draw(random), 40);
    const auto second = mmmtest::MakeSphere(Middle + 4.0 * vector(), 4.5 + draw(random), 16);
    const auto filter = MakeFilter(MakeEmpty(), { { 1, first }, { 2, second } });
    filter->Update();
    const auto volumes = VolumesOf(*filter);
    EXPECT_EQ(volumes.size(), 2u);
    for (const auto & [label, volume] : volumes)
    {
      EXPECT_GT(volume, 50.0) << label;
    }
  }
}

TEST(SurfaceLabels, RefuseWhatDoesNotFit)
{
  const auto sphere = mmmtest::MakeSphere(Middle, 7.0, 8);
  const auto fewer = MakeFilter(MakeEmpty(), { { 1, sphere } });
  fewer->SetSurfaceLabels({});
  mmmtest::ExpectException([&] { fewer->Update(); }, "There are 0 surface labels for 1 surface distance images.");
  const auto more = MakeFilter(MakeEmpty(), { { 1, sphere } });
  more->SetSurfaceLabels({ 1, 2 });
  mmmtest::ExpectException([&] { more->Update(); }, "Surface distance image 1 of 2 is missing.");
  const auto moved = MakeFilter(MakeEmpty(), { { 1, sphere } });
  const auto image = MakeEmpty();
  image->SetOrigin(itk::Vector<double, 3>(1.0).GetDataPointer());
  moved->SetInput(image);
  mmmtest::ExpectException(
    [&] { moved->Update(); },
    "The surface distance image 0 differs from the label image in origin, spacing or direction.");
  const auto tiny = MakeFilter(MakeEmpty(), { { 1, mmmtest::MakeSphere(Vector(10.5, 10.5, 10.5), 0.3, 4) } });
  mmmtest::ExpectException([&] { tiny->Update(); }, "No voxel's centre is within surface 0, of label 1");
}
