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
#include "itkTetrahedralMeshQualityCalculator.h"

#include "itkDefaultDynamicMeshTraits.h"
#include "itkMesh.h"
#include "itkTetrahedronCell.h"
#include "itkTriangleCell.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace
{
template <typename TMesh, typename TCell>
void
AddCell(TMesh * mesh, itk::IdentifierType id, std::initializer_list<itk::IdentifierType> points)
{
  typename TMesh::CellAutoPointer cell;
  cell.TakeOwnership(new TCell);
  int i = 0;
  for (const auto point : points)
  {
    cell->SetPointId(i++, point);
  }
  mesh->SetCell(id, cell);
}

template <typename TMesh>
void
AddTetrahedron(TMesh *                                    mesh,
               itk::IdentifierType                        id,
               std::initializer_list<itk::IdentifierType> points,
               typename TMesh::CellPixelType              label)
{
  AddCell<TMesh, itk::TetrahedronCell<typename TMesh::CellType>>(mesh, id, points);
  mesh->SetCellData(id, label);
}

template <typename TMesh>
void
AddPoint(TMesh * mesh, itk::IdentifierType id, double x, double y, double z)
{
  typename TMesh::PointType point;
  point[0] = x;
  point[1] = y;
  point[2] = z;
  mesh->SetPoint(id, point);
}

/** The corner of a cube, and a flat tetrahedron of another label on its slanted face. */
template <typename TMesh>
typename TMesh::Pointer
MeshOfTwo(itk::IdentifierType firstPoint = 0, itk::IdentifierType step = 1, itk::IdentifierType firstCell = 0)
{
  const auto mesh = TMesh::New();
  const auto id = [=](int i) { return firstPoint + i * step; };
  AddPoint<TMesh>(mesh, id(0), 10, 20, 30);
  AddPoint<TMesh>(mesh, id(1), 11, 20, 30);
  AddPoint<TMesh>(mesh, id(2), 10, 21, 30);
  AddPoint<TMesh>(mesh, id(3), 10, 20, 31);
  AddPoint<TMesh>(mesh, id(4), 10.375, 20.375, 30.375);
  AddTetrahedron<TMesh>(mesh, firstCell, { id(0), id(1), id(2), id(3) }, 250);
  AddTetrahedron<TMesh>(mesh, firstCell + step, { id(1), id(2), id(3), id(4) }, 3);
  return mesh;
}

template <typename TMesh>
typename itk::TetrahedralMeshQualityCalculator<TMesh>::Pointer
CalculatorOf(const TMesh * mesh)
{
  const auto calculator = itk::TetrahedralMeshQualityCalculator<TMesh>::New();
  calculator->SetMesh(mesh);
  return calculator;
}

template <typename TMesh>
std::string
MessageOfCompute(const TMesh * mesh)
{
  const auto calculator = CalculatorOf(mesh);
  try
  {
    calculator->Compute();
  }
  catch (const itk::ExceptionObject & exception)
  {
    EXPECT_THROW(calculator->GetReport(), itk::ExceptionObject);
    return exception.GetDescription();
  }
  return "";
}

using FloatMesh = itk::Mesh<float, 3>;
using ShortMesh = itk::Mesh<unsigned short, 3>;
using DynamicMesh = itk::Mesh<double, 3, itk::DefaultDynamicMeshTraits<double, 3, 3, double>>;

template <typename TMesh>
void
ExpectReportOfTwo(const TMesh * mesh, itk::IdentifierType poorCell)
{
  const auto calculator = CalculatorOf(mesh);
  calculator->ComputeBettiNumbersOn();
  calculator->Compute();
  const auto & report = calculator->GetReport();
  EXPECT_EQ(calculator->GetNumberOfTetrahedra(), 2u);
  EXPECT_EQ(report.points, 5u);
  EXPECT_EQ(report.interfaceTriangles, 7u);
  ASSERT_EQ(report.labels.size(), 2u);
  EXPECT_EQ(report.labels[0].label, 3);
  EXPECT_EQ(report.labels[1].label, 250);
  EXPECT_NEAR(report.labels[0].tetrahedra.volume, 0.125 / 6.0, 1e-7);
  EXPECT_NEAR(report.labels[1].tetrahedra.volume, 1.0 / 6.0, 1e-7);
  EXPECT_EQ(report.labels[0].betti[0], 1);
  EXPECT_NEAR(report.labels[1].tetrahedra.radiusRatio.average, std::sqrt(3.0) - 1.0, 1e-6);
  EXPECT_EQ(calculator->GetMinimumRadiusRatio(), report.labels[0].tetrahedra.radiusRatio.minimum);
  EXPECT_DOUBLE_EQ(
    calculator->GetAverageRadiusRatio(),
    0.5 * (report.labels[0].tetrahedra.radiusRatio.average + report.labels[1].tetrahedra.radiusRatio.average));
  EXPECT_EQ(report.tetrahedra.nonPositive, 0u);
  // its height over an equilateral triangle is 0.125 / sqrt(3), and the triangle's inscribed radius 1 / sqrt(6)
  const double slope = std::atan(0.125 * std::sqrt(2.0)) * itk::Math::deg_per_rad;
  EXPECT_NEAR(calculator->GetMinimumDihedralAngle(), slope, 1e-4);
  EXPECT_GT(calculator->GetMaximumDihedralAngle(), 90.0);

  calculator->SetSmallestAngle(slope + 1.0);
  calculator->SetLargestAngle(180.0);
  calculator->Compute();
  ASSERT_EQ(calculator->GetReport().poorest.size(), 1u);
  EXPECT_EQ(calculator->GetReport().poorest[0].index, poorCell);
  EXPECT_EQ(calculator->GetReport().poorest[0].neighborLabels, std::vector<int>{ 250 });
  calculator->SetMaximumListed(0);
  calculator->Compute();
  EXPECT_TRUE(calculator->GetReport().poorest.empty());
  EXPECT_EQ(calculator->GetReport().poorTetrahedra, 1u);
}
} // namespace

TEST(itkTetrahedralMeshQualityCalculator, MeasuresMeshesOfAnyPixelType)
{
  ExpectReportOfTwo<FloatMesh>(MeshOfTwo<FloatMesh>(), 1);
  ExpectReportOfTwo<ShortMesh>(MeshOfTwo<ShortMesh>(), 1);
}

TEST(itkTetrahedralMeshQualityCalculator, FollowsIdentifiersThatAreNotContiguous)
{
  ExpectReportOfTwo<DynamicMesh>(MeshOfTwo<DynamicMesh>(100, 7, 12), 19);
}

TEST(itkTetrahedralMeshQualityCalculator, SkipsGapsInAVectorOfCells)
{
  ExpectReportOfTwo<FloatMesh>(MeshOfTwo<FloatMesh>(0, 1, 4), 5);
}

TEST(itkTetrahedralMeshQualityCalculator, MeshWithoutCellDataHasTheLabel0)
{
  const auto mesh = MeshOfTwo<FloatMesh>();
  mesh->SetCellData(nullptr);
  const auto calculator = CalculatorOf<FloatMesh>(mesh);
  calculator->Compute();
  ASSERT_EQ(calculator->GetReport().labels.size(), 1u);
  EXPECT_EQ(calculator->GetReport().labels[0].label, 0);
  EXPECT_EQ(calculator->GetReport().interfaceTriangles, 6u);
}

TEST(itkTetrahedralMeshQualityCalculator, EmptyMeshIsMeasured)
{
  const auto calculator = CalculatorOf<FloatMesh>(FloatMesh::New());
  calculator->Compute();
  EXPECT_EQ(calculator->GetNumberOfTetrahedra(), 0u);
}

TEST(itkTetrahedralMeshQualityCalculator, ThrowsOnACellThatIsNoTetrahedronAndNamesIt)
{
  const auto mesh = MeshOfTwo<FloatMesh>();
  AddCell<FloatMesh, itk::TriangleCell<FloatMesh::CellType>>(mesh, 2, { 0, 1, 2 });
  const auto message = MessageOfCompute<FloatMesh>(mesh);
  EXPECT_NE(message.find("Cell 2 is no tetrahedron"), std::string::npos) << message;
  EXPECT_NE(message.find("TRIANGLE_CELL"), std::string::npos) << message;
}

TEST(itkTetrahedralMeshQualityCalculator, ThrowsOnACellWithoutLabelAndNamesIt)
{
  const auto mesh = MeshOfTwo<FloatMesh>();
  AddCell<FloatMesh, itk::TetrahedronCell<FloatMesh::CellType>>(mesh, 2, { 0, 2, 1, 4 });
  const auto message = MessageOfCompute<FloatMesh>(mesh);
  EXPECT_NE(message.find("Cell 2 has no label"), std::string::npos) << message;
}

TEST(itkTetrahedralMeshQualityCalculator, ThrowsOnALabelThatIsNoWholeNumber)
{
  for (const float label : { 1.5f, 1e12f, std::nanf("") })
  {
    const auto mesh = MeshOfTwo<FloatMesh>();
    mesh->SetCellData(1, label);
    const auto message = MessageOfCompute<FloatMesh>(mesh);
    EXPECT_NE(message.find("Cell 1 has the label"), std::string::npos) << message;
  }
}

TEST(itkTetrahedralMeshQualityCalculator, ThrowsOnAPointThatTheMeshLacks)
{
  const auto mesh = MeshOfTwo<FloatMesh>();
  AddTetrahedron<FloatMesh>(mesh, 2, { 0, 1, 2, 5 }, 1);
  auto message = MessageOfCompute<FloatMesh>(mesh);
  EXPECT_NE(message.find("Cell 2 has the point 5"), std::string::npos) << message;

  const auto dynamicMesh = MeshOfTwo<DynamicMesh>(100, 7);
  AddTetrahedron<DynamicMesh>(dynamicMesh, 3, { 100, 107, 114, 115 }, 1);
  message = MessageOfCompute<DynamicMesh>(dynamicMesh);
  EXPECT_NE(message.find("Cell 3 has the point 115"), std::string::npos) << message;
}

TEST(itkTetrahedralMeshQualityCalculator, ThrowsOnAPointThatIsNotFinite)
{
  const auto mesh = MeshOfTwo<FloatMesh>();
  AddPoint<FloatMesh>(mesh, 2, 0, std::nan(""), 0);
  const auto message = MessageOfCompute<FloatMesh>(mesh);
  EXPECT_NE(message.find("Point 2"), std::string::npos) << message;
}

TEST(itkTetrahedralMeshQualityCalculator, ThrowsWithoutMeshAndBeforeCompute)
{
  const auto calculator = itk::TetrahedralMeshQualityCalculator<FloatMesh>::New();
  EXPECT_THROW(calculator->Compute(), itk::ExceptionObject);
  EXPECT_THROW(calculator->GetReport(), itk::ExceptionObject);
  EXPECT_THROW(calculator->GetNumberOfTetrahedra(), itk::ExceptionObject);
}

TEST(itkTetrahedralMeshQualityCalculator, ClampsAndPrintsItsParameters)
{
  const auto calculator = itk::TetrahedralMeshQualityCalculator<FloatMesh>::New();
  EXPECT_STREQ(calculator->GetNameOfClass(), "TetrahedralMeshQualityCalculator");
  EXPECT_EQ(calculator->GetSmallestAngle(), 10.0);
  EXPECT_EQ(calculator->GetLargestAngle(), 165.0);
  EXPECT_EQ(calculator->GetMaximumListed(), 1000u);
  EXPECT_EQ(calculator->GetDuplicateTolerance(), 1e-9);
  EXPECT_FALSE(calculator->GetComputeBettiNumbers());
  calculator->SetSmallestAngle(-5.0);
  EXPECT_EQ(calculator->GetSmallestAngle(), 0.0);
  calculator->SetLargestAngle(200.0);
  EXPECT_EQ(calculator->GetLargestAngle(), 180.0);
  calculator->SetDuplicateTolerance(-1.0);
  EXPECT_EQ(calculator->GetDuplicateTolerance(), 0.0);

  std::ostringstream before;
  calculator->Print(before);
  EXPECT_NE(before.str().find("Report: (not computed)"), std::string::npos);
  EXPECT_NE(before.str().find("LargestAngle: 180"), std::string::npos);

  calculator->SetMesh(MeshOfTwo<FloatMesh>());
  calculator->Compute();
  std::ostringstream after;
  calculator->Print(after);
  EXPECT_NE(after.str().find("tetrahedra: 2"), std::string::npos);
}
