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
#include "sizing/MeshEstimate.h"

#include "support/TestScenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using mmm::Vector;
using mmmtest::MakeMaterials;
using mmmtest::Scene;

/** Two thick slabs, materials 0 and 1, that fill the box. */
Scene
MakeSlabs()
{
  return Scene(
    MakeMaterials({ { 20, 16, 16 } }, Vector::Ones(), 2, [](const Vector & x) { return x[0] < 9.5 ? 0 : 1; }));
}

/** Sheets of one voxel of alternating materials. */
Scene
MakeSheets()
{
  return Scene(MakeMaterials({ { 20, 16, 16 } }, Vector::Ones(), 2, [](const Vector & x) { return int(x[0]) % 2; }));
}

mmm::MeshEstimator
EstimatorFor(const Scene & scene, int exterior, const std::vector<float> & sizes, bool surfaceOnly = false)
{
  return { *scene.indicators, exterior, mmm::SizingField(scene.image.grid, sizes.data()), surfaceOnly };
}

std::vector<float>
UniformSizes(const Scene & scene, float size)
{
  return std::vector<float>(scene.image.grid.NumberOfNodes(), size);
}
} // namespace

TEST(MeshEstimate, GrowsWithAreaBySquareAndVolumeByCube)
{
  const auto scene = MakeSlabs();
  const auto coarse = EstimatorFor(scene, -1, UniformSizes(scene, 2.0f)).Estimate();
  const auto fine = EstimatorFor(scene, -1, UniformSizes(scene, 1.0f)).Estimate();
  EXPECT_NEAR(fine.tetrahedra / coarse.tetrahedra, 8.0, 1e-6);
  EXPECT_NEAR(fine.triangles / coarse.triangles, 4.0, 1e-6);
  EXPECT_GT(fine.memory, coarse.memory);
}

TEST(MeshEstimate, LeavesTheExteriorOut)
{
  const auto   scene = MakeSlabs();
  const auto   sizes = UniformSizes(scene, 1.5f);
  const double whole = EstimatorFor(scene, -1, sizes).Estimate().tetrahedra;
  EXPECT_NEAR(EstimatorFor(scene, 0, sizes).Estimate().tetrahedra, 0.5 * whole, 1e-6 * whole);
}

TEST(MeshEstimate, SurfaceOnlyHasNoTetrahedra)
{
  const auto scene = MakeSlabs();
  const auto estimate = EstimatorFor(scene, -1, UniformSizes(scene, 1.5f), true).Estimate();
  EXPECT_EQ(estimate.tetrahedra, 0.0);
  EXPECT_GT(estimate.triangles, 100.0);
  EXPECT_NEAR(estimate.points, 0.5 * estimate.triangles, 1e-9);
}

TEST(MeshEstimate, LargerSmallestSizeFitsAndNoneMuchSmallerDoes)
{
  const auto   scene = MakeSlabs();
  const auto   estimator = EstimatorFor(scene, -1, UniformSizes(scene, 1.0f));
  const double most = 0.2 * estimator.Estimate().tetrahedra;
  const double size = estimator.SmallestSizeFor(most, 1e9);
  EXPECT_LE(estimator.Estimate(size).tetrahedra, most);
  EXPECT_GT(estimator.Estimate(0.9 * size).tetrahedra, most);
}

TEST(MeshEstimate, ThinPartsStayWhateverTheSmallestSize)
{
  const auto   scene = MakeSheets();
  const auto   estimator = EstimatorFor(scene, -1, UniformSizes(scene, 1.0f));
  const double most = 0.2 * estimator.Estimate().tetrahedra;
  EXPECT_TRUE(std::isinf(estimator.SmallestSizeFor(most, 1e9)));
}

TEST(MeshEstimate, MemoryLimitBelowThatOfTheImagesCannotBeKept)
{
  const auto scene = MakeSlabs();
  EXPECT_TRUE(std::isinf(EstimatorFor(scene, -1, UniformSizes(scene, 1.0f)).SmallestSizeFor(1e9, 1e-6)));
}

TEST(MeshEstimate, IsDescribedInRoundNumbers)
{
  EXPECT_EQ(mmm::DescribeCount(3458448.0), "3.5 million");
  EXPECT_EQ(mmm::DescribeCount(15.7e6), "16 million");
  EXPECT_EQ(mmm::DescribeCount(147648.0), "148 thousand");
  EXPECT_EQ(mmm::DescribeCount(3313.0), "3310");
  mmm::MeshEstimate estimate;
  estimate.points = 3313.0;
  estimate.tetrahedra = 17000.0;
  estimate.memory = 0.5;
  EXPECT_EQ(mmm::Describe(estimate), "3310 points, 17 thousand tetrahedra and 512 MB");
  estimate.tetrahedra = 0.0;
  estimate.triangles = 6600.0;
  estimate.memory = 2.44;
  EXPECT_EQ(mmm::Describe(estimate), "3310 points, 6600 triangles and 2.4 GB");
}

TEST(MeshEstimate, RoundsUpToTwoDigits)
{
  EXPECT_DOUBLE_EQ(mmm::RoundUp(1.234), 1.3);
  EXPECT_DOUBLE_EQ(mmm::RoundUp(0.0351), 0.036);
  EXPECT_DOUBLE_EQ(mmm::RoundUp(2.5), 2.5);
}
