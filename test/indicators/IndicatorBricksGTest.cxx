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
#include "indicators/IndicatorBricks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
constexpr float Outside = -3.0f;

/** The cut-off signed distance of a ball, on a block. */
mmm::Block<float>
MakeBall(const mmm::Index & lower, const mmm::Index & size, const mmm::Vector & centre, double radius)
{
  mmm::Block<float> block{ lower, size, {} };
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        const double depth = radius - (mmm::Vector(lower[0] + i, lower[1] + j, lower[2] + k) - centre).norm();
        block.values.push_back(float(std::min(3.0, std::max(-3.0, depth))));
      }
    }
  }
  return block;
}

mmm::IndicatorBricks
MakeBricks(const mmm::Grid & grid, const mmm::Block<float> & block, float scale = 1.0f)
{
  return { grid, { block.lower, block.size, block.values.data() }, Outside, scale };
}
} // namespace

TEST(IndicatorBricks, HaveTheValuesOfTheBlockAndAreOutsideBeyondIt)
{
  mmm::Grid grid;
  grid.size = { { 40, 37, 45 } };
  const auto block = MakeBall({ { 3, 0, 11 } }, { { 30, 37, 25 } }, mmm::Vector(17.0, 19.0, 23.0), 10.0);
  const auto bricks = MakeBricks(grid, block, 2.0f);
  for (std::size_t n = 0; n < grid.NumberOfNodes(); ++n)
  {
    const auto at = grid.IndexAt(n);
    mmm::Index local;
    bool       inside = true;
    for (int a = 0; a < 3; ++a)
    {
      local[a] = at[a] - block.lower[a];
      inside = inside && local[a] >= 0 && local[a] < block.size[a];
    }
    const float expected =
      inside ? 2.0f * block.values[(std::size_t(local[2]) * block.size[1] + local[1]) * block.size[0] + local[0]]
             : Outside;
    ASSERT_EQ(bricks.At(at), expected) << at[0] << ' ' << at[1] << ' ' << at[2];
  }
}

TEST(IndicatorBricks, ContinueTheValuesBeyondTheBorderOfTheGrid)
{
  mmm::Grid grid;
  grid.size = { { 16, 16, 16 } };
  const auto bricks = MakeBricks(grid, MakeBall({ { 0, 0, 0 } }, { { 16, 16, 16 } }, mmm::Vector(1.0, 15.0, 8.0), 4.0));
  EXPECT_EQ(bricks.At({ { -1, 15, 8 } }), bricks.At({ { 0, 15, 8 } }));
  EXPECT_EQ(bricks.At({ { 2, 17, 8 } }), bricks.At({ { 2, 15, 8 } }));
}

TEST(IndicatorBricks, MemoryFollowsTheInterface)
{
  mmm::Grid grid;
  grid.size = { { 128, 128, 128 } };
  const auto centre = mmm::Vector::Constant(64.0);
  const auto stored = [&](double radius) {
    return MakeBricks(grid, MakeBall({ { 0, 0, 0 } }, grid.size, centre, radius)).GetNumberOfStoredBricks();
  };
  const auto all = std::size_t(16) * 16 * 16;
  EXPECT_LT(stored(24.0), all / 10);
  // twice the radius: four times the surface, not eight times the volume
  EXPECT_LT(stored(48.0), 5 * stored(24.0));
}
