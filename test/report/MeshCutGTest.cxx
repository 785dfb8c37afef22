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
#include "report/MeshCut.h"

#include "itkTetrahedronArrays.h"
#include "base/Points.h"
#include "support/TestMeshes.h"
#include "support/TestTetrahedra.h"

#include "itkMath.h"
#include "itkTriangleCell.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using mmm::CutPlane;
using mmm::Vector;

struct TestMesh
{
  std::vector<Vector>                points;
  itk::LabelTetrahedralMesh::Pointer mesh;
};

/** Cubes of a grid, six tetrahedra in each, with labels by their middles. */
template <typename TFunction>
TestMesh
MakeBox(const mmm::Grid & grid, const TFunction & labelOf)
{
  TestMesh               box{ mmmtest::MakeNodes(grid), itk::LabelTetrahedralMesh::New() };
  itk::TetrahedronArrays arrays;
  arrays.points = mmm::ToPoints(box.points);
  arrays.tetrahedra = mmmtest::MakeFreudenthalTetrahedra(grid);
  for (const auto & t : arrays.tetrahedra)
  {
    const auto & x = box.points;
    arrays.labels.push_back(labelOf(Vector(0.25 * (x[t[0]] + x[t[1]] + x[t[2]] + x[t[3]]))));
  }
  itk::FillMesh(arrays, box.mesh.GetPointer());
  return box;
}

/** A box of 4 x 6 x 8 with a label on each side of the plane x = 1. */
TestMesh
MakeHalves()
{
  mmm::Grid grid;
  grid.size = { { 5, 4, 5 } };
  grid.spacing = Vector(1.0, 2.0, 2.0);
  return MakeBox(grid, [](const Vector & x) { return x[0] < 1.0 ? 3 : 7; });
}

/** A ball around the origin: cubes in each other become spheres. */
TestMesh
MakeBall(int nodes, double radius)
{
  mmm::Grid grid;
  grid.size = { { nodes, nodes, nodes } };
  TestMesh     ball = MakeBox(grid, [](const Vector &) { return 1; });
  const double half = 0.5 * (nodes - 1);
  for (Vector & x : ball.points)
  {
    x -= Vector::Constant(half);
    const double norm = x.norm();
    x *= norm > 0.0 ? radius / half * x.cwiseAbs().maxCoeff() / norm : 0.0;
  }
  return ball;
}
} // namespace

TEST(MeshCut, AreasOfABoxAreExact)
{
  const auto box = MakeHalves();
  const auto areas = mmm::AreasByLabel(mmm::CutTetrahedra(*box.mesh, box.points, { 2, { { 0, 1 } }, 3.3 }));
  ASSERT_EQ(areas.size(), 2u);
  EXPECT_NEAR(areas.at(3), 6.0, 1e-12);
  EXPECT_NEAR(areas.at(7), 18.0, 1e-12);
}

TEST(MeshCut, PlaneThroughPointsAndFacesCutsOnce)
{
  const auto box = MakeHalves();
  for (const double position : { 2.0, 4.0, 8.0 })
  {
    const auto areas = mmm::AreasByLabel(mmm::CutTetrahedra(*box.mesh, box.points, { 2, { { 0, 1 } }, position }));
    EXPECT_NEAR(areas.at(3) + areas.at(7), 24.0, 1e-12) << position;
  }
  // the faces on x = 1 belong to the label below
  const auto areas = mmm::AreasByLabel(mmm::CutTetrahedra(*box.mesh, box.points, { 0, { { 1, 2 } }, 1.0 }));
  EXPECT_NEAR(areas.at(3), 48.0, 1e-12);
  EXPECT_EQ(areas.count(7), 0u);
}

TEST(MeshCut, PlaneBesideTheMeshCutsNothing)
{
  const auto box = MakeHalves();
  EXPECT_TRUE(mmm::CutTetrahedra(*box.mesh, box.points, { 1, { { 0, 2 } }, 6.5 }).cells.empty());
  EXPECT_TRUE(mmm::CutTetrahedra(*itk::LabelTetrahedralMesh::New(), {}, CutPlane()).cells.empty());
}

TEST(MeshCut, DiscOfABallHasItsArea)
{
  const double radius = 10.0;
  const auto   ball = MakeBall(29, radius);
  for (const double position : { 0.0, 0.31, -6.0 })
  {
    for (const CutPlane & plane : { CutPlane{ 2, { { 0, 1 } }, position },
                                    CutPlane{ 1, { { 0, 2 } }, position },
                                    CutPlane{ 0, { { 2, 1 } }, position } })
    {
      const double area = mmm::AreasByLabel(mmm::CutTetrahedra(*ball.mesh, ball.points, plane)).at(1);
      const double expected = itk::Math::pi * (radius * radius - position * position);
      EXPECT_NEAR(area, expected, 0.01 * expected) << plane.normal << ' ' << position;
    }
  }
}

TEST(MeshCut, CellsAreCounterClockwise)
{
  const auto ball = MakeBall(9, 1.0);
  const auto cut = mmm::CutTetrahedra(*ball.mesh, ball.points, { 0, { { 2, 1 } }, 0.123 });
  ASSERT_GT(cut.cells.size(), 100u);
  for (const auto & cell : cut.cells)
  {
    EXPECT_GT(mmm::TwiceArea(cut.points, cell), 0.0);
  }
}

TEST(MeshCut, CellsMeetInCommonPoints)
{
  const auto ball = MakeBall(9, 1.0);
  const auto cut = mmm::CutTetrahedra(*ball.mesh, ball.points, { 2, { { 0, 1 } }, 0.123 });
  // a disc: points - edges + cells = 1
  const auto edges = mmm::EdgesOf(cut.cells);
  EXPECT_EQ(cut.points.size() + cut.cells.size(), edges.size() + 1);
}

TEST(MeshCut, SegmentsOfASurfaceGoAround)
{
  // the outside of a ball, of triangles
  const auto ball = MakeBall(29, 10.0);
  const auto surface = itk::LabelInterfaceMesh::New();
  const auto cells = itk::LabelInterfaceMesh::CellsContainer::New();
  for (const auto & [corners, tetrahedra] : mmmtest::FacesOf(ball.mesh.GetPointer()))
  {
    if (tetrahedra.size() == 1)
    {
      auto * const cell = new itk::TriangleCell<itk::LabelInterfaceMesh::CellType>;
      for (unsigned int c = 0; c < 3; ++c)
      {
        cell->SetPointId(c, corners[c]);
      }
      cells->InsertElement(cells->Size(), cell);
    }
  }
  surface->SetCellsAllocationMethod(
    itk::MeshEnums::MeshClassCellsAllocationMethod::CellsAllocatedDynamicallyCellByCell);
  surface->SetCells(cells);
  const auto cut = mmm::CutTriangles(*surface, ball.points, { 2, { { 0, 1 } }, 0.05 });
  double     length = 0.0;
  for (const auto & edge : cut.edges)
  {
    const auto & a = cut.points[edge[0]];
    const auto & b = cut.points[edge[1]];
    length += std::hypot(b[0] - a[0], b[1] - a[1]);
  }
  EXPECT_NEAR(length, 2.0 * itk::Math::pi * 10.0, 0.02 * length);
  EXPECT_EQ(cut.points.size(), cut.edges.size());
}

TEST(MeshCut, VoxelsAreSquaresOfTheLayer)
{
  const itk::ImageRegion<3> region({ { -1, 0, 2 } }, { { 4, 3, 5 } });
  const auto                labelAt = [](const itk::Index<3> & index) { return index[1] == 0 ? 4 : int(index[2]); };
  const auto                cut = mmm::CutVoxels(labelAt, region, { 3, 4 }, { 2, { { 0, 1 } }, 3.2 });
  const auto                areas = mmm::AreasByLabel(cut);
  EXPECT_NEAR(areas.at(4), 4.0, 1e-12);
  EXPECT_NEAR(areas.at(3), 8.0, 1e-12);
  EXPECT_EQ(cut.points.front(), (mmm::PlanarPoint{ { -1.5, -0.5 } }));
  EXPECT_TRUE(mmm::CutVoxels(labelAt, region, { 3, 4 }, { 2, { { 0, 1 } }, 7.0 }).cells.empty());
  // labels that are not asked for are left out
  EXPECT_EQ(mmm::AreasByLabel(mmm::CutVoxels(labelAt, region, { 4 }, { 2, { { 0, 1 } }, 3.2 })).size(), 1u);
}
