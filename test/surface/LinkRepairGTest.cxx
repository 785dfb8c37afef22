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
#include "surface/LinkRepair.h"
#include "support/TestParticles.h"
#include "support/TestScenes.h"
#include "support/TestTetrahedra.h"

#include "gtest/gtest.h"

namespace
{
/** The eight tetrahedra around the origin whose outer faces make an octahedron. */
struct Octahedron
{
  /** All on cells of the materials 0 to 2. */
  mmm::ParticleSet     particles;
  mmm::TetrahedralMesh mesh;

  /** `materialAt` gives the material of the octant of three signs. */
  template <typename TFunction>
  explicit Octahedron(const mmm::Vector & centre, const TFunction & materialAt)
  {
    std::vector<mmm::Vector> points{ centre };
    for (int a = 0; a < 3; ++a)
    {
      points.push_back(centre + mmm::Vector::Unit(a));
      points.push_back(centre - mmm::Vector::Unit(a));
    }
    particles = mmmtest::MakeParticles(points, mmm::Cell{ 0, 1, 2 });
    for (int octant = 0; octant < 8; ++octant)
    {
      std::array<std::uint32_t, 3> outer;
      int                          negative = 0;
      for (int a = 0; a < 3; ++a)
      {
        const int isNegative = octant >> a & 1;
        outer[a] = std::uint32_t(1 + 2 * a + isNegative);
        negative += isNegative;
      }
      if (negative % 2)
      {
        std::swap(outer[1], outer[2]);
      }
      mesh.tetrahedra.push_back({ { 0, outer[0], outer[1], outer[2] } });
      mesh.materials.push_back(
        mmm::Material(materialAt(octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1)));
    }
  }

  mmm::TetrahedronAdjacency
  Adjacency() const
  {
    return { mesh.tetrahedra, particles.Size() };
  }
};

constexpr mmm::Material Outside = 9;

mmm::LinkDefects
DefectsOf(const Octahedron & octahedron)
{
  return mmm::FindLinkDefects(octahedron.mesh, octahedron.Adjacency(), Outside);
}
} // namespace

TEST(LinkDefects, PlaneHasNone)
{
  const auto defects = DefectsOf(Octahedron(mmm::Vector::Zero(), [](int, int, int z) { return z > 0; }));
  EXPECT_TRUE(defects.points.empty());
  EXPECT_TRUE(defects.edges.empty());
}

TEST(LinkDefects, ThreeHalfDisksHaveNone)
{
  const auto defects =
    DefectsOf(Octahedron(mmm::Vector::Zero(), [](int, int y, int z) { return z > 0 ? 0 : (y > 0 ? 1 : 2); }));
  EXPECT_TRUE(defects.points.empty());
  EXPECT_TRUE(defects.edges.empty());
}

TEST(LinkDefects, ConesThatTouchInTheirTipAreADefectOfThePoint)
{
  const auto defects = DefectsOf(Octahedron(mmm::Vector::Zero(), [](int x, int y, int z) { return x == y && y == z; }));
  EXPECT_EQ(defects.points, std::vector<mmm::PointId>{ 0 });
  EXPECT_TRUE(defects.edges.empty());
}

TEST(LinkDefects, WedgesThatTouchInAnEdgeAreADefectOfTheEdge)
{
  // octants of equal signs of x and y meet along the third axis only, on both sides of the origin
  const auto defects = DefectsOf(Octahedron(mmm::Vector::Zero(), [](int x, int y, int) { return x == y; }));
  const std::vector<std::array<mmm::PointId, 2>> expected{ { { 0, 5 } }, { { 0, 6 } } };
  EXPECT_EQ(defects.edges, expected);
}

TEST(LinkRepair, MendsConesThatTouchWhereTheIndicatorsMindLeast)
{
  // the indicators have material 1 nowhere near the lower cone, so that this one goes
  const mmmtest::Scene scene(
    mmmtest::MakeMaterials({ { 16, 16, 16 } }, mmm::Vector::Ones(), 2, [](const mmm::Vector & x) {
      return x[0] > 7.9 && x[1] > 7.9 && x[2] > 7.9;
    }));
  Octahedron octahedron(mmm::Vector(7.5, 7.5, 7.5), [](int x, int y, int z) { return x == y && y == z; });
  const auto report =
    mmm::RepairLinks(*scene.indicators, octahedron.particles, octahedron.Adjacency(), Outside, octahedron.mesh);
  EXPECT_EQ(report.found.points.size(), 1u);
  EXPECT_EQ(report.left.points.size(), 0u);
  EXPECT_EQ(report.relabelled, 1u);
  EXPECT_EQ(octahedron.mesh.materials[0], 1); // all signs positive
  EXPECT_EQ(octahedron.mesh.materials[7], 0);
  EXPECT_TRUE(DefectsOf(octahedron).points.empty());
}

TEST(LinkRepair, MendsRatherWhereAllCornersLieOnCellsOfTheMaterial)
{
  // as above, but the lower cone has corners on no cell of material 0
  const mmmtest::Scene scene(
    mmmtest::MakeMaterials({ { 16, 16, 16 } }, mmm::Vector::Ones(), 2, [](const mmm::Vector & x) {
      return x[0] > 7.9 && x[1] > 7.9 && x[2] > 7.9;
    }));
  Octahedron octahedron(mmm::Vector(7.5, 7.5, 7.5), [](int x, int y, int z) { return x == y && y == z; });
  octahedron.particles.cellTable.push_back(mmm::Cell{ 1, 2 });
  for (const auto corner : octahedron.mesh.tetrahedra[7])
  {
    octahedron.particles.cells[corner] = corner == 0 ? 0 : 1;
  }
  mmm::RepairLinks(*scene.indicators, octahedron.particles, octahedron.Adjacency(), Outside, octahedron.mesh);
  EXPECT_EQ(octahedron.mesh.materials[0], 0);
  EXPECT_EQ(octahedron.mesh.materials[7], 1);
  EXPECT_TRUE(DefectsOf(octahedron).points.empty());
}

TEST(LinkRepair, LeavesAMeshWithoutDefects)
{
  const mmmtest::Scene scene(mmmtest::MakeMaterials(
    { { 16, 16, 16 } }, mmm::Vector::Ones(), 2, [](const mmm::Vector & x) { return x[2] > 7.9; }));
  Octahedron           octahedron(mmm::Vector(7.5, 7.5, 7.5), [](int x, int, int) { return x > 0; });
  EXPECT_EQ(mmm::RepairLinks(*scene.indicators, octahedron.particles, octahedron.Adjacency(), Outside, octahedron.mesh)
              .relabelled,
            0u);
}

TEST(LinkRepair, LosesNoMaterial)
{
  // material 2 has one tetrahedron, and it is the one that is in the way
  const mmmtest::Scene scene(
    mmmtest::MakeMaterials({ { 16, 16, 16 } }, mmm::Vector::Ones(), 3, [](const mmm::Vector & x) {
      return x[2] > 7.9 ? 1 : (x[0] < 2 ? 2 : 0);
    }));
  Octahedron octahedron(mmm::Vector(7.5, 7.5, 7.5),
                        [](int x, int y, int z) { return x == y && y == z ? (x > 0 ? 1 : 2) : 0; });
  mmm::RepairLinks(*scene.indicators, octahedron.particles, octahedron.Adjacency(), Outside, octahedron.mesh);
  const auto & materials = octahedron.mesh.materials;
  EXPECT_EQ(std::count(materials.begin(), materials.end(), 2), 1);
}

TEST(LinkRepair, OfNoiseLeavesFewDefectsAndTellsOfThem)
{
  constexpr int        Size = 10;
  const auto           noise = [](std::size_t n) { return mmm::Material(mmm::Hash(n) % 3); };
  const mmmtest::Scene scene(
    mmmtest::MakeMaterials({ { Size, Size, Size } }, mmm::Vector::Ones(), 3, [&](const mmm::Vector & x) {
      return noise(std::size_t(x[0] + Size * (x[1] + Size * x[2])));
    }));
  const mmm::Grid &    grid = scene.indicators->GetGrid();
  const auto           particles = mmmtest::MakeParticles(mmmtest::MakeNodes(grid), mmm::Cell{ 0, 1, 2 });
  mmm::TetrahedralMesh mesh;
  mesh.tetrahedra = mmmtest::MakeFreudenthalTetrahedra(grid);
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
  {
    mesh.materials.push_back(noise(t));
  }
  const mmm::TetrahedronAdjacency adjacency(mesh.tetrahedra, particles.Size());
  const auto                      report = mmm::RepairLinks(*scene.indicators, particles, adjacency, Outside, mesh);
  const auto                      left = mmm::FindLinkDefects(mesh, adjacency, Outside);
  EXPECT_EQ(report.left.points, left.points);
  EXPECT_EQ(report.left.edges, left.edges);
  EXPECT_GT(report.found.edges.size(), 1000u);
  EXPECT_LT(left.edges.size(), report.found.edges.size() / 20);
  EXPECT_LT(left.points.size(), report.found.points.size() / 20);
}
