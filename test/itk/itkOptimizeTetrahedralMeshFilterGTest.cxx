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
#include "itkLabelImageToTetrahedralMeshFilter.h"
#include "itkOptimizeTetrahedralMeshFilter.h"
#include "itkTetrahedralMeshQualityCalculator.h"
#include "mesh/InterfaceMesh.h"
#include "base/Points.h"
#include "support/TestLabelImages.h"
#include "support/TestMeshes.h"
#include "delaunay/TetGen.h"

#include "itkHexahedronCell.h"
#include "itkTetrahedronCell.h"
#include "itkTriangleCell.h"

#include <cmath>

namespace
{
using LabelImage = itk::Image<unsigned char, 3>;
using Mesh = itk::LabelTetrahedralMesh;
using FilterType = itk::OptimizeTetrahedralMeshFilter<Mesh>;
using Calculator = itk::TetrahedralMeshQualityCalculator<Mesh>;
using mmm::Vector;

Mesh::Pointer
MakeMesh(const std::vector<Vector> & points, const std::vector<mmm::Tetrahedron> & tetrahedra, std::vector<int> labels)
{
  const auto mesh = Mesh::New();
  itk::FillMesh({ mmm::ToPoints(points), tetrahedra, std::move(labels) }, mesh.GetPointer());
  return mesh;
}

/** What TetGen makes of the surface of a ball of two halves, with points on a grid inside: a mesh with slivers. */
Mesh::Pointer
MakeTetGenMesh()
{
  constexpr double radius = 8.0;
  constexpr int    size = 22;
  const auto       filter = itk::LabelImageToTetrahedralMeshFilter<LabelImage>::New();
  filter->SetInput(mmmtest::MakeHalves<LabelImage>(size, radius, 3, 7));
  filter->SetSurfaceOnly(true);
  filter->Update();
  auto               points = mmmtest::PointsOf(filter->GetSurface());
  const auto         cells = mmmtest::CellsOf<3>(filter->GetSurface());
  const auto &       sides = mmmtest::CellDataOf(filter->GetSurface());
  mmm::InterfaceMesh interfaces;
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    interfaces.triangles.push_back(
      { { mmm::PointId(cells[c][0]), mmm::PointId(cells[c][1]), mmm::PointId(cells[c][2]) } });
    interfaces.sides.push_back({ { mmm::Material(sides[c][0]), mmm::Material(sides[c][1]) } });
  }
  const Vector centre = Vector::Constant(0.5 * (size - 1));
  for (double x = -6.0; x <= 6.0; x += 2.1)
  {
    for (double y = -6.0; y <= 6.0; y += 1.9)
    {
      for (double z = -6.0; z <= 6.0; z += 2.0)
      {
        const Vector d(x, y, z);
        if (d.norm() < radius - 1.0 && std::abs(z) > 0.7)
        {
          points.push_back(centre + d);
        }
      }
    }
  }
  const auto                    all = mmm::ConstrainedTetrahedralization(points, interfaces.triangles);
  const auto                    materials = *mmm::LabelByInterfaces(interfaces, all, 0);
  std::vector<mmm::Tetrahedron> tetrahedra;
  std::vector<int>              labels;
  for (std::size_t t = 0; t < all.size(); ++t)
  {
    if (materials[t] != 0)
    {
      tetrahedra.push_back(all[t]);
      labels.push_back(materials[t]);
    }
  }
  return MakeMesh(points, tetrahedra, labels);
}

/** A box of n^3 cubes, each of six tetrahedra; label 1 below the middle and 2 above it. Points inside are shaken. */
Mesh::Pointer
MakeBox(int n)
{
  std::vector<Vector> points;
  const auto          at = [n](int i, int j, int k) { return std::uint32_t((k * (n + 1) + j) * (n + 1) + i); };
  for (int k = 0; k <= n; ++k)
  {
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i <= n; ++i)
      {
        Vector x(i, j, k);
        if (i % n && j % n && k % n && k != n / 2)
        {
          x += 0.4 * Vector(std::sin(7.0 * i + k), std::sin(5.0 * j + i), std::sin(3.0 * k + j));
        }
        points.push_back(x);
      }
    }
  }
  constexpr int orders[6][3] = { { 0, 1, 2 }, { 1, 2, 0 }, { 2, 0, 1 }, { 0, 2, 1 }, { 2, 1, 0 }, { 1, 0, 2 } };
  std::vector<mmm::Tetrahedron> tetrahedra;
  std::vector<int>              labels;
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        for (const auto & order : orders)
        {
          int              corner[3] = { i, j, k };
          mmm::Tetrahedron tetrahedron{ { at(i, j, k), 0, 0, 0 } };
          for (int step = 0; step < 3; ++step)
          {
            ++corner[order[step]];
            tetrahedron[step + 1] = at(corner[0], corner[1], corner[2]);
          }
          tetrahedra.push_back(tetrahedron);
          labels.push_back(k < n / 2 ? 1 : 2);
        }
      }
    }
  }
  return MakeMesh(points, tetrahedra, labels);
}

Calculator::ReportType
QualityOf(const Mesh * mesh)
{
  const auto calculator = Calculator::New();
  calculator->SetMesh(mesh);
  calculator->ComputeBettiNumbersOn();
  calculator->Compute();
  return calculator->GetReport();
}

FilterType::Pointer
Optimize(const Mesh * mesh)
{
  const auto filter = FilterType::New();
  filter->SetInput(mesh);
  filter->Update();
  return filter;
}
} // namespace

TEST(OptimizeTetrahedralMeshFilter, EndsTheSliversOfATetGenMesh)
{
  const auto mesh = MakeTetGenMesh();
  const auto before = QualityOf(mesh).tetrahedra;
  const auto after = QualityOf(Optimize(mesh)->GetOutput()).tetrahedra;
  EXPECT_LT(before.smallestAngle.minimum, 8.0);
  EXPECT_GT(after.smallestAngle.minimum, 15.0);
  EXPECT_LT(after.largestAngle, 160.0);
  EXPECT_GT(after.radiusRatio.average, before.radiusRatio.average);
}

TEST(OptimizeTetrahedralMeshFilter, KeepsVolumesAndTopology)
{
  const auto mesh = MakeTetGenMesh();
  const auto filter = Optimize(mesh);
  const auto before = QualityOf(mesh);
  const auto after = QualityOf(filter->GetOutput());
  EXPECT_EQ(after.tetrahedra.nonPositive, 0u);
  EXPECT_EQ(after.unusedPoints, 0u);
  EXPECT_EQ(after.overusedFaces, 0u);
  ASSERT_EQ(after.labels.size(), 2u);
  for (std::size_t n = 0; n < 2; ++n)
  {
    EXPECT_EQ(after.labels[n].label, before.labels[n].label);
    EXPECT_NEAR(
      after.labels[n].tetrahedra.volume, before.labels[n].tetrahedra.volume, 0.01 * before.labels[n].tetrahedra.volume);
    EXPECT_EQ(after.labels[n].betti, before.labels[n].betti);
    EXPECT_EQ(after.labels[n].openEdges, 0u);
    EXPECT_EQ(after.labels[n].nonManifoldEdges, 0u);
  }
}

TEST(OptimizeTetrahedralMeshFilter, PointsOfInterfacesStayOnThem)
{
  const auto mesh = MakeTetGenMesh();
  const auto filter = Optimize(mesh);
  EXPECT_GT(filter->GetLargestTolerance(), 0.0);
  const Vector centre = Vector::Constant(10.5);
  // the first mesh tells how far its own outside is from the ball's centre
  const auto range = [&centre](const Mesh * of) {
    const auto points = mmmtest::PointsOf(of);
    const auto cells = mmmtest::CellsOf<4>(of);
    double     least = 1e30;
    double     most = 0.0;
    for (const auto & face : mmmtest::FacesOf(of))
    {
      if (face.second.size() == 1)
      {
        for (const auto p : face.first)
        {
          least = std::min(least, (points[p] - centre).norm());
          most = std::max(most, (points[p] - centre).norm());
        }
      }
    }
    return std::make_pair(least, most);
  };
  const auto before = range(mesh);
  const auto after = range(filter->GetOutput());
  EXPECT_GT(after.first, before.first - filter->GetLargestTolerance());
  EXPECT_LT(after.second, before.second + filter->GetLargestTolerance());
}

TEST(OptimizeTetrahedralMeshFilter, KeepsPlanesCreasesAndCorners)
{
  constexpr int n = 6;
  const auto    mesh = MakeBox(n);
  const auto    filter = Optimize(mesh);
  EXPECT_GT(QualityOf(filter->GetOutput()).tetrahedra.smallestAngle.minimum,
            QualityOf(mesh).tetrahedra.smallestAngle.minimum);
  const auto volumes = mmmtest::VolumesOf(filter->GetOutput());
  ASSERT_EQ(volumes.size(), 2u);
  EXPECT_NEAR(volumes.at(1), 0.5 * n * n * n, 1e-9);
  EXPECT_NEAR(volumes.at(2), 0.5 * n * n * n, 1e-9);
  std::size_t corners = 0;
  for (const Vector & x : mmmtest::PointsOf(filter->GetOutput()))
  {
    corners += (x[0] == 0.0 || x[0] == n) && (x[1] == 0.0 || x[1] == n) && (x[2] == 0.0 || x[2] == n);
  }
  EXPECT_EQ(corners, 8u);
}

TEST(OptimizeTetrahedralMeshFilter, NeverLowersTheWorstQuality)
{
  const auto source = itk::LabelImageToTetrahedralMeshFilter<LabelImage>::New();
  source->SetInput(mmmtest::MakeHalves<LabelImage>(22, 8.0));
  source->Update();
  // small and large angles count alike: 1 for those of the regular tetrahedron, 0 for flat ones
  const auto worstOf = [](const auto & mesh) {
    const auto quality = QualityOf(mesh).tetrahedra;
    return std::min(1.5 * (1.0 - std::cos(quality.smallestAngle.minimum * itk::Math::pi_over_180)),
                    0.75 * (1.0 + std::cos(quality.largestAngle * itk::Math::pi_over_180)));
  };
  EXPECT_GE(worstOf(Optimize(source->GetOutput())->GetOutput()), worstOf(source->GetOutput()) - 1e-9);
}

TEST(OptimizeTetrahedralMeshFilter, ResultDoesNotDependOnTheUnitOfLength)
{
  const auto mesh = MakeBox(4);
  const auto scaled = MakeBox(4);
  for (auto & point : scaled->GetPoints()->CastToSTLContainer())
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] *= 0x1p-10;
    }
  }
  const auto one = Optimize(mesh);
  const auto two = Optimize(scaled);
  EXPECT_EQ(mmmtest::CellsOf<4>(one->GetOutput()), mmmtest::CellsOf<4>(two->GetOutput()));
}

TEST(OptimizeTetrahedralMeshFilter, ResultDoesNotDependOnTheNumberOfThreads)
{
  const auto          mesh = MakeTetGenMesh();
  std::vector<Vector> points[2];
  for (const unsigned int threads : { 1, 3 })
  {
    const mmmtest::ThreadCount scope(threads);
    points[threads / 2] = mmmtest::PointsOf(Optimize(mesh)->GetOutput());
  }
  EXPECT_EQ(points[0], points[1]);
}

TEST(OptimizeTetrahedralMeshFilter, TurnsInvertedTetrahedra)
{
  const auto mesh = MakeBox(4);
  for (auto it = mesh->GetCells()->Begin(); it != mesh->GetCells()->End(); ++it)
  {
    if (it.Index() % 2)
    {
      std::swap(it.Value()->PointIdsBegin()[0], it.Value()->PointIdsBegin()[1]);
    }
  }
  const auto quality = QualityOf(Optimize(mesh)->GetOutput());
  EXPECT_EQ(quality.tetrahedra.nonPositive, 0u);
  EXPECT_NEAR(quality.tetrahedra.volume, 64.0, 1e-9);
}

TEST(OptimizeTetrahedralMeshFilter, LeavesOutCellsOfLowerDimension)
{
  const auto mesh = MakeBox(4);
  auto *     triangle = new itk::TriangleCell<Mesh::CellType>;
  for (int c = 0; c < 3; ++c)
  {
    triangle->SetPointId(c, c);
  }
  const auto number = mesh->GetNumberOfCells();
  mesh->GetCells()->InsertElement(number, triangle);
  mesh->GetCellData()->InsertElement(number, 99);
  const auto filter = Optimize(mesh);
  EXPECT_EQ(filter->GetNumberOfCellsLeftOut(), 1u);
  EXPECT_EQ(mmmtest::VolumesOf(filter->GetOutput()).count(99), 0u);
}

TEST(OptimizeTetrahedralMeshFilter, ThrowsOnHexahedra)
{
  const auto mesh = MakeBox(4);
  mesh->GetCells()->InsertElement(mesh->GetNumberOfCells(), new itk::HexahedronCell<Mesh::CellType>);
  const auto filter = FilterType::New();
  filter->SetInput(mesh);
  mmmtest::ExpectException([&] { filter->Update(); }, "is no tetrahedron");
}

TEST(OptimizeTetrahedralMeshFilter, ThrowsWithoutTetrahedra)
{
  const auto filter = FilterType::New();
  filter->SetInput(Mesh::New());
  mmmtest::ExpectException([&] { filter->Update(); }, "no tetrahedra");
}

TEST(OptimizeTetrahedralMeshFilter, ThrowsOnAToleranceThatIsNotPositive)
{
  const auto filter = FilterType::New();
  filter->SetInput(MakeBox(4));
  filter->SetTolerance(0.0);
  mmmtest::ExpectException([&] { filter->Update(); }, "Tolerance is 0");
}

TEST(OptimizeTetrahedralMeshFilter, AbortsIfToldTo)
{
  const auto filter = FilterType::New();
  filter->SetInput(MakeBox(4));
  mmmtest::AbortOnProgress(filter);
  EXPECT_THROW(filter->Update(), itk::ProcessAborted);
}

TEST(OptimizeTetrahedralMeshFilter, PrintsItsParameters)
{
  const auto text = mmmtest::Printed(FilterType::New().GetPointer());
  EXPECT_NE(text.find("FeatureAngle: 40"), std::string::npos);
  EXPECT_NE(text.find("Tolerance: nan"), std::string::npos);
}
