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
#include "delaunay/Enclosure.h"
#include "mesh/InterfaceMesh.h"
#include "surface/LostNodes.h"
#include "particles/ParticleMerging.h"
#include "surface/SurfaceLabelling.h"
#include "support/TestScenes.h"
#include "delaunay/TetGen.h"

#include "itkMacro.h"

#include <gtest/gtest.h>

#include <algorithm>

using mmm::Cell;
using mmm::Vector;
using mmmtest::MakeMaterials;
using mmmtest::Scene;

namespace
{
/** The corners of a box. */
std::vector<Vector>
BoxPoints(double size)
{
  std::vector<Vector> points;
  for (int corner = 0; corner < 8; ++corner)
  {
    points.push_back(size * Vector(corner & 1, (corner >> 1) & 1, corner >> 2));
  }
  return points;
}

/** Four materials in the quarters of the xy plane. */
Scene
MakeQuarters()
{
  return Scene(MakeMaterials(
    { { 12, 12, 6 } }, Vector::Ones(), 4, [](const Vector & x) { return (x[0] > 5.5) + 2 * (x[1] > 5.5); }));
}

/** What is lost where the interface of a slab, which is at 4.5, is almost a voxel too low: nodes beside it are wrong,
 * but have right neighbors. */
mmm::LostNodes
FindLostNodesOfSlab(int size, mmm::Material exterior)
{
  const Scene scene(
    MakeMaterials({ { size, size, 11 } }, Vector::Ones(), 2, [](const Vector & x) { return x[2] > 4.5 ? 1 : 0; }));
  auto points = BoxPoints(size - 0.8);
  for (int corner = 0; corner < 4; ++corner)
  {
    points.push_back(Vector(points[corner][0], points[corner][1], 3.7));
  }
  mmm::TetrahedralMesh mesh;
  mesh.tetrahedra = mmm::DelaunayTetrahedralization(points);
  for (const auto & t : mesh.tetrahedra)
  {
    const double middle = 0.25 * (points[t[0]][2] + points[t[1]][2] + points[t[2]][2] + points[t[3]][2]);
    mesh.materials.push_back(middle > 3.7 ? 1 : 0);
  }
  return mmm::FindLostNodes(*scene.indicators, points, mesh, exterior);
}
} // namespace

TEST(LostNodes, AreThoseOfAThreadThatTheTetrahedraMiss)
{
  const Scene          scene(MakeMaterials(
    { { 11, 11, 11 } }, Vector::Ones(), 2, [](const Vector & x) { return x[0] == 5.0 && x[1] == 4.0 ? 1 : 0; }));
  const auto           points = BoxPoints(10.2);
  mmm::TetrahedralMesh mesh;
  mesh.tetrahedra = mmm::DelaunayTetrahedralization(points);
  mesh.materials.assign(mesh.tetrahedra.size(), 0);
  const auto lost = mmm::FindLostNodes(*scene.indicators, points, mesh, 0);
  ASSERT_FALSE(lost.parts.empty());
  for (const auto n : lost.parts)
  {
    EXPECT_EQ(scene.image.materials[n], 1);
  }
  EXPECT_TRUE(std::is_sorted(lost.parts.begin(), lost.parts.end()));
}

TEST(LostNodes, AreNoneWhereTheInterfaceIsALittleOff)
{
  const auto lost = FindLostNodesOfSlab(11, 0);
  EXPECT_TRUE(lost.parts.empty());
  EXPECT_TRUE(lost.corners.empty());
}

TEST(LostNodes, AreAllOfASmallLabelThatLosesMany)
{
  const auto lost = FindLostNodesOfSlab(11, 2);
  EXPECT_TRUE(lost.parts.empty());
  EXPECT_EQ(lost.corners.size(), 121u); // those in the layer at 4
  EXPECT_TRUE(std::is_sorted(lost.corners.begin(), lost.corners.end()));
}

TEST(LostNodes, AreNoneOfALargeLabelThatLosesMany) { EXPECT_TRUE(FindLostNodesOfSlab(35, 2).corners.empty()); }

namespace
{
/** What merging leaves of two particles, sizes being `size` everywhere. It has to drop as many as are missing. */
mmm::ParticleSet
Merge(const Scene & scene, float size, const std::array<Cell, 2> & cells, const std::array<Vector, 2> & positions)
{
  const std::vector<float> sizes(scene.image.grid.NumberOfNodes(), size);
  mmm::ParticleSet         particles;
  particles.cellTable.assign(cells.begin(), cells.end());
  particles.positions.assign(positions.begin(), positions.end());
  particles.cells = { 0, 1 };
  const auto dropped =
    mmm::MergeCloseParticles(*scene.indicators, mmm::SizingField(scene.image.grid, sizes.data()), particles);
  EXPECT_EQ(dropped, 2 - particles.Size());
  return particles;
}
} // namespace

TEST(ParticleMerging, JoinsCloseJunctionsToOnePointOfAllTheirMaterials)
{
  const auto particles = Merge(
    MakeQuarters(), 1.0f, { Cell{ 0, 1, 2 }, Cell{ 1, 2, 3 } }, { Vector(5.45, 5.5, 2.0), Vector(5.55, 5.5, 2.0) });
  ASSERT_EQ(particles.Size(), 1u);
  EXPECT_EQ(particles.CellOf(0), (Cell{ 0, 1, 2, 3 }));
}

TEST(ParticleMerging, LeavesAParticleOnItsCellWhereThereIsNoCurveOfAllMaterials)
{
  const Scene scene(MakeMaterials(
    { { 15, 12, 12 } }, Vector::Ones(), 3, [](const Vector & x) { return x[0] < 5.0 ? 0 : (x[0] < 10.0 ? 1 : 2); }));
  const auto  particles =
    Merge(scene, 1.0f, { Cell{ 0, 1 }, Cell{ 1, 2 } }, { Vector(4.5, 5.5, 5.5), Vector(4.6, 5.5, 5.5) });
  ASSERT_EQ(particles.Size(), 1u);
  EXPECT_EQ(particles.CellOf(0), (Cell{ 0, 1 }));
  EXPECT_EQ(particles.positions[0], Vector(4.5, 5.5, 5.5));
}

TEST(ParticleMerging, KeepsTheTwoSidesOfAThinLayerApart)
{
  const auto particles =
    Merge(MakeQuarters(), 3.0f, { Cell{ 0, 1 }, Cell{ 0, 2 } }, { Vector(5.5, 2.0, 2.0), Vector(5.1, 2.0, 2.0) });
  EXPECT_EQ(particles.Size(), 2u);
}

TEST(Cells, JoinUpToTheirCapacity)
{
  Cell cell{ 1, 2, 3, 4, 5, 6 };
  EXPECT_TRUE(cell.Join(Cell{ 2, 7, 8 }));
  EXPECT_EQ(cell, (Cell{ 1, 2, 3, 4, 5, 6, 7, 8 }));
  EXPECT_EQ(cell.Dimension(), 0);
  EXPECT_FALSE(cell.Join(Cell{ 0, 1 }));
  EXPECT_EQ(cell.count, 8);
}

TEST(LabelTetrahedra, GivesFlatOnesToTheSideOfTheirCircumcentre)
{
  // the edges of a flat tetrahedron that lie across each other have lengths 3 and 1; the shorter is higher or lower
  const Scene scene(
    MakeMaterials({ { 16, 16, 16 } }, Vector::Ones(), 2, [](const Vector & x) { return x[2] > 7.5 ? 1 : 0; }));
  for (const bool isHigher : { false, true })
  {
    // the indicators are for the other side, but not by much
    const double     height = isHigher ? 7.6 : 7.4;
    const double     rise = isHigher ? 0.02 : -0.02;
    mmm::ParticleSet particles;
    particles.cellTable = { Cell{ 0, 1 } };
    particles.positions = {
      { 6.5, 8, height }, { 9.5, 8, height }, { 8, 7.5, height + rise }, { 8, 8.5, height + rise }
    };
    particles.cells = { 0, 0, 0, 0 };
    const std::vector<mmm::Tetrahedron> tetrahedra{ { { 0, 1, 2, 3 } } };
    EXPECT_EQ(mmm::LabelTetrahedra(*scene.indicators, particles, tetrahedra, 9)[0], isHigher ? 0 : 1);
  }
}

TEST(LabelTetrahedra, CopesWithJunctionsOfAsManyMaterialsAsACellHolds)
{
  const Scene      scene(MakeMaterials({ { 8, 8, 8 } }, Vector::Ones(), 8, [](const Vector & x) {
    return (x[0] > 3.5) + 2 * (x[1] > 3.5) + 4 * (x[2] > 3.5);
  }));
  mmm::ParticleSet particles;
  particles.cellTable = { Cell{ 0, 1, 2, 3, 4, 5, 6, 7 } };
  particles.positions = { Vector(1, 1, 1), Vector(2, 1, 1), Vector(1, 2, 1), Vector(1, 1, 2) };
  particles.cells = { 0, 0, 0, 0 };
  const std::vector<mmm::Tetrahedron> tetrahedra{ { { 0, 1, 2, 3 } } };
  EXPECT_EQ(mmm::LabelTetrahedra(*scene.indicators, particles, tetrahedra, 9), std::vector<mmm::Material>{ 0 });
}

TEST(InterfaceMesh, TellsTheMaterialsOnItsTwoSides)
{
  const auto           points = BoxPoints(1.0);
  mmm::TetrahedralMesh mesh;
  mesh.tetrahedra = mmm::DelaunayTetrahedralization(points);
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
  {
    mesh.materials.push_back(mmm::Material(t % 3));
  }
  const auto interfaces = mmm::ExtractInterfaces(mesh, 2);
  // material 2 is the outside: what touches no interface is outside, too
  EXPECT_EQ(mmm::LabelByInterfaces(interfaces, mesh.tetrahedra, 2), mesh.materials);
}

TEST(InterfaceMesh, TellsNothingOfTetrahedraThatLackATriangle)
{
  const std::vector<mmm::Tetrahedron> tetrahedra{ { { 0, 1, 2, 3 } } };
  const mmm::InterfaceMesh interfaces{ { { { 0, 2, 1 } }, { { 1, 2, 4 } } }, { { { 0, 1 } }, { { 0, 1 } } } };
  EXPECT_FALSE(mmm::LabelByInterfaces(interfaces, tetrahedra, 2));
}

TEST(DelaunayTetrahedralization, RefusesPointsInOnePlane)
{
  const std::vector<Vector> points{ { 0, 0, 1 }, { 1, 0, 1 }, { 0, 1, 1 }, { 1, 1, 1 }, { 2, 3, 1 } };
  EXPECT_THROW(mmm::DelaunayTetrahedralization(points), itk::ExceptionObject);
}

TEST(Enclosure, LiesFarOutsideTheImageOnAllSides)
{
  mmm::Grid grid;
  grid.size = { { 10, 20, 30 } };
  grid.spacing = Vector(1.0, 1.5, 2.0);
  for (const Vector & corner : mmm::EnclosingCorners(grid))
  {
    for (int a = 0; a < 3; ++a)
    {
      const double extent = grid.size[a] * grid.spacing[a];
      EXPECT_TRUE(corner[a] < -extent || corner[a] > 2.0 * extent);
    }
  }
}

TEST(Enclosure, TetrahedraHaveCornersAmongThePointsOnlyAndFillTheCube)
{
  mmm::Grid grid;
  grid.size = { { 9, 9, 9 } };
  grid.spacing = Vector::Ones();
  const auto points = BoxPoints(8.0);
  double     volume = 0.0;
  for (const auto & t : mmm::TetrahedralizeWithin(grid, points))
  {
    ASSERT_LT(*std::max_element(t.begin(), t.end()), points.size());
    volume += mmm::TetrahedronVolume(points[t[0]], points[t[1]], points[t[2]], points[t[3]]);
  }
  EXPECT_NEAR(volume, 512.0, 1e-9);
}

TEST(Enclosure, RefusesPointsInOnePlane)
{
  mmm::Grid grid;
  grid.size = { { 9, 9, 9 } };
  grid.spacing = Vector::Ones();
  auto points = BoxPoints(8.0);
  points.resize(4);
  EXPECT_THROW(mmm::TetrahedralizeWithin(grid, points), itk::ExceptionObject);
}
