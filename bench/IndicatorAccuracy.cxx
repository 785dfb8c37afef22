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
// Prints how close indicators, local feature sizes and gradient limiting come to what is known of digitized solids.
// Lengths are in voxels. The numbers that come of random offsets and rotations are the same in every run.

#include "support/TestMeasures.h"

#include <cstdio>
#include <string>

using mmm::Vector;
using mmmtest::Scene;

namespace
{
constexpr int Repetitions = 3;
constexpr int Rays = 20000;

using PointsAndTangents = std::vector<std::pair<Vector, Vector>>;

Vector
MiddleOf(int size)
{
  return Vector::Constant(0.5 * (size - 1));
}

void
PrintSurfaces()
{
  std::printf("zero set: largest of %d random places\n", Repetitions);
  std::printf("%-10s %6s %13s %9s %15s %15s\n",
              "solid",
              "radius",
              "RMS distance",
              "volume %",
              "RMS normal deg",
              "voxels' volume %");
  std::mt19937 random(1);
  for (const std::string name : { "sphere", "ellipsoid", "torus" })
  {
    for (const double radius : { 10.0, 15.0, 20.0, 30.0, 40.0 })
    {
      mmmtest::SurfaceErrors largest;
      double                 digitized = 0.0;
      for (int n = 0; n < Repetitions; ++n)
      {
        const int                       size = int(2.0 * radius * (name == "torus" ? 1.4 : 1.0)) + 10;
        const Vector                    centre = MiddleOf(size) + mmmtest::RandomOffset(random);
        const Eigen::Matrix3d           rotation = mmmtest::RandomRotation(random);
        std::unique_ptr<mmmtest::Solid> solid;
        if (name == "torus")
        {
          solid = std::make_unique<mmmtest::Torus>(centre, rotation, radius, 0.4 * radius);
        }
        else
        {
          const Vector ratios = name == "sphere" ? Vector::Ones() : Vector(1.0, 0.8, 0.6);
          solid = std::make_unique<mmmtest::Ellipsoid>(centre, rotation, radius * ratios);
        }
        const Scene  scene(mmmtest::Digitize(*solid, size));
        const auto   errors = mmmtest::MeasureSurface(*scene.indicators, *solid, Rays);
        const auto & materials = scene.image.materials;
        const double voxels = double(std::count(materials.begin(), materials.end(), 1));
        digitized = std::max(digitized, std::abs(voxels / solid->Volume() - 1.0));
        largest.distance = std::max(largest.distance, errors.distance);
        largest.normal = std::max(largest.normal, errors.normal);
        largest.volume = std::max(largest.volume, std::abs(errors.volume));
      }
      std::printf("%-10s %6.0f %13.3f %9.2f %15.2f %15.2f\n",
                  name.c_str(),
                  radius,
                  largest.distance,
                  100.0 * largest.volume,
                  largest.normal,
                  100.0 * digitized);
    }
  }
}

/** Points on a circle, or on the arc of it that lies between two angles. */
PointsAndTangents
Arc(const Vector & centre, const Vector & u, const Vector & v, double radius, double from = 0.0, double to = 6.28)
{
  PointsAndTangents points;
  for (double angle = from; angle < to; angle += 0.02)
  {
    points.push_back(
      { centre + radius * (std::cos(angle) * u + std::sin(angle) * v), std::cos(angle) * v - std::sin(angle) * u });
  }
  return points;
}

void
PrintTripleCurves()
{
  std::printf("\ntriple curve, RMS distance: largest of %d random places\n", Repetitions);
  std::printf("%6s %13s %13s %13s %13s\n", "radius", "halved ball", "double ball", "three, rim", "three, axis");
  std::mt19937 random(2);
  for (const double radius : { 10.0, 15.0, 20.0, 30.0 })
  {
    double largest[4] = { 0.0, 0.0, 0.0, 0.0 };
    for (int n = 0; n < Repetitions; ++n)
    {
      const int             size = int(2.0 * radius) + 10;
      const Vector          centre = MiddleOf(size) + mmmtest::RandomOffset(random);
      const Eigen::Matrix3d frame = mmmtest::RandomRotation(random);
      const Vector          u = frame.col(0);
      const Vector          v = frame.col(1);
      const Vector          w = frame.col(2);
      const auto note = [&](int column, const Scene & scene, const mmm::Cell & cell, const PointsAndTangents & points) {
        largest[column] = std::max(largest[column], mmmtest::MeasureTripleCurve(*scene.indicators, cell, points));
      };
      const mmm::Index sizes{ { size, size, size } };
      const Scene      halves(mmmtest::MakeMaterials(sizes, Vector::Ones(), 3, [&](const Vector & x) {
        return (x - centre).norm() > radius ? 0 : ((x - centre).dot(w) < 0.0 ? 1 : 2);
      }));
      note(0, halves, mmm::Cell{ 0, 1, 2 }, Arc(centre, u, v, radius));

      // two balls whose centres are a radius apart: all angles are 120 degrees
      const double ball = radius / 1.5;
      const Scene  bubbles(mmmtest::MakeMaterials(sizes, Vector::Ones(), 3, [&](const Vector & x) {
        const double side = (x - centre).dot(w) < 0.0 ? -1.0 : 1.0;
        return (x - centre - 0.5 * side * ball * w).norm() > ball ? 0 : (side < 0.0 ? 1 : 2);
      }));
      note(1, bubbles, mmm::Cell{ 0, 1, 2 }, Arc(centre, u, v, ball * std::sqrt(0.75)));

      const Scene  thirds(mmmtest::MakeMaterials(sizes, Vector::Ones(), 4, [&](const Vector & x) {
        const double angle = std::atan2((x - centre).dot(v), (x - centre).dot(u)) + EIGEN_PI;
        return (x - centre).norm() > radius ? 0 : std::min(3, 1 + int(angle / (2.0 * EIGEN_PI / 3.0)));
      }));
      const double margin = 3.0 / radius;
      note(2, thirds, mmm::Cell{ 0, 1, 3 }, Arc(centre, w, -u, radius, margin, EIGEN_PI - margin));
      PointsAndTangents line;
      for (double t = 3.0 - radius; t < radius - 3.0; t += 0.1)
      {
        line.push_back({ centre + t * w, w });
      }
      note(3, thirds, mmm::Cell{ 1, 2, 3 }, line);
    }
    std::printf("%6.0f %13.3f %13.3f %13.3f %13.3f\n", radius, largest[0], largest[1], largest[2], largest[3]);
  }
}

template <typename TMaterialAt, typename TExpected>
void
PrintFeatureSizes(const char *        name,
                  int                 size,
                  std::size_t         materials,
                  const TMaterialAt & at,
                  const TExpected &   expected)
{
  const Scene scene(mmmtest::MakeMaterials({ { size, size, size } }, Vector::Ones(), materials, at));
  const auto  errors = mmmtest::MeasureFeatureSizes(*scene.indicators, expected);
  std::printf("%-34s %9.2f %8.2f %8.2f\n", name, 100.0 * errors.within, errors.low, errors.high);
}

void
PrintAllFeatureSizes()
{
  std::printf("\nlocal feature size: %% of interface samples within the larger of 10 %% and 0.5 voxel\n");
  std::printf("%-34s %9s %8s %8s\n", "", "within %", "low 1 %", "high 1 %");
  std::mt19937 random(3);
  char         name[80];
  for (const double radius : { 5.0, 10.0, 20.0 })
  {
    const int    size = int(2.0 * radius) + 12;
    const Vector centre = MiddleOf(size) + mmmtest::RandomOffset(random);
    std::snprintf(name, sizeof(name), "sphere, radius %g", radius);
    PrintFeatureSizes(
      name,
      size,
      2,
      [&](const Vector & x) { return (x - centre).norm() < radius; },
      [=](const Vector &) { return radius; });

    const int    longSize = size + int(radius);
    const Vector middle = MiddleOf(longSize) + mmmtest::RandomOffset(random);
    const Vector axis = Vector(0.2, 0.3, 1.0).normalized();
    std::snprintf(name, sizeof(name), "cylinder, radius %g", radius);
    const auto nearMiddle = [=](const Vector & x) { return std::abs((x - middle).dot(axis)) < 2.0; };
    PrintFeatureSizes(
      name,
      longSize,
      2,
      [&](const Vector & x) { return (x - middle).cross(axis).norm() < radius; },
      [=](const Vector & x) { return nearMiddle(x) ? radius : 0.0; });

    std::snprintf(name, sizeof(name), "torus, radii %g and %g", 2.5 * radius, radius);
    const int            torusSize = int(7.0 * radius) + 12;
    const mmmtest::Torus torus(
      MiddleOf(torusSize) + mmmtest::RandomOffset(random), mmmtest::RandomRotation(random), 2.5 * radius, radius);
    PrintFeatureSizes(
      name, torusSize, 2, [&](const Vector & x) { return torus.Contains(x); }, [=](const Vector &) { return radius; });
  }
  const int    size = 64;
  const Vector centre = MiddleOf(size);
  const auto   central = [=](const Vector & x) { return (x - centre).lpNorm<Eigen::Infinity>() < 14.0; };
  for (int direction = 0; direction < 4; ++direction)
  {
    const bool   tilted = direction > 0;
    const Vector normal = tilted ? Vector(mmmtest::RandomRotation(random).col(0)) : Vector(Vector::UnitX());
    for (const double thickness : { 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 10.0 })
    {
      if (tilted && thickness < 1.5)
      {
        continue; // has holes when digitized
      }
      const double from = 0.13 - 0.5 * thickness;
      std::snprintf(name, sizeof(name), "slab, thickness %g%s", thickness, tilted ? ", tilted" : "");
      PrintFeatureSizes(
        name,
        size,
        3,
        [&](const Vector & x) {
          const double depth = (x - centre).dot(normal);
          return depth < from ? 0 : (depth < from + thickness ? 1 : 2);
        },
        [=](const Vector & x) { return central(x) ? 0.5 * thickness : 0.0; });
    }
    for (const double gap : { 2.0, 4.0, 8.0 })
    {
      std::snprintf(name, sizeof(name), "two plates of 6, %g apart%s", gap, tilted ? ", tilted" : "");
      PrintFeatureSizes(
        name,
        size,
        2,
        [&](const Vector & x) {
          const double depth = std::abs((x - centre).dot(normal) - 0.13);
          return depth > 0.5 * gap && depth < 0.5 * gap + 6.0;
        },
        [=](const Vector & x) {
          const double depth = std::abs((x - centre).dot(normal) - 0.13);
          return !central(x) ? 0.0 : (depth < 0.5 * gap + 3.0 ? std::min(3.0, 0.5 * gap) : 3.0);
        });
    }
  }
  // the bisectors of the sectors are the axes; near the junction they do not count
  const Vector along = mmmtest::RandomRotation(random).col(2);
  const Vector u = along.unitOrthogonal();
  const Vector v = along.cross(u);
  const Scene  sectors(mmmtest::MakeMaterials({ { size, size, size } }, Vector::Ones(), 3, [&](const Vector & x) {
    const double angle = std::atan2((x - centre).dot(v), (x - centre).dot(u)) + EIGEN_PI;
    return std::min(2, int(angle / (2.0 * EIGEN_PI / 3.0)));
  }));
  const auto   samples = mmm::CollectInterfaceSamples(*sectors.indicators, -1);
  const auto   medial = mmm::ComputeMedialAxis(*sectors.indicators, samples);
  const auto   sizes = mmm::ComputeLocalFeatureSizes(sectors.image.grid, samples, medial);
  float        smallest = 1e30f;
  for (std::size_t s = 0; s < samples.size(); ++s)
  {
    smallest = central(samples[s].position) ? std::min(smallest, sizes[s]) : smallest;
  }
  std::printf("three sectors of 120 degrees: least size %.2f voxels\n", smallest);
}

void
PrintPropagation()
{
  std::printf("\ngradient limiting against brute force\n");
  std::printf("%-28s %6s %14s %14s\n", "sources", "slope", "excess %", "slope / limit");
  std::mt19937                          random(4);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  mmm::Grid                             grid;
  grid.size = { { 40, 36, 44 } };
  for (const bool anisotropic : { false, true })
  {
    grid.spacing = anisotropic ? Vector(1.0, 1.7, 2.3) : Vector(Vector::Ones());
    for (const double slope : { 0.1, 0.5, 1.0 })
    {
      for (const int count : { 10, 300, 5000 })
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
        const auto        errors = mmmtest::MeasurePropagation(grid, sources, slope);
        const std::string name = std::to_string(count) + (anisotropic ? ", anisotropic voxels" : "");
        std::printf("%-28s %6.1f %14.3f %14.4f\n", name.c_str(), slope, 100.0 * errors.excess, errors.slope);
      }
    }
  }
}
} // namespace

int
main(int argc, char ** argv)
{
  const std::string only = argc > 1 ? argv[1] : "";
  if (only.empty() || only == "surfaces")
  {
    PrintSurfaces();
  }
  if (only.empty() || only == "curves")
  {
    PrintTripleCurves();
  }
  if (only.empty() || only == "sizes")
  {
    PrintAllFeatureSizes();
  }
  if (only.empty() || only == "gradients")
  {
    PrintPropagation();
  }
  return 0;
}
