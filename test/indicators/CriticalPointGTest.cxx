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
#include "indicators/CriticalPoint.h"

#include "support/TestScenes.h"

#include "gtest/gtest.h"

using mmm::Vector;

namespace
{
/** Two balls of material 1 with a gap of a voxel between them, in the middle of the scene. */
mmmtest::Scene
MakeGap()
{
  return mmmtest::Scene(mmmtest::MakeMaterials({ { 25, 15, 15 } }, Vector::Ones(), 2, [](const Vector & x) {
    return std::min((x - Vector(6.5, 7.0, 7.0)).norm(), (x - Vector(17.5, 7.0, 7.0)).norm()) < 5.1;
  }));
}
} // namespace

TEST(CriticalPoint, IsTheMiddleOfAGap)
{
  const auto scene = MakeGap();
  Vector     x(12.15, 7.2, 6.9);
  ASSERT_TRUE(mmm::FindCriticalPoint(*scene.indicators, 0, 1, 0.35, x));
  EXPECT_LT((x - Vector(12.0, 7.0, 7.0)).norm(), 0.02);
}

TEST(CriticalPoint, IsFoundAcrossLongVoxels)
{
  // two slabs of material 1 with a gap of a slice between them
  const mmmtest::Scene scene(mmmtest::MakeMaterials(
    { { 9, 9, 9 } }, Vector(1, 1, 5), 2, [](const Vector & x) { return std::abs(x[2] - 20.0) > 4.0; }));
  Vector               x(4.0, 4.0, 20.0 + 0.15 * 5);
  ASSERT_TRUE(mmm::FindCriticalPoint(*scene.indicators, 0, 1, 0.35, x));
  EXPECT_LT(std::abs(x[2] - 20.0), 0.1);
}

TEST(CriticalPoint, IsNotLookedForBeyondReach)
{
  const auto scene = MakeGap();
  Vector     x(12.15, 7.2, 6.9);
  EXPECT_FALSE(mmm::FindCriticalPoint(*scene.indicators, 0, 1, 0.1, x));
}

TEST(CriticalPoint, IsNotFoundOnASmoothInterface)
{
  const auto scene = MakeGap();
  Vector     x(6.5, 2.0, 7.0);
  EXPECT_FALSE(mmm::FindCriticalPoint(*scene.indicators, 0, 1, 0.35, x));
}
