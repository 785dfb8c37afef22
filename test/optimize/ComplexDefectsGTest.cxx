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
#include "optimize/ComplexDefects.h"

#include <gtest/gtest.h>

namespace
{
using mmm::TetrahedralComplex;
using mmm::Vector;

const std::vector<Vector> Points{ Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1), Vector(1, 1, 1) };

/** Two materials that share a face. */
mmm::TetrahedralMesh
MakeMesh()
{
  mmm::TetrahedralMesh mesh;
  mesh.tetrahedra = { { { 0, 1, 2, 3 } }, { { 1, 2, 3, 4 } } };
  mesh.materials = { 1, 2 };
  return mesh;
}
} // namespace

TEST(ComplexDefects, ASoundComplexHasNone)
{
  const auto defects = mmm::FindDefects(TetrahedralComplex(MakeMesh(), Points.size()), Points);
  EXPECT_EQ(defects.notPositive, 0u);
  EXPECT_EQ(defects.notNeighbours, 0u);
  EXPECT_EQ(defects.open, 0u);
}

TEST(ComplexDefects, ATetrahedronTurnedOverIsOne)
{
  const mmm::ComplexDefects none;
  auto                      points = Points;
  points[4] = Vector(-1, -1, -1);
  const auto defects = mmm::FindDefects(TetrahedralComplex(MakeMesh(), points.size()), points);
  EXPECT_EQ(defects.notPositive, 1u);
  EXPECT_FALSE(defects.AreWithin(none));
  EXPECT_TRUE(none.AreWithin(defects));
}

TEST(ComplexDefects, NeighboursThatDoNotKnowEachOtherAreOne)
{
  TetrahedralComplex complex(MakeMesh(), Points.size());
  // does not fill the same space, and so does not learn what is beside it
  complex.Replace({ 1 }, { { { { 0, 3, 2, 4 } }, 2 } });
  EXPECT_EQ(mmm::FindDefects(complex, Points).notNeighbours, 2u);
}
