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
#include "base/Hash.h"
#include "particles/SpatialOrder.h"
#include "delaunay/TetGen.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>

namespace
{
/** Points that are spread over a cube at random. */
std::vector<mmm::Vector>
RandomPoints(std::size_t count)
{
  std::vector<mmm::Vector> points(count);
  for (std::size_t p = 0; p < count; ++p)
  {
    for (int a = 0; a < 3; ++a)
    {
      points[p][a] = double(mmm::Hash(3 * p + a) >> 11) * 0x1p-53;
    }
  }
  return points;
}

double
MeanStep(const std::vector<mmm::Vector> & points)
{
  double sum = 0.0;
  for (std::size_t p = 1; p < points.size(); ++p)
  {
    sum += (points[p] - points[p - 1]).norm();
  }
  return sum / double(points.size() - 1);
}
} // namespace

TEST(SpatialOrder, HasEachPointOnce)
{
  auto order = mmm::SpatialOrder(RandomPoints(1000), 100);
  std::sort(order.begin(), order.end());
  std::vector<mmm::PointId> expected(900);
  std::iota(expected.begin(), expected.end(), 100);
  EXPECT_EQ(order, expected);
}

TEST(SpatialOrder, PutsNeighborsSideBySide)
{
  const auto               points = RandomPoints(8000); // 0.05 apart
  std::vector<mmm::Vector> sorted;
  for (const auto p : mmm::SpatialOrder(points))
  {
    sorted.push_back(points[p]);
  }
  EXPECT_LT(MeanStep(sorted), 0.1);
}

TEST(SpatialOrder, IsTheSameWhereverThePointsAre)
{
  const auto points = RandomPoints(500);
  auto       moved = points;
  for (auto & x : moved)
  {
    x = 4.0 * x + mmm::Vector(64.0, -32.0, 16.0);
  }
  EXPECT_EQ(mmm::SpatialOrder(points), mmm::SpatialOrder(moved));
}

TEST(SpatialOrder, TakesPointsThatCoincide)
{
  const std::vector<mmm::Vector> points(3, mmm::Vector(1.0, 2.0, 3.0));
  EXPECT_EQ(mmm::SpatialOrder(points), (std::vector<mmm::PointId>{ 0, 1, 2 }));
}

TEST(SpatialOrder, TakesPointsThatAreNoNumbers)
{
  auto points = RandomPoints(10);
  points[3][1] = std::numeric_limits<double>::quiet_NaN();
  points[5][2] = std::numeric_limits<double>::infinity();
  auto order = mmm::SpatialOrder(points);
  std::sort(order.begin(), order.end());
  EXPECT_EQ(order, (std::vector<mmm::PointId>{ 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 }));
}

TEST(SpatialOrder, OfNothingIsEmpty) { EXPECT_TRUE(mmm::SpatialOrder({}).empty()); }

TEST(SpatialOrder, OfParticlesLeavesThemOnTheirCells)
{
  mmm::ParticleSet particles;
  particles.cellTable = { mmm::Cell{ 0, 1 }, mmm::Cell{ 1, 2 } };
  particles.positions = RandomPoints(200);
  for (const auto & x : particles.positions)
  {
    particles.cells.push_back(x[0] < 0.5 ? 0 : 1);
  }
  const auto before = particles;
  mmm::SortInSpace(particles, 50);
  EXPECT_TRUE(std::equal(before.positions.begin(), before.positions.begin() + 50, particles.positions.begin()));
  ASSERT_EQ(particles.Size(), before.Size());
  EXPECT_NE(particles.positions, before.positions);
  for (std::size_t p = 0; p < particles.Size(); ++p)
  {
    EXPECT_EQ(particles.cells[p], particles.positions[p][0] < 0.5 ? 0u : 1u);
  }
}

TEST(SpatialOrder, OfPointsIsThatOfTheirTetrahedra)
{
  const auto tetrahedra = mmm::DelaunayTetrahedralization(RandomPoints(500));
  EXPECT_TRUE(std::is_sorted(tetrahedra.begin(), tetrahedra.end(), [](const auto & a, const auto & b) {
    return *std::min_element(a.begin(), a.end()) < *std::min_element(b.begin(), b.end());
  }));
}
