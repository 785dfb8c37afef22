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
#include "sizing/MedialAxis.h"
#include "sizing/SizingField.h"
#include "sizing/SourcePropagation.h"
#include "support/TestScenes.h"

#include <gtest/gtest.h>

#include <random>

using mmm::Vector;
using mmmtest::MakeBallMaterials;
using mmmtest::MakeMaterials;
using mmmtest::Scene;

namespace
{
/** The sizes that only the local feature size decides. */
std::vector<float>
FeatureSizes(const Scene & scene)
{
  mmm::SizingParameters parameters;
  parameters.epsilon = 1.0;
  parameters.chordTolerance = 1e6;
  parameters.minimumSize = 1e-3;
  parameters.gradientLimit = 1.0;
  mmm::Monitor monitor;
  return mmm::ComputeSizing(*scene.indicators, 0, parameters, {}, monitor);
}
} // namespace

TEST(SourcePropagation, AgreesWithTheMinimumOverAllSources)
{
  mmm::Grid grid;
  grid.size = { { 14, 11, 17 } };
  grid.spacing = Vector(1.0, 1.5, 1.2);
  std::mt19937                          random(7);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  std::vector<mmm::Source>              sources(40);
  for (auto & source : sources)
  {
    source.position = Eigen::Vector3f(13.0f * unit(random), 15.0f * unit(random), 19.2f * unit(random));
    source.value = 1.0f + 4.0f * unit(random);
  }
  const double slope = 0.5;
  const auto   field = mmm::PropagateSources(grid, sources, slope);
  for (std::size_t n = 0; n < field.values.size(); ++n)
  {
    const Eigen::Vector3f x = grid.Position(grid.IndexAt(n)).cast<float>();
    double                smallest = 1e30;
    for (const auto & source : sources)
    {
      smallest = std::min(smallest, source.value + slope * (x - source.position).norm());
    }
    EXPECT_GE(field.values[n], smallest - 1e-4);
    EXPECT_LE(field.values[n], 1.05 * smallest);
  }
}

TEST(Sizing, LocalFeatureSizeOfALayerIsHalfItsThickness)
{
  for (const double thickness : { 1.0, 2.0, 4.0, 7.0 })
  {
    const Scene scene(MakeMaterials({ { 28, 24, 24 } }, Vector::Ones(), 3, [=](const Vector & x) {
      return x[0] < 9.5 ? 0 : (x[0] < 9.5 + thickness ? 1 : 2);
    }));
    const auto  sizes = FeatureSizes(scene);
    EXPECT_NEAR(sizes[scene.image.grid.Offset(10, 12, 12)], 0.5 * thickness, 0.5 + 0.1 * thickness) << thickness;
  }
}

TEST(Sizing, LocalFeatureSizeOfABallIsItsRadius)
{
  const Vector centre(20.1, 19.8, 20.3);
  const Scene  scene(MakeBallMaterials(41, centre, 10.0));
  const auto   sizes = FeatureSizes(scene);
  for (const Vector & direction : mmmtest::SpherePoints(100))
  {
    const Vector x = centre + 10.0 * direction;
    const auto   n = scene.image.grid.Offset(int(std::lround(x[0])), int(std::lround(x[1])), int(std::lround(x[2])));
    EXPECT_NEAR(sizes[n], 10.0, 2.0);
  }
}

TEST(Sizing, ChordToleranceBoundsTheSizeOnABall)
{
  const Vector          centre(15.1, 14.8, 15.3);
  const Scene           scene(MakeBallMaterials(31, centre, 10.0));
  mmm::SizingParameters parameters;
  parameters.epsilon = 1e6;
  parameters.gradientLimit = 1e-3;
  mmm::Monitor monitor;
  const auto   sizes = mmm::ComputeSizing(*scene.indicators, 0, parameters, {}, monitor);
  const double expected = std::sqrt(8.0 * 0.1 * 10.0);
  EXPECT_LT(sizes[scene.image.grid.Offset(15, 15, 25)], 1.05 * expected);
  EXPECT_GT(sizes[scene.image.grid.Offset(15, 15, 25)], 0.5 * expected);
}

namespace
{
/** A slab in the middle of voxels that are long along two axes, so that the image is large and cheap. */
Scene
MakeLargeSlab()
{
  return Scene(MakeMaterials({ { 60, 24, 24 } }, Vector(1.0, 10.0, 10.0), 2, [](const Vector & x) {
    return std::abs(x[0] - 30.0) < 25.0 ? 1 : 0;
  }));
}

std::vector<float>
SizesWithMaximum(const Scene & scene, double minimum, double maximum)
{
  mmm::SizingParameters parameters;
  parameters.minimumSize = minimum;
  parameters.maximumSize = maximum;
  mmm::Monitor monitor;
  return mmm::ComputeSizing(*scene.indicators, 0, parameters, {}, monitor);
}

constexpr double DefaultMaximum = std::numeric_limits<double>::quiet_NaN();
} // namespace

TEST(Sizing, DefaultMaximumIsA25thPartOfTheCubeRootOfWhatIsMeshed)
{
  const Scene  scene = MakeLargeSlab();
  const double meshed = 49.0 * 240.0 * 240.0;
  EXPECT_NEAR(mmm::DefaultMaximumSize(*scene.indicators, 0), std::cbrt(meshed) / 25.0, 1e-6);
  const double all = 60.0 * 240.0 * 240.0;
  EXPECT_NEAR(mmm::DefaultMaximumSize(*scene.indicators, -1), std::cbrt(all) / 25.0, 1e-6);

  const auto sizes = SizesWithMaximum(scene, 1.0, DefaultMaximum);
  EXPECT_FLOAT_EQ(*std::max_element(sizes.begin(), sizes.end()), float(std::cbrt(meshed) / 25.0));
}

TEST(Sizing, DefaultMaximumOfSmallImagesIsThreeVoxels)
{
  const Scene scene(MakeBallMaterials(21, Vector(10.1, 9.8, 10.3), 8.0));
  EXPECT_EQ(mmm::DefaultMaximumSize(*scene.indicators, 0), 3.0);
}

TEST(Sizing, DefaultMaximumYieldsToTheMinimum)
{
  const auto sizes = SizesWithMaximum(MakeLargeSlab(), 9.0, DefaultMaximum);
  EXPECT_FLOAT_EQ(*std::max_element(sizes.begin(), sizes.end()), 9.0f);
}

TEST(Sizing, GradientIsLimited)
{
  const Scene           scene(MakeMaterials({ { 30, 30, 30 } }, Vector::Ones(), 3, [](const Vector & x) {
    return x[0] + 0.3 * x[1] < 12.0 ? 0 : (x[0] + 0.2 * x[2] < 17.0 ? 1 : 2);
  }));
  mmm::SizingParameters parameters;
  mmm::Monitor          monitor;
  const auto            sizes = mmm::ComputeSizing(*scene.indicators, 0, parameters, {}, monitor);
  const auto &          grid = scene.image.grid;
  for (int k = 0; k + 1 < 30; ++k)
  {
    for (int j = 0; j + 1 < 30; ++j)
    {
      for (int i = 0; i + 1 < 30; ++i)
      {
        const float h = sizes[grid.Offset(i, j, k)];
        EXPECT_LE(std::abs(sizes[grid.Offset(i + 1, j, k)] - h), 0.5 * 1.01);
        EXPECT_LE(std::abs(sizes[grid.Offset(i, j + 1, k)] - h), 0.5 * 1.01);
        EXPECT_LE(std::abs(sizes[grid.Offset(i, j, k + 1)] - h), 0.5 * 1.01);
        EXPECT_GE(h, 1.0f - 1e-5f);
      }
    }
  }
}

TEST(Sizing, UserSizesAreNotExceeded)
{
  const Scene           scene(MakeBallMaterials(25, Vector(12.1, 11.9, 12.2), 8.0));
  mmm::SizingParameters parameters;
  mmm::Monitor          monitor;
  mmm::SizingControl    user;
  user.image.assign(scene.image.grid.NumberOfNodes(), 100.0f);
  user.image[scene.image.grid.Offset(12, 12, 12)] = 0.7f;
  const auto sizes = mmm::ComputeSizing(*scene.indicators, 0, parameters, user, monitor);
  EXPECT_NEAR(sizes[scene.image.grid.Offset(12, 12, 12)], 0.7f, 1e-5f);
  EXPECT_NEAR(sizes[scene.image.grid.Offset(13, 12, 12)], 1.2f, 1e-4f);
}

TEST(SizingField, IsLoweredAroundPlacesAndNowhereElse)
{
  constexpr float Far = 4.0f;
  constexpr float Small = 0.5f;
  mmm::Grid       grid;
  grid.size = { { 20, 15, 12 } };
  grid.spacing = Vector(1.0, 1.0, 2.0);
  const std::vector<float> sizes(grid.NumberOfNodes(), Far);
  const mmm::SizingField   wanted(grid, sizes.data());
  mmm::SizingField         lowered = wanted;
  const Vector             place(3.2, 14.0, 9.0); // at the border
  lowered.Lower({ place }, Small, 0.5, 4.0);
  for (std::size_t n = 0; n < grid.NumberOfNodes(); ++n)
  {
    const mmm::Index node = grid.IndexAt(n);
    const Vector     offset = grid.Position(node) - place;
    const float      around = std::min(Far, float(Small + 0.5 * offset.norm()));
    EXPECT_EQ(wanted.AtNode(node), Far);
    if (offset.cwiseAbs().maxCoeff() < 3.0)
    {
      EXPECT_EQ(lowered.AtNode(node), around);
    }
    else if (offset.cwiseAbs().maxCoeff() > 6.0)
    {
      EXPECT_EQ(lowered.AtNode(node), Far);
    }
  }
}
