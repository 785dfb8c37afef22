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
#include "distance/SurfaceDistance.h"
#include "support/TestSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
using mmm::Vector;

constexpr double Band = 3.0;
constexpr double Radius = 7.0;

const Vector    Centre(10.2, 9.7, 10.4);
const mmm::Grid Cube{ { { 21, 21, 21 } }, Vector::Ones() };

/** The largest error of the distance against a known one, at nodes within the band for which isAsked(). */
template <typename TDistance, typename TAsked>
double
LargestError(mmm::TriangleSurface surface, const TDistance & distance, const TAsked & isAsked)
{
  const auto           defects = mmm::RepairSurface(surface);
  mmm::SurfaceDistance computer(surface, defects);
  mmm::Monitor         monitor;
  const auto           values = computer.Compute(Cube, Band, monitor);
  double               largest = 0.0;
  for (std::size_t n = 0; n < values.size(); ++n)
  {
    const Vector x = Cube.Position(Cube.IndexAt(n));
    const double known = std::min(std::max(distance(x), -Band), Band);
    if (isAsked(x))
    {
      largest = std::max(largest, std::abs(values[n] - known));
    }
  }
  return largest;
}

template <typename TDistance>
double
LargestError(const mmm::TriangleSurface & surface, const TDistance & distance)
{
  return LargestError(surface, distance, [](const Vector &) { return true; });
}

double
DistanceToSphere(const Vector & x)
{
  return Radius - (x - Centre).norm();
}

mmm::TriangleSurface
Turned(mmm::TriangleSurface surface)
{
  for (auto & triangle : surface.triangles)
  {
    std::swap(triangle[0], triangle[1]);
  }
  return surface;
}
} // namespace

TEST(SurfaceDistance, IsThatOfASphere)
{
  EXPECT_LT(LargestError(mmmtest::MakeSphere(Centre, Radius, 40), DistanceToSphere), 0.01);
}

TEST(SurfaceDistance, IsThatOfATorus)
{
  const auto distance = [](const Vector & x) {
    const Vector y = x - Centre;
    return 2.5 - std::hypot(std::hypot(y[0], y[1]) - 6.0, y[2]);
  };
  EXPECT_LT(LargestError(mmmtest::MakeTorus(Centre, 6.0, 2.5, 120), distance), 0.01);
}

TEST(SurfaceDistance, DoesNotMindWhetherNormalsPointInward)
{
  EXPECT_LT(LargestError(Turned(mmmtest::MakeSphere(Centre, Radius, 40)), DistanceToSphere), 0.01);
}

TEST(SurfaceDistance, LeavesACavityOut)
{
  const auto shell =
    mmmtest::Join(mmmtest::MakeSphere(Centre, Radius, 40), Turned(mmmtest::MakeSphere(Centre, 3.0, 20)));
  const auto distance = [](const Vector & x) { return std::min(DistanceToSphere(x), (x - Centre).norm() - 3.0); };
  EXPECT_LT(LargestError(shell, distance), 0.02);
}

TEST(SurfaceDistance, OfPartsThatOverlapIsThatOfTheirUnion)
{
  const Vector other = Centre + Vector(0.0, 0.0, 3.0);
  const auto   both = mmmtest::Join(mmmtest::MakeSphere(Centre, 6.0, 40), mmmtest::MakeSphere(other, 6.0, 40));
  const auto   ball = [](const Vector & x, const Vector & centre) { return 6.0 - (x - centre).norm(); };
  const auto   distance = [&](const Vector & x) { return std::max(ball(x, Centre), ball(x, other)); };
  // inside, the distance to the crease is more than that to either sphere
  const double error =
    LargestError(both, distance, [&](const Vector & x) { return std::abs(x[2] - Centre[2] - 1.5) > 3.0; });
  EXPECT_LT(error, 0.02);
  // no sheet is left within
  const double within =
    LargestError(both, [](const Vector &) { return Band; }, [&](const Vector & x) { return distance(x) > 2.0; });
  EXPECT_LT(within, 1.1);
}

TEST(SurfaceDistance, ClosesASmallHole)
{
  const auto open = mmmtest::MakeSphere(Centre, Radius, 40, [](const Vector & x) { return x[2] < 0.97; });
  // beside the hole as if there were none
  const auto error = LargestError(open, DistanceToSphere, [](const Vector & x) { return x[2] < Centre[2] + 3.0; });
  EXPECT_LT(error, 0.4);
  const auto sign = LargestError(
    open,
    [](const Vector & x) { return DistanceToSphere(x) > 0.0 ? Band : -Band; },
    [](const Vector & x) { return std::abs(DistanceToSphere(x)) > 1.0; });
  EXPECT_LT(sign, Band);
}

TEST(SurfaceDistance, DoubtsAHemisphere)
{
  const auto doubt = [](double height) {
    auto surface = mmmtest::MakeSphere(Centre, Radius, 20, [=](const Vector & x) { return x[2] < height; });
    mmm::SurfaceDistance distance(surface, mmm::RepairSurface(surface));
    mmm::Monitor         monitor;
    distance.Compute(Cube, Band, monitor);
    return distance.GetDoubt();
  };
  EXPECT_GT(doubt(0.0), 0.15);
  EXPECT_LT(doubt(0.9), 0.1);
  EXPECT_LT(doubt(2.0), 0.01);
}

TEST(SurfaceDistance, OfVoxelsThatAreLongerThanTheBandHasTheRightSign)
{
  auto                 surface = mmmtest::MakeSphere(Centre, Radius, 20);
  const auto           defects = mmm::RepairSurface(surface);
  mmm::SurfaceDistance distance(surface, defects);
  mmm::Monitor         monitor;
  const mmm::Grid      grid{ { { 6, 21, 21 } }, Vector(4.0, 1.0, 1.0) };
  const auto           values = distance.Compute(grid, 1.0, monitor);
  for (std::size_t n = 0; n < values.size(); ++n)
  {
    const double known = DistanceToSphere(grid.Position(grid.IndexAt(n)));
    if (std::abs(known) > 0.1)
    {
      EXPECT_EQ(values[n] > 0.0f, known > 0.0);
    }
  }
}

TEST(TriangleSurface, JoinsPointsAndTurnsTrianglesAsTheirNeighbours)
{
  auto surface = mmmtest::MakeSphere(Centre, Radius, 4);
  std::swap(surface.triangles[7][0], surface.triangles[7][1]);
  std::swap(surface.triangles[30][1], surface.triangles[30][2]);
  surface.triangles.push_back({ { 0, 0, 1 } });
  const auto defects = mmm::RepairSurface(surface);
  EXPECT_EQ(defects.boundaryEdges, 0u);
  EXPECT_EQ(defects.branchingEdges, 0u);
  EXPECT_EQ(defects.turnedTriangles, 2u);
  EXPECT_EQ(surface.triangles.size(), 6u * 4u * 4u * 2u);
  double volume = 0.0;
  for (const auto & [a, b, c] : surface.triangles)
  {
    volume += surface.points[a].dot(surface.points[b].cross(surface.points[c])) / 6.0;
  }
  EXPECT_NEAR(volume / (4.0 / 3.0 * EIGEN_PI * std::pow(Radius, 3)), 1.0, 0.15);
}

TEST(TriangleSurface, FindsEdgesOfOneTriangle)
{
  auto       surface = mmmtest::MakeSphere(Centre, Radius, 4);
  const auto last = surface.triangles.back();
  surface.triangles.pop_back();
  const auto defects = mmm::RepairSurface(surface);
  EXPECT_EQ(defects.boundaryEdges, 3u);
  double nearest = 1e300;
  for (int k = 0; k < 3; ++k)
  {
    const Vector middle = 0.5 * (surface.points[last[k]] + surface.points[last[(k + 1) % 3]]);
    nearest = std::min(nearest, (middle - defects.boundaryPlace).norm());
  }
  EXPECT_LT(nearest, 1e-9);
}
