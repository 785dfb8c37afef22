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
// Edge lengths by errors: against what the rates of convergence say, and through the mesher.
#include "itkErrorDrivenSizing.h"
#include "itkLabelImageToTetrahedralMeshFilter.h"

#include "support/TestLabelImages.h"

#include "itkImageRegionConstIterator.h"
#include "itkMeshFileWriter.h"
#include "itkVTUMeshIO.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace
{
using Sizing = itk::ErrorDrivenSizing;
using Point = itk::Point<double, 3>;
using LabelImage = itk::Image<short, 3>;
using Mesher = itk::LabelImageToTetrahedralMeshFilter<LabelImage>;

/** A ball of 9 voxels' radius. */
LabelImage::Pointer
Ball()
{
  return mmmtest::MakeImage<LabelImage>(
    24, 24, 24, [](int i, int j, int k) { return std::hypot(i - 11.5, j - 11.5, k - 11.5) < 9.0; });
}

itk::LabelTetrahedralMesh::Pointer
MeshOf(LabelImage * image, Sizing::ImageType * sizes = nullptr)
{
  const auto mesher = Mesher::New();
  mesher->SetInput(image);
  mesher->SetSizingImage(sizes);
  mesher->Update();
  return mesher->GetOutput();
}

Point
MiddleOf(const itk::LabelTetrahedralMesh * mesh, itk::IdentifierType cell)
{
  itk::LabelTetrahedralMesh::CellAutoPointer tetrahedron;
  mesh->GetCell(cell, tetrahedron);
  Point middle;
  middle.Fill(0.0);
  for (auto point = tetrahedron->PointIdsBegin(); point != tetrahedron->PointIdsEnd(); ++point)
  {
    middle += 0.25 * mesh->GetPoint(*point).GetVectorFromOrigin();
  }
  return middle;
}

std::vector<double>
ErrorsBy(const itk::LabelTetrahedralMesh * mesh, const std::function<double(const Point &)> & error)
{
  std::vector<double> errors;
  for (itk::IdentifierType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    errors.push_back(error(MiddleOf(mesh, cell)));
  }
  return errors;
}

bool
IsUpper(const Point & point)
{
  return point[2] > 11.5;
}

std::size_t
CountIn(const itk::LabelTetrahedralMesh * mesh, const std::function<bool(const Point &)> & isIn)
{
  std::size_t count = 0;
  for (itk::IdentifierType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    count += isIn(MiddleOf(mesh, cell));
  }
  return count;
}

class ErrorDrivenSizing : public ::testing::Test
{
protected:
  void
  SetErrors(const std::function<double(const Point &)> & error)
  {
    sizing->SetErrors(mesh, ErrorsBy(mesh, error));
  }

  void
  ExpectError(const std::vector<double> & errors, const char * text)
  {
    try
    {
      sizing->SetErrors(mesh, errors);
      FAIL() << "no exception with: " << text;
    }
    catch (const itk::ExceptionObject & exception)
    {
      EXPECT_NE(std::string(exception.GetDescription()).find(text), std::string::npos) << exception.GetDescription();
    }
  }

  const LabelImage::Pointer                image{ Ball() };
  const itk::LabelTetrahedralMesh::Pointer mesh{ MeshOf(image) };
  const Sizing::Pointer                    sizing{ Sizing::New() };
};
} // namespace

TEST_F(ErrorDrivenSizing, AsksForNothingWhereThereIsNoError)
{
  this->SetErrors([](const Point & point) { return IsUpper(point) ? 1.0 : 0.0; });
  const auto  sizes = sizing->Compute(image);
  std::size_t shorter = 0;
  for (itk::ImageRegionConstIteratorWithIndex<Sizing::ImageType> it(sizes, sizes->GetBufferedRegion()); !it.IsAtEnd();
       ++it)
  {
    if (it.GetIndex()[2] < 8)
    {
      EXPECT_EQ(it.Get(), std::numeric_limits<float>::infinity()) << it.GetIndex();
    }
    shorter += it.Get() < std::numeric_limits<float>::infinity();
  }
  EXPECT_GT(shorter, 1000u);
}

TEST_F(ErrorDrivenSizing, ShortensAllEdgesAlikeWhereErrorsAreLikeVolumes)
{
  // the same error per volume, and tetrahedra of about the same size
  this->SetErrors([](const Point &) { return 1.0; });
  sizing->SetFactor(8.0);
  const auto sizes = sizing->Compute(image);
  double     sum = 0.0;
  int        count = 0;
  for (itk::ImageRegionConstIterator<Sizing::ImageType> it(sizes, sizes->GetBufferedRegion()); !it.IsAtEnd(); ++it)
  {
    if (it.Get() < std::numeric_limits<float>::infinity())
    {
      sum += it.Get();
      ++count;
    }
  }
  const double before =
    std::cbrt(4.0 / 3.0 * 3.14159 * 729.0 / double(mesh->GetNumberOfCells()) * 6.0 * std::sqrt(2.0));
  EXPECT_NEAR(sum / count, before / 2.0, 0.15 * before);
}

TEST_F(ErrorDrivenSizing, GivesAsManyTetrahedraAsItIsToldAndWhereTheErrorIs)
{
  this->SetErrors([](const Point & point) { return IsUpper(point) ? 1.0 : 0.1; });
  sizing->SetFactor(3.0);
  const auto refined = MeshOf(image, sizing->Compute(image));
  EXPECT_NEAR(double(refined->GetNumberOfCells()) / double(mesh->GetNumberOfCells()), 3.0, 0.9);
  const auto isLower = [](const Point & point) { return point[2] < 8.0; };
  const auto isHigh = [](const Point & point) { return point[2] > 15.0; };
  EXPECT_LT(double(CountIn(refined, isLower)) / double(CountIn(mesh, isLower)), 1.5);
  EXPECT_GT(double(CountIn(refined, isHigh)) / double(CountIn(mesh, isHigh)), 3.0);
}

TEST_F(ErrorDrivenSizing, MakesEdgesNoShorterThanAQuarter)
{
  // all of the error is in one place
  this->SetErrors([](const Point & point) { return point.EuclideanDistanceTo(Point(11.5)) < 3.0 ? 1.0 : 1e-9; });
  sizing->SetFactor(4.0);
  const auto sizes = sizing->Compute(image);
  for (itk::ImageRegionConstIterator<Sizing::ImageType> it(sizes, sizes->GetBufferedRegion()); !it.IsAtEnd(); ++it)
  {
    EXPECT_GT(it.Get(), 0.25f * 1.0f);
  }
}

TEST_F(ErrorDrivenSizing, ReadsErrorsFromCellDataOfThatName)
{
  const auto errors = ErrorsBy(mesh, [](const Point & point) { return IsUpper(point) ? 1.0 : 0.25; });
  const auto fileName = ::testing::TempDir() + "itkErrorDrivenSizing.vtu";
  const auto io = itk::VTUMeshIO::New();
  const auto writer = itk::MeshFileWriter<itk::LabelTetrahedralMesh>::New();
  io->SetCellArrays({ { "error", errors } });
  writer->SetMeshIO(io);
  writer->SetInput(mesh);
  writer->SetFileName(fileName);
  writer->Update();

  sizing->SetErrors(mesh, errors);
  const auto expected = sizing->Compute(image);
  const auto other = Sizing::New();
  other->ReadErrors(fileName);
  const auto                                       sizes = other->Compute(image);
  itk::ImageRegionConstIterator<Sizing::ImageType> it(sizes, sizes->GetBufferedRegion());
  itk::ImageRegionConstIterator<Sizing::ImageType> expectedIt(expected, expected->GetBufferedRegion());
  for (; !it.IsAtEnd(); ++it, ++expectedIt)
  {
    ASSERT_TRUE(it.Get() == expectedIt.Get());
  }
  EXPECT_THROW(other->ReadErrors(fileName, "no-such-array"), itk::ExceptionObject);
}

TEST_F(ErrorDrivenSizing, RefusesWhatIsNoError)
{
  std::vector<double> errors(mesh->GetNumberOfCells(), 1.0);
  errors.back() = -1.0;
  this->ExpectError(errors, "is -1; it has to be a number of at least 0");
  errors.back() = std::numeric_limits<double>::quiet_NaN();
  this->ExpectError(errors, "it has to be a number of at least 0");
  errors.pop_back();
  this->ExpectError(errors, "errors for");
  this->ExpectError(std::vector<double>(mesh->GetNumberOfCells(), 0.0), "there is nothing to refine");
}

TEST_F(ErrorDrivenSizing, RefusesAnotherImage)
{
  this->SetErrors([](const Point &) { return 1.0; });
  const auto   elsewhere = Ball();
  const double origin[] = { 100.0, 0.0, 0.0 };
  elsewhere->SetOrigin(origin);
  EXPECT_THROW(sizing->Compute(elsewhere), itk::ExceptionObject);
  EXPECT_NO_THROW(sizing->Compute(image));
}

TEST_F(ErrorDrivenSizing, RefusesParametersOutOfTheirRange)
{
  this->SetErrors([](const Point &) { return 1.0; });
  sizing->SetFactor(1.0);
  EXPECT_THROW(sizing->Compute(image), itk::ExceptionObject);
  sizing->SetFactor(2.0);
  sizing->SetOrder(3);
  EXPECT_THROW(sizing->Compute(image), itk::ExceptionObject);
  sizing->SetOrder(2);
  EXPECT_NO_THROW(sizing->Compute(image));
}
