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
#include "surface/FlatTetrahedra.h"
#include "support/TestParticles.h"
#include "support/TestScenes.h"

#include "gtest/gtest.h"

namespace
{
using mmm::Vector;

constexpr mmm::Material Outside = 9;
constexpr std::size_t   Flat = 0;

/** A flat tetrahedron of a long edge and a short one across it, and the four others around these edges. The interface
 * has the long edge if the flat one is of material 1, which is above, and the short one if it is of material 0. */
struct Lens
{
  std::vector<Vector>  points;
  mmm::TetrahedralMesh mesh;

  explicit Lens(mmm::Material ofFlat)
  {
    const Vector centre(8.0, 8.0, 7.5);
    for (const Vector & offset : { Vector(-1.5, 0, 0),
                                   Vector(1.5, 0, 0),
                                   Vector(0, -0.5, 0.02),
                                   Vector(0, 0.5, 0.02),
                                   Vector(0, 0, 3),
                                   Vector(0, 0, -3) })
    {
      points.push_back(centre + offset);
    }
    mesh.tetrahedra = {
      { { 0, 1, 3, 2 } }, { { 2, 3, 0, 4 } }, { { 3, 2, 1, 4 } }, { { 0, 1, 2, 5 } }, { { 1, 0, 3, 5 } }
    };
    mesh.materials = { ofFlat, 1, 1, 0, 0 };
    for (auto & t : mesh.tetrahedra)
    {
      const Vector & a = points[t[0]];
      if ((points[t[1]] - a).cross(points[t[2]] - a).dot(points[t[3]] - a) < 0.0)
      {
        std::swap(t[0], t[1]);
      }
    }
  }
};

/** Material 1 is above a height, which is halfway between voxels. */
mmmtest::Scene
MakeHalfSpaces(double height)
{
  return mmmtest::Scene(mmmtest::MakeMaterials(
    { { 16, 16, 16 } }, Vector::Ones(), 2, [height](const Vector & x) { return x[2] > height; }));
}

/** With all points on that cell. */
std::size_t
Turn(const mmmtest::Scene & scene, Lens & lens, const mmm::Cell & cell = mmm::Cell{ 0, 1 })
{
  const auto                      particles = mmmtest::MakeParticles(lens.points, cell);
  const mmm::TetrahedronAdjacency adjacency(lens.mesh.tetrahedra, particles.Size());
  return mmm::TurnFlatTetrahedra(*scene.indicators, particles, adjacency, Outside, lens.mesh);
}
} // namespace

TEST(FlatTetrahedra, GoWhereTheInterfacesTrianglesAreBetter)
{
  const auto scene = MakeHalfSpaces(7.5);
  Lens       lens(1);
  EXPECT_EQ(Turn(scene, lens), 1u);
  EXPECT_EQ(lens.mesh.materials[Flat], 0);
}

TEST(FlatTetrahedra, StayWhereTheInterfacesTrianglesAreBetter)
{
  const auto scene = MakeHalfSpaces(7.5);
  Lens       lens(0);
  EXPECT_EQ(Turn(scene, lens), 0u);
}

TEST(FlatTetrahedra, StayWhereTheIndicatorsAreAgainstTheOtherSide)
{
  const auto scene = MakeHalfSpaces(5.5);
  Lens       lens(1);
  EXPECT_EQ(Turn(scene, lens), 0u);
}

TEST(FlatTetrahedra, StayWhereTheirCornersLieOnNoCellOfTheOtherMaterial)
{
  const auto scene = MakeHalfSpaces(7.5);
  Lens       lens(1);
  EXPECT_EQ(Turn(scene, lens, mmm::Cell{ 1, 2 }), 0u);
}

TEST(FlatTetrahedra, StayWhereTheirMaterialHasNoOther)
{
  const auto scene = MakeHalfSpaces(7.5);
  Lens       lens(1);
  lens.mesh.materials = { 1, 0, 0, 0, 0 };
  EXPECT_EQ(Turn(scene, lens), 0u);
}
