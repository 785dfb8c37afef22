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
#include "support/TestMeasures.h"

#include <gtest/gtest.h>

using mmm::Cell;
using mmm::Vector;
using mmmtest::Digitize;
using mmmtest::MakeMaterials;
using mmmtest::Scene;

namespace
{
constexpr int Rays = 5000;

/** Limits in voxels, percent and degrees. */
void
ExpectSmoothSurface(const mmmtest::Solid & solid, int size)
{
  const Scene scene(Digitize(solid, size));
  const auto  errors = mmmtest::MeasureSurface(*scene.indicators, solid, Rays);
  EXPECT_LT(errors.distance, 0.12);
  EXPECT_LT(std::abs(errors.volume), 0.005);
  EXPECT_LT(errors.normal, 6.0);
}

Eigen::Matrix3d
SomeRotation()
{
  std::mt19937 random(11);
  return mmmtest::RandomRotation(random);
}

/** Three materials that fill a ball, each a third, or an endless cylinder around the same axis. */
mmm::MaterialImage
MakeThirds(int size, const Vector & centre, const Eigen::Matrix3d & frame)
{
  return MakeMaterials({ { size, size, size } }, Vector::Ones(), 3, [=](const Vector & x) {
    const Vector local = frame.transpose() * (x - centre);
    return std::min(2, int((std::atan2(local[1], local[0]) + EIGEN_PI) / (2.0 * EIGEN_PI / 3.0)));
  });
}

void
ExpectFeatureSizes(int                                           size,
                   std::size_t                                   materials,
                   const std::function<int(const Vector &)> &    materialAt,
                   const std::function<double(const Vector &)> & expected)
{
  const Scene scene(MakeMaterials({ { size, size, size } }, Vector::Ones(), materials, materialAt));
  EXPECT_GT(mmmtest::MeasureFeatureSizes(*scene.indicators, expected).within, 0.99);
}
} // namespace

TEST(SurfaceAccuracy, Sphere)
{
  ExpectSmoothSurface(mmmtest::Ellipsoid(Vector(14.3, 14.9, 14.6), SomeRotation(), Vector::Constant(10.0)), 30);
}

TEST(SurfaceAccuracy, Ellipsoid)
{
  ExpectSmoothSurface(mmmtest::Ellipsoid(Vector(18.3, 18.9, 18.6), SomeRotation(), Vector(15.0, 12.0, 9.0)), 38);
}

TEST(SurfaceAccuracy, Torus)
{
  ExpectSmoothSurface(mmmtest::Torus(Vector(23.3, 23.9, 23.6), SomeRotation(), 15.0, 6.0), 48);
}

TEST(JunctionAccuracy, CurveWhereThreeMaterialsMeetAt120Degrees)
{
  const Vector                           centre(15.2, 15.7, 15.4);
  const Eigen::Matrix3d                  frame = SomeRotation();
  const Scene                            scene(MakeThirds(32, centre, frame));
  std::vector<std::pair<Vector, Vector>> line;
  for (double t = -9.0; t < 9.0; t += 0.2)
  {
    line.push_back({ centre + t * frame.col(2), frame.col(2) });
  }
  EXPECT_LT(mmmtest::MeasureTripleCurve(*scene.indicators, Cell{ 0, 1, 2 }, line), 0.2);
}

TEST(FeatureSizeAccuracy, Sphere)
{
  for (const double radius : { 5.0, 10.0 })
  {
    const Vector centre(14.3, 14.9, 14.6);
    ExpectFeatureSizes(
      30,
      2,
      [=](const Vector & x) { return (x - centre).norm() < radius ? 1 : 0; },
      [=](const Vector &) { return radius; });
  }
}

TEST(FeatureSizeAccuracy, Cylinder)
{
  const Vector centre(17.3, 17.9, 17.6);
  const Vector axis = Vector(0.2, 0.3, 1.0).normalized();
  ExpectFeatureSizes(
    36,
    2,
    [=](const Vector & x) { return (x - centre).cross(axis).norm() < 6.0 ? 1 : 0; },
    [=](const Vector & x) { return std::abs((x - centre).dot(axis)) < 2.0 ? 6.0 : 0.0; });
}

TEST(FeatureSizeAccuracy, Torus)
{
  const mmmtest::Torus torus(Vector(22.3, 22.9, 22.6), SomeRotation(), 13.0, 5.0);
  ExpectFeatureSizes(
    46, 2, [&](const Vector & x) { return torus.Contains(x) ? 1 : 0; }, [](const Vector &) { return 5.0; });
}

TEST(FeatureSizeAccuracy, SlabsOfAnyThicknessAndDirectionBetweenTwoMaterials)
{
  const Vector centre = Vector::Constant(18.0);
  for (const Vector & direction : { Vector(1.0, 0.0, 0.0), Vector(0.7, 0.4, 0.6), Vector(0.2, -0.9, 0.5) })
  {
    const Vector normal = direction.normalized();
    for (const double thickness : { 1.5, 2.0, 4.0, 8.0 })
    {
      ExpectFeatureSizes(
        37,
        3,
        [=](const Vector & x) {
          const double depth = (x - centre).dot(normal) + 0.13 + 0.5 * thickness;
          return depth < 0.0 ? 0 : (depth < thickness ? 1 : 2);
        },
        [=](const Vector & x) { return (x - centre).lpNorm<Eigen::Infinity>() < 9.0 ? 0.5 * thickness : 0.0; });
    }
  }
}

TEST(FeatureSizeAccuracy, TwoPlates)
{
  const Vector centre = Vector::Constant(18.0);
  const Vector normal = Vector(0.7, 0.4, 0.6).normalized();
  const auto   depth = [=](const Vector & x) { return std::abs((x - centre).dot(normal)); };
  ExpectFeatureSizes(
    37,
    2,
    [=](const Vector & x) { return depth(x) > 1.5 && depth(x) < 6.5 ? 1 : 0; },
    [=](const Vector & x) {
      return (x - centre).lpNorm<Eigen::Infinity>() > 9.0 ? 0.0 : (depth(x) < 4.0 ? 1.5 : 2.5);
    });
}

TEST(FeatureSizeAccuracy, DoesNotCollapseAlongJunctions)
{
  const Vector centre = Vector::Constant(18.0);
  const Scene  scene(MakeThirds(37, centre, SomeRotation()));
  const auto   samples = mmm::CollectInterfaceSamples(*scene.indicators, -1);
  const auto   axis = mmm::ComputeMedialAxis(*scene.indicators, samples);
  const auto   sizes = mmm::ComputeLocalFeatureSizes(scene.image.grid, samples, axis);
  for (std::size_t s = 0; s < samples.size(); ++s)
  {
    if ((samples[s].position - centre).lpNorm<Eigen::Infinity>() < 9.0)
    {
      EXPECT_GT(sizes[s], 4.0);
    }
  }
}

TEST(GradientLimitAccuracy, AgreesWithBruteForceForRandomSources)
{
  mmm::Grid grid;
  grid.size = { { 24, 20, 22 } };
  grid.spacing = Vector(1.0, 1.7, 1.3);
  std::mt19937                          random(5);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  for (const int count : { 10, 2000 })
  {
    std::vector<mmm::Source> sources(count);
    for (auto & source : sources)
    {
      for (int a = 0; a < 3; ++a)
      {
        source.position[a] = float((grid.size[a] - 1) * grid.spacing[a]) * unit(random);
      }
      source.value = 1.0f + 9.0f * unit(random);
    }
    for (const double slope : { 0.2, 1.0 })
    {
      const auto errors = mmmtest::MeasurePropagation(grid, sources, slope);
      EXPECT_LT(errors.excess, 0.01);
      EXPECT_LT(errors.slope, 1.01);
    }
  }
}
