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
#include "indicators/BoxDistance.h"
#include "support/TestScenes.h"

#include <gtest/gtest.h>

using mmm::Cell;
using mmm::Vector;
using mmmtest::MakeBallMaterials;
using mmmtest::MakeMaterials;
using mmmtest::Scene;
using mmmtest::SpherePoints;

namespace
{
const Vector     Centre(15.13, 14.79, 15.37);
constexpr double Radius = 10.3;

/** Materials 0, 1 and 2 meet in a straight line along z, at 120 degrees. */
mmm::MaterialImage
MakeThreeSectors()
{
  return MakeMaterials({ { 24, 24, 12 } }, Vector::Ones(), 3, [](const Vector & x) {
    const double angle = std::atan2(x[1] - 11.6, x[0] - 11.3) + EIGEN_PI;
    return std::min(2, int(angle / (2.0 * EIGEN_PI / 3.0)));
  });
}
} // namespace

TEST(BoxDistance, IsExactForAnisotropicVoxels)
{
  const Vector spacing(1.0, 2.0, 1.5);
  const auto   image = MakeMaterials(
    { { 9, 9, 9 } }, spacing, 2, [&](const Vector & x) { return (x - Vector(4.0, 8.0, 6.0)).norm() < 1e-6 ? 1 : 0; });
  mmm::LevelSet distance({ { 0, 0, 0 } }, { { 9, 9, 9 } }, spacing, 3.0);
  mmm::ComputeBoxDistance(image, 1, distance);
  // the one voxel's box is 1 x 2 x 1.5 wide; its nearest face is half a voxel away along x
  EXPECT_FLOAT_EQ(distance.Values()[distance.Offset({ { 4, 4, 4 } })], 0.5f);
  EXPECT_FLOAT_EQ(distance.Values()[distance.Offset({ { 5, 4, 4 } })], -0.5f);
  EXPECT_FLOAT_EQ(distance.Values()[distance.Offset({ { 4, 5, 4 } })], -1.0f);
  EXPECT_FLOAT_EQ(distance.Values()[distance.Offset({ { 6, 5, 5 } })], -float(std::sqrt(2.25 + 1.0 + 0.5625)));
  EXPECT_FLOAT_EQ(distance.Values()[distance.Offset({ { 8, 4, 4 } })], -3.0f);
}

TEST(SmoothIndicator, FollowsADigitizedSphereToATenthOfAVoxel)
{
  const Scene scene(MakeBallMaterials(31, Centre, Radius));
  double      squares = 0.0;
  double      normals = 0.0;
  const auto  directions = SpherePoints(2000);
  for (const Vector & direction : directions)
  {
    Vector x = Centre + Radius * direction;
    ASSERT_TRUE(scene.indicators->Project(Cell{ 0, 1 }, x, 2.0));
    squares += std::pow((x - Centre).norm() - Radius, 2);
    const double cosine = scene.indicators->Normal(Cell{ 0, 1 }, x).dot((Centre - x).normalized());
    normals += std::pow(std::acos(std::min(1.0, cosine)), 2);
  }
  EXPECT_LT(std::sqrt(squares / directions.size()), 0.12);
  EXPECT_LT(std::sqrt(normals / directions.size()) * 180.0 / EIGEN_PI, 6.0);
}

TEST(SmoothIndicator, KeepsEveryVoxelCentreOnItsSide)
{
  const Scene scene(MakeBallMaterials(31, Centre, Radius));
  EXPECT_EQ(scene.indicators->NodeMaterials(), scene.image.materials);
}

TEST(SmoothIndicator, KeepsASheetOfOneVoxel)
{
  const Scene scene(MakeMaterials({ { 20, 20, 20 } }, Vector::Ones(), 3, [](const Vector & x) {
    const double depth = x[0] + 0.4 * x[1] - 12.0;
    return depth < 0.0 ? 0 : (depth < 1.08 ? 1 : 2);
  }));
  // a line across the sheet meets all three materials in turn, wherever it is
  for (double y = 4.0; y < 15.0; y += 0.7)
  {
    for (double z = 4.0; z < 15.0; z += 1.3)
    {
      bool found = false;
      for (double x = 2.0; x < 17.0; x += 0.05)
      {
        found = found || scene.indicators->MaterialAt(Vector(x, y, z)) == 1;
      }
      EXPECT_TRUE(found) << "at y = " << y << ", z = " << z;
    }
  }
}

TEST(SmoothIndicator, RadiusZeroKeepsTheVoxelFaces)
{
  const Scene scene(MakeMaterials({ { 12, 12, 12 } }, Vector::Ones(), 2, [](const Vector & x) { return x[0] > 5.2; }),
                    0.0);
  Vector      x(5.0, 6.0, 6.0);
  ASSERT_TRUE(scene.indicators->Project(Cell{ 0, 1 }, x, 2.0));
  EXPECT_NEAR(x[0], 5.5, 1e-3);
}

TEST(IndicatorSet, InsideOutsideFunctionsVanishTogetherOnTheirInterface)
{
  const Scene scene(MakeBallMaterials(31, Centre, Radius));
  for (const Vector & direction : SpherePoints(200))
  {
    Vector x = Centre + Radius * direction;
    ASSERT_TRUE(scene.indicators->Project(Cell{ 0, 1 }, x, 2.0));
    EXPECT_NEAR(scene.indicators->InsideOutside(0, x), 0.0, 1e-3);
    EXPECT_NEAR(scene.indicators->InsideOutside(1, x), 0.0, 1e-3);
    EXPECT_NEAR(scene.indicators->CellIndicator(Cell{ 0, 1 }, x), 0.0, 1e-5);
    EXPECT_GT(scene.indicators->InsideOutside(1, x - 0.5 * direction), 0.3);
    EXPECT_LT(scene.indicators->InsideOutside(1, x + 0.5 * direction), -0.3);
    EXPECT_GT(scene.indicators->CellIndicator(Cell{ 0, 1 }, x + 0.5 * direction), 0.1);
  }
}

TEST(IndicatorSet, ProjectsOnTheCurveWhereThreeMaterialsMeet)
{
  const Scene scene(MakeThreeSectors());
  for (double z = 3.0; z < 9.0; z += 0.5)
  {
    Vector x(11.0, 12.2, z);
    ASSERT_TRUE(scene.indicators->Project(Cell{ 0, 1, 2 }, x, 3.0));
    EXPECT_NEAR(scene.indicators->CellIndicator(Cell{ 0, 1, 2 }, x), 0.0, 1e-5);
    EXPECT_LT(std::hypot(x[0] - 11.3, x[1] - 11.6), 0.5);
    EXPECT_GT(std::abs(scene.indicators->Tangent(Cell{ 0, 1, 2 }, x)[2]), 0.9);
    EXPECT_TRUE(scene.indicators->IsMaximal(Cell{ 0, 1, 2 }, x, 1e-2));
  }
}

TEST(IndicatorSet, FindsNoCurveFromOutsideOfTheBand)
{
  // materials 0 and 1 meet at x = 11.5; their functions are constant further away than the band is wide
  const Scene scene(MakeMaterials({ { 24, 12, 12 } }, Vector::Ones(), 2, [](const Vector & x) { return x[0] > 11.5; }));
  Vector      near(12.0, 6.0, 6.0);
  Vector      far(2.0, 6.0, 6.0);
  const Cell  surface{ 0, 1 };
  EXPECT_TRUE(scene.indicators->ProjectWhereMaximal(surface, near, 1.0));
  EXPECT_FALSE(scene.indicators->ProjectWhereMaximal(surface, far, 1.0));
  const mmm::Material lowerFace = scene.indicators->Planes().At(4);
  near[2] = far[2] = -0.4;
  EXPECT_TRUE(scene.indicators->ProjectWhereMaximal(Cell{ 0, 1, lowerFace }, near, 1.0));
  EXPECT_FALSE(scene.indicators->ProjectWhereMaximal(Cell{ 0, 1, lowerFace }, far, 1.0));
}

TEST(IndicatorSet, GradientsAreThoseOfTheValues)
{
  const Scene  scene(MakeThreeSectors());
  const double step = 1e-5;
  for (const Vector & x : { Vector(11.2, 11.9, 5.3), Vector(8.1, 9.7, 4.6), Vector(0.2, 11.1, 10.9) })
  {
    Vector gradient;
    scene.indicators->ValueAndGradient(1, x, gradient);
    for (int a = 0; a < 3; ++a)
    {
      const Vector d = step * Vector::Unit(a);
      EXPECT_NEAR(
        gradient[a], (scene.indicators->Value(1, x + d) - scene.indicators->Value(1, x - d)) / (2.0 * step), 1e-4);
    }
  }
}

TEST(IndicatorSet, PlanesOwnWhatIsOutsideOfTheBox)
{
  const Scene scene(MakeThreeSectors());
  EXPECT_EQ(scene.indicators->MaterialAt(Vector(-0.6, 5.0, 5.0)), 3);
  EXPECT_EQ(scene.indicators->MaterialAt(Vector(5.0, 5.0, 11.6)), 8);
  EXPECT_LT(scene.indicators->MaterialAt(Vector(-0.4, 5.0, 5.0)), 3);
  Vector x(-0.2, 11.6, 5.0);
  ASSERT_TRUE(scene.indicators->Project(Cell{ 0, 2, 3 }, x, 2.0));
  EXPECT_EQ(x[0], -0.5);
}
