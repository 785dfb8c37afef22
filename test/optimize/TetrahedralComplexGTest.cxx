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
#include "optimize/TetrahedralComplex.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using mmm::TetrahedralComplex;

/** Three tetrahedra around the edge from point 0 to point 1, and a fourth beside one of them, of another material. */
TetrahedralComplex
MakeComplex()
{
  mmm::TetrahedralMesh mesh;
  mesh.tetrahedra = { { { 0, 1, 2, 3 } }, { { 0, 1, 3, 4 } }, { { 0, 1, 4, 2 } }, { { 0, 2, 3, 5 } } };
  mesh.materials = { 1, 1, 1, 2 };
  return TetrahedralComplex(mesh, 6);
}

/** Replaces the three by two, which leaves a free id. */
TetrahedralComplex
MakeComplexWithAFreeId()
{
  auto complex = MakeComplex();
  complex.Replace({ 0, 1, 2 }, { { { { 2, 3, 4, 0 } }, 1 }, { { { 4, 3, 2, 1 } }, 1 } });
  return complex;
}
} // namespace

TEST(TetrahedralComplex, CompactLeavesNoFreeIds)
{
  auto complex = MakeComplexWithAFreeId();
  ASSERT_EQ(complex.Size(), 4u);
  complex.Compact();
  ASSERT_EQ(complex.Size(), 3u);
  for (TetrahedralComplex::Id t = 0; t < complex.Size(); ++t)
  {
    EXPECT_TRUE(complex.IsAlive(t));
  }
}

TEST(TetrahedralComplex, CompactKeepsTheMesh)
{
  auto       complex = MakeComplexWithAFreeId();
  const auto before = complex.GetMesh();
  complex.Compact();
  EXPECT_EQ(complex.Tetrahedra(), before.tetrahedra);
  EXPECT_EQ(complex.Materials(), before.materials);
}

TEST(TetrahedralComplex, CompactKeepsNeighbours)
{
  auto complex = MakeComplexWithAFreeId();
  complex.Compact();
  const TetrahedralComplex anew(complex.GetMesh(), 6);
  for (TetrahedralComplex::Id t = 0; t < complex.Size(); ++t)
  {
    for (int f = 0; f < 4; ++f)
    {
      EXPECT_EQ(complex.Neighbour(t, f), anew.Neighbour(t, f));
    }
  }
}

TEST(TetrahedralComplex, CompactKeepsTheStarsOfPoints)
{
  auto complex = MakeComplexWithAFreeId();
  complex.Compact();
  std::vector<TetrahedralComplex::Id> star;
  for (mmm::PointId p = 0; p < 6; ++p)
  {
    complex.GetStar(p, star);
    const auto & all = complex.Tetrahedra();
    EXPECT_EQ(star.size(), std::size_t(std::count_if(all.begin(), all.end(), [p](const mmm::Tetrahedron & t) {
                return std::find(t.begin(), t.end(), p) != t.end();
              })));
  }
}

TEST(TetrahedralComplex, PointsOfReplacedTetrahedraAreTouched)
{
  const auto complex = MakeComplexWithAFreeId();
  for (mmm::PointId p = 0; p < 5; ++p)
  {
    EXPECT_TRUE(complex.IsTouched(p)) << p;
  }
  EXPECT_FALSE(complex.IsTouched(5));
}

TEST(TetrahedralComplex, PointsOfAnotherMaterialAreTouchedUntilForgotten)
{
  auto complex = MakeComplex();
  complex.SetMaterial(3, 1);
  EXPECT_TRUE(complex.IsTouched(5));
  EXPECT_FALSE(complex.IsTouched(4));
  complex.ForgetTouched();
  EXPECT_FALSE(complex.IsTouched(5));
}
