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
#include "image/SliceInterpolation.h"

#include "support/TestScenes.h"

#include "gtest/gtest.h"

#include <cmath>
#include <functional>

using mmm::Index;
using mmm::Material;
using mmm::MaterialImage;
using mmm::Vector;

namespace
{
constexpr int Thickness = 5;

/** Slices of that thickness across the third axis, of what is at the middles of their voxels. */
MaterialImage
MakeSlices(const Index & size, int thickness, const std::function<int(const Vector &)> & materialAt)
{
  return mmmtest::MakeMaterials(size, Vector(1.0, 1.0, thickness), 4, materialAt);
}

/** Where a voxel of the divided image is in the frame of the image: the box stays. */
Vector
PlaceOf(const MaterialImage & fine, const Index & at, int thickness)
{
  Vector x = fine.grid.Position(at);
  x[2] += 0.5 * (fine.grid.spacing[2] - thickness);
  return x;
}

/** The share of voxels that have the material that is at their middle, between the first slice and the last one. */
double
Agreement(const MaterialImage & fine, int thickness, const std::function<int(const Vector &)> & materialAt)
{
  const double end = fine.grid.size[2] * fine.grid.spacing[2] - thickness;
  double       all = 0.0;
  double       same = 0.0;
  for (std::size_t n = 0; n < fine.materials.size(); ++n)
  {
    const Vector x = PlaceOf(fine, fine.grid.IndexAt(n), thickness);
    if (x[2] >= 0.0 && x[2] <= end)
    {
      ++all;
      same += fine.materials[n] == materialAt(x);
    }
  }
  return same / all;
}

MaterialImage
Mirrored(MaterialImage image)
{
  const MaterialImage original = image;
  for (std::size_t n = 0; n < image.materials.size(); ++n)
  {
    Index at = image.grid.IndexAt(n);
    at[2] = image.grid.size[2] - 1 - at[2];
    image.materials[n] = original.materials[original.grid.Offset(at)];
  }
  return image;
}

/** The third axis becomes the first one. */
MaterialImage
Turned(const MaterialImage & image)
{
  MaterialImage turned = image;
  turned.grid.size = { { image.grid.size[2], image.grid.size[0], image.grid.size[1] } };
  turned.grid.spacing = Vector(image.grid.spacing[2], image.grid.spacing[0], image.grid.spacing[1]);
  for (std::size_t n = 0; n < image.materials.size(); ++n)
  {
    const Index at = image.grid.IndexAt(n);
    turned.materials[turned.grid.Offset(at[2], at[0], at[1])] = image.materials[n];
  }
  return turned;
}

/** Shells around a place off the middle, and a rod that ends. */
int
Shells(const Vector & x)
{
  const double r = (x - Vector(19.3, 20.1, 24.0)).norm();
  return r < 9.0 ? 1 : r < 12.0 ? 2 : r < 17.0 ? 3 : std::hypot(x[0] - 3.0, x[1] - 4.0) < 2.5 && x[2] < 18.0 ? 1 : 0;
}

std::size_t
VoxelsOf(const MaterialImage & image, Material material)
{
  return std::size_t(std::count(image.materials.begin(), image.materials.end(), material));
}
} // namespace

TEST(SliceInterpolation, MiddlesOfSlicesStay)
{
  const auto image = MakeSlices({ { 40, 40, 10 } }, Thickness, Shells);
  const auto fine = mmm::InterpolateSlices(image, 2, Thickness);
  ASSERT_EQ(fine.grid.size, (Index{ { 40, 40, 50 } }));
  EXPECT_EQ(fine.grid.spacing, Vector::Ones());
  for (std::size_t n = 0; n < image.materials.size(); ++n)
  {
    const Index at = image.grid.IndexAt(n);
    ASSERT_EQ(fine.materials[fine.grid.Offset(at[0], at[1], Thickness * at[2] + Thickness / 2)], image.materials[n]);
  }
}

TEST(SliceInterpolation, NothingChangesBeyondTheOuterMiddles)
{
  const auto fine = mmm::InterpolateSlices(MakeSlices({ { 40, 40, 3 } }, 4, Shells), 2, 4);
  for (const int pair : { 0, 10 })
  {
    for (int j = 0; j < 40; ++j)
    {
      for (int i = 0; i < 40; ++i)
      {
        ASSERT_EQ(fine.materials[fine.grid.Offset(i, j, pair)], fine.materials[fine.grid.Offset(i, j, pair + 1)]);
      }
    }
  }
}

TEST(SliceInterpolation, AnyAxisIsTheSame)
{
  const auto image = MakeSlices({ { 40, 40, 10 } }, Thickness, Shells);
  const auto fine = mmm::InterpolateSlices(Turned(image), 0, Thickness);
  EXPECT_EQ(fine.materials, Turned(mmm::InterpolateSlices(image, 2, Thickness)).materials);
}

TEST(SliceInterpolation, MirroredImagesAreMirrored)
{
  const auto image = MakeSlices({ { 40, 40, 10 } }, 4, Shells);
  EXPECT_EQ(mmm::InterpolateSlices(Mirrored(image), 2, 4).materials,
            Mirrored(mmm::InterpolateSlices(image, 2, 4)).materials);
}

TEST(SliceInterpolation, SlantedBordersMoveEvenly)
{
  const auto slanted = [](const Vector & x) { return x[0] + 0.3 * x[1] - 1.4 * x[2] < 2.2 ? 1 : 0; };
  const auto image = MakeSlices({ { 80, 20, 10 } }, Thickness, slanted);
  EXPECT_GT(Agreement(mmm::InterpolateSlices(image, 2, Thickness), Thickness, slanted), 0.995);
}

TEST(SliceInterpolation, ThinLayersThatShiftByMoreThanTheirThicknessStayWhole)
{
  // two voxels thick, seven further in each slice
  const auto layers = [](const Vector & x) {
    const double depth = x[0] - 1.4 * x[2];
    return depth < 2.2 ? 1 : depth < 4.2 ? 2 : 3;
  };
  const auto image = MakeSlices({ { 90, 12, 10 } }, Thickness, layers);
  const auto fine = mmm::InterpolateSlices(image, 2, Thickness);
  EXPECT_GT(Agreement(fine, Thickness, layers), 0.99);
  for (std::size_t n = 0; n + 1 < fine.materials.size(); ++n)
  {
    const Index at = fine.grid.IndexAt(n);
    if (at[0] + 1 < fine.grid.size[0])
    {
      ASSERT_FALSE(fine.materials[n] == 1 && fine.materials[n + 1] == 3) << at[0] << ' ' << at[1] << ' ' << at[2];
    }
  }
}

TEST(SliceInterpolation, BallsAreRounderThanTheirSlices)
{
  const auto ball = [](const Vector & x) { return (x - Vector(24.6, 25.2, 26.0)).norm() < 19.0 ? 1 : 0; };
  const auto image = MakeSlices({ { 50, 50, 11 } }, Thickness, ball);
  const auto fine = mmm::InterpolateSlices(image, 2, Thickness);
  const auto repeated = [&](const Vector & x) {
    return image.materials[image.grid.Offset(int(x[0]), int(x[1]), int(std::lround(x[2] / Thickness)))];
  };
  const double offBefore =
    1.0 - Agreement(mmmtest::MakeMaterials(fine.grid.size,
                                           fine.grid.spacing,
                                           2,
                                           [&](const Vector & x) { return repeated(Vector(x[0], x[1], x[2] - 2.0)); }),
                    Thickness,
                    ball);
  EXPECT_LT(1.0 - Agreement(fine, Thickness, ball), 0.45 * offBefore);
  EXPECT_NEAR(double(VoxelsOf(fine, 1)) / (4.0 / 3.0 * EIGEN_PI * std::pow(19.0, 3)), 1.0, 0.02);
}

TEST(SliceInterpolation, APartOfASingleSliceBecomesALensOfItsVolume)
{
  const auto disc = [](const Vector & x) {
    return x[2] == 10.0 && std::hypot(x[0] - 20.0, x[1] - 20.0) < 12.0 ? 1 : 0;
  };
  const auto image = MakeSlices({ { 41, 41, 5 } }, Thickness, disc);
  const auto fine = mmm::InterpolateSlices(image, 2, Thickness);
  EXPECT_NEAR(double(VoxelsOf(fine, 1)), double(Thickness * VoxelsOf(image, 1)), 0.05 * Thickness * VoxelsOf(image, 1));
  const auto radiusAt = [&](int k) {
    int radius = 0;
    while (radius < 20 && fine.materials[fine.grid.Offset(20 + radius, 20, k)] == 1)
    {
      ++radius;
    }
    return radius;
  };
  EXPECT_EQ(radiusAt(12), 12);
  for (int away = 1; away < Thickness; ++away)
  {
    EXPECT_EQ(radiusAt(12 + away), radiusAt(12 - away));
    EXPECT_LT(radiusAt(12 + away), radiusAt(12 + away - 1));
  }
}

TEST(SliceInterpolation, FingersKeepTheirVolume)
{
  // in every other slice, between slices where there is a strip of the material further off
  const auto finger = [](const Vector & x) {
    const bool isStrip = x[1] < 4.0;
    const bool isFinger = std::abs(x[0] - 20.0) < 3.0 && x[1] < 20.0 && int(x[2] / Thickness) % 2 == 1;
    return isStrip || isFinger ? 1 : 0;
  };
  const auto image = MakeSlices({ { 41, 41, 9 } }, Thickness, finger);
  const auto fine = mmm::InterpolateSlices(image, 2, Thickness);
  const auto expected = double(Thickness * VoxelsOf(image, 1));
  EXPECT_NEAR(double(VoxelsOf(fine, 1)), expected, 0.08 * expected);
}
