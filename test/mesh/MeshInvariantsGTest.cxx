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
#include "mesh/MeshInvariants.h"

#include <gtest/gtest.h>

namespace
{
/** Two tetrahedra on both sides of a triangle, of materials 0 and 1. */
struct Pair
{
  std::vector<mmm::Vector> points{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
  mmm::TetrahedralMesh     mesh{ { { { 0, 1, 2, 3 } }, { { 0, 2, 1, 4 } } }, { 0, 1 } };
};
} // namespace

TEST(MeshInvariants, ATetrahedronThatIsTurnedOverIsNotPositive)
{
  Pair pair;
  EXPECT_TRUE(mmm::ArePositive(pair.points, pair.mesh.tetrahedra));
  std::swap(pair.mesh.tetrahedra[1][0], pair.mesh.tetrahedra[1][1]);
  EXPECT_FALSE(mmm::ArePositive(pair.points, pair.mesh.tetrahedra));
}

TEST(MeshInvariants, AFlatTetrahedronIsPositiveWithinATolerance)
{
  Pair pair;
  pair.points[3] = { 0.2, 0.2, -1e-12 };
  EXPECT_FALSE(mmm::ArePositive(pair.points, pair.mesh.tetrahedra));
  EXPECT_TRUE(mmm::ArePositive(pair.points, pair.mesh.tetrahedra, mmm::FlatVolume));
}

TEST(MeshInvariants, NeighboursHaveAFaceInCommon)
{
  const Pair pair;
  auto       neighbours = mmm::ComputeTetrahedronNeighbours(pair.mesh.tetrahedra);
  EXPECT_TRUE(mmm::AreAdjacent(pair.mesh.tetrahedra, neighbours));
  std::swap(neighbours[0][3], neighbours[0][0]); // as if the other one were beyond another face
  EXPECT_FALSE(mmm::AreAdjacent(pair.mesh.tetrahedra, neighbours));
}

TEST(MeshInvariants, NeighboursAreEachOthers)
{
  const Pair pair;
  auto       neighbours = mmm::ComputeTetrahedronNeighbours(pair.mesh.tetrahedra);
  neighbours[1].fill(mmm::NoTetrahedron);
  EXPECT_FALSE(mmm::AreAdjacent(pair.mesh.tetrahedra, neighbours));
}

TEST(MeshInvariants, ABoundaryWithoutOneOfItsTrianglesIsNotClosed)
{
  const Pair pair;
  auto       interfaces = mmm::ExtractInterfaces(pair.mesh, 2);
  ASSERT_EQ(interfaces.triangles.size(), 7u);
  EXPECT_TRUE(mmm::AreClosed(interfaces));
  interfaces.triangles.pop_back();
  interfaces.sides.pop_back();
  EXPECT_FALSE(mmm::AreClosed(interfaces));
}

TEST(MeshInvariants, ABoundaryWithATriangleThatIsTurnedOverIsNotClosed)
{
  const Pair pair;
  auto       interfaces = mmm::ExtractInterfaces(pair.mesh, 2);
  std::swap(interfaces.triangles[0][0], interfaces.triangles[0][1]);
  EXPECT_FALSE(mmm::AreClosed(interfaces));
}
