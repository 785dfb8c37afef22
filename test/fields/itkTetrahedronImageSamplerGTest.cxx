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
// What an image is in tetrahedra: against integrals that are known, and against a much finer quadrature.
#include "itkTetrahedronImageSampler.h"

#include "itkLinearInterpolateImageFunction.h"
#include "itkTetrahedronCell.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace
{
using Sampler = itk::TetrahedronImageSampler;
using Image = Sampler::ImageType;
using Point = itk::Point<double, 3>;
using Corners = std::array<Point, 4>;

itk::LabelTetrahedralMesh::Pointer
MakeMesh(const std::vector<Corners> & tetrahedra)
{
  const auto mesh = itk::LabelTetrahedralMesh::New();
  for (std::size_t n = 0; n < tetrahedra.size(); ++n)
  {
    itk::LabelTetrahedralMesh::CellAutoPointer cell;
    cell.TakeOwnership(new itk::TetrahedronCell<itk::LabelTetrahedralMesh::CellType>);
    for (unsigned int c = 0; c < 4; ++c)
    {
      mesh->SetPoint(4 * n + c, tetrahedra[n][c]);
      cell->SetPointId(c, 4 * n + c);
    }
    mesh->SetCell(n, cell);
    mesh->SetCellData(n, 1);
  }
  return mesh;
}

/** 20 x 20 x 20 voxels, oblique and of different edges, with a function of the place. */
Image::Pointer
MakeImage(const std::function<double(const Point &)> & function)
{
  const auto image = Image::New();
  image->SetRegions(itk::Size<3>{ { 20, 20, 20 } });
  const double spacing[] = { 1.0, 1.5, 2.0 };
  const double origin[] = { -10.0, 5.0, 30.0 };
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  Image::DirectionType direction;
  direction.SetIdentity();
  direction[0][0] = direction[1][1] = 0.6;
  direction[0][1] = -0.8;
  direction[1][0] = 0.8;
  image->SetDirection(direction);
  image->Allocate();
  const std::size_t count = image->GetBufferedRegion().GetNumberOfPixels();
  for (std::size_t n = 0; n < count; ++n)
  {
    Point point;
    image->TransformIndexToPhysicalPoint(image->ComputeIndex(itk::OffsetValueType(n)), point);
    image->GetBufferPointer()[n] = static_cast<float>(function(point));
  }
  return image;
}

/** A place in an image, by voxels. */
Point
PlaceOf(const Image * image, double i, double j, double k)
{
  itk::ContinuousIndex<double, 3> index;
  index[0] = i;
  index[1] = j;
  index[2] = k;
  Point point;
  image->TransformContinuousIndexToPhysicalPoint(index, point);
  return point;
}

/** Tetrahedra of about `size` voxels, inside of the image. */
std::vector<Corners>
RandomTetrahedra(const Image * image, double size, int count)
{
  std::mt19937         random(1);
  const auto           draw = [&] { return (random() % 10001) / 10000.0; };
  std::vector<Corners> tetrahedra;
  for (int n = 0; n < count; ++n)
  {
    double center[3];
    for (double & coordinate : center)
    {
      coordinate = size + draw() * (19.0 - 2.0 * size);
    }
    Corners corners;
    for (Point & corner : corners)
    {
      corner = PlaceOf(
        image, center[0] + size * (draw() - 0.5), center[1] + size * (draw() - 0.5), center[2] + size * (draw() - 0.5));
    }
    tetrahedra.push_back(corners);
  }
  return tetrahedra;
}

std::vector<double>
Sample(const std::vector<Corners> & tetrahedra, const Image * image, const std::string & mode)
{
  const auto sampler = Sampler::New();
  sampler->SetMesh(MakeMesh(tetrahedra));
  sampler->SetMode(mode);
  return sampler->Sample(image);
}

/** The mean over many random points of a tetrahedron, of the image interpolated linearly. */
double
FineMean(const Corners & corners, const Image * image)
{
  constexpr int count = 50000;
  std::mt19937  random(3);
  const auto    interpolator = itk::LinearInterpolateImageFunction<Image, double>::New();
  interpolator->SetInputImage(image);
  double sum = 0.0;
  for (int n = 0; n < count; ++n)
  {
    std::array<double, 3> cuts;
    for (double & cut : cuts)
    {
      cut = random() / 4294967296.0;
    }
    std::sort(cuts.begin(), cuts.end());
    const Point point = corners[0] + (corners[1] - corners[0]) * cuts[0] +
                        (corners[2] - corners[0]) * (cuts[1] - cuts[0]) +
                        (corners[3] - corners[0]) * (cuts[2] - cuts[1]);
    sum += interpolator->Evaluate(point);
  }
  return sum / count;
}
} // namespace

TEST(TetrahedronImageSampler, MeanOfALinearFunctionIsThatAtTheCenter)
{
  const auto function = [](const Point & x) { return 3.0 + 0.5 * x[0] - 2.0 * x[1] + 0.25 * x[2]; };
  const auto image = MakeImage(function);
  const auto tetrahedra = RandomTetrahedra(image, 3.0, 50);
  for (const char * const mode : { "mean", "linear" })
  {
    const auto values = Sample(tetrahedra, image, mode);
    for (std::size_t n = 0; n < tetrahedra.size(); ++n)
    {
      Point center;
      center.SetToBarycentricCombination(
        tetrahedra[n].data(), std::array<double, 4>{ 0.25, 0.25, 0.25, 0.25 }.data(), 4);
      EXPECT_NEAR(values[n], function(center), 1e-4) << mode;
    }
  }
}

TEST(TetrahedronImageSampler, MeanOfNoiseIsWithinOnePercentOfAFineQuadrature)
{
  std::mt19937 random(7);
  const auto   image = MakeImage([&](const Point &) { return 50.0 + 100.0 * ((random() % 1001) / 1000.0); });
  for (const double size : { 0.7, 2.0, 5.0 })
  {
    const auto tetrahedra = RandomTetrahedra(image, size, 6);
    const auto values = Sample(tetrahedra, image, "mean");
    for (std::size_t n = 0; n < tetrahedra.size(); ++n)
    {
      const double expected = FineMean(tetrahedra[n], image);
      EXPECT_NEAR(values[n], expected, 0.01 * expected) << size;
    }
  }
}

TEST(TetrahedronImageSampler, ConservesTheIntegralOverTheWhole)
{
  // a cube of six tetrahedra between the centers of voxels, and one voxel of 1 within it
  const auto image = MakeImage([](const Point &) { return 0.0; });
  image->SetPixel({ { 8, 9, 10 } }, 1.0f);
  std::vector<Corners> tetrahedra;
  std::array<int, 3>   axes{ { 0, 1, 2 } };
  do
  {
    Corners               corners;
    std::array<double, 3> at{ { 5.0, 6.0, 7.0 } };
    for (int c = 0; c < 4; ++c)
    {
      corners[c] = PlaceOf(image, at[0], at[1], at[2]);
      at[axes[std::min(c, 2)]] += 6.0;
    }
    tetrahedra.push_back(corners);
  } while (std::next_permutation(axes.begin(), axes.end()));
  double sum = 0.0;
  for (const double value : Sample(tetrahedra, image, "mean"))
  {
    sum += value * 6.0 * 6.0 * 6.0 / 6.0;
  }
  EXPECT_NEAR(sum, 1.0, 0.01);
}

TEST(TetrahedronImageSampler, NearestTakesTheVoxelOfTheCenter)
{
  const auto image = MakeImage([](const Point &) { return 0.0; });
  image->SetPixel({ { 8, 9, 10 } }, 7.0f);
  const auto around = [&](double i, double j, double k) {
    return Corners{ { PlaceOf(image, i - 1, j, k),
                      PlaceOf(image, i + 1, j, k),
                      PlaceOf(image, i, j - 1, k + 1),
                      PlaceOf(image, i, j + 1, k - 1) } };
  };
  const auto values = Sample({ around(8.4, 8.6, 10.3), around(8.6, 9, 10) }, image, "nearest");
  EXPECT_EQ(values, (std::vector<double>{ 7.0, 0.0 }));
}

TEST(TetrahedronImageSampler, OutsideIsNotANumberAndCounted)
{
  const auto image = MakeImage([](const Point &) { return 4.0; });
  const auto at = [&](double i) {
    return Corners{
      { PlaceOf(image, i, 3, 3), PlaceOf(image, i + 2, 3, 3), PlaceOf(image, i, 5, 3), PlaceOf(image, i, 3, 5) }
    };
  };
  const auto sampler = Sampler::New();
  sampler->SetMesh(MakeMesh({ at(5.0), at(18.5), at(30.0) }));
  const auto values = sampler->Sample(image);
  EXPECT_NEAR(values[0], 4.0, 1e-6);
  EXPECT_NEAR(values[1], 4.0, 1e-6);
  EXPECT_TRUE(std::isnan(values[2]));
  EXPECT_EQ(sampler->GetNumberOutside(), 1u);
  EXPECT_EQ(sampler->GetNumberPartlyOutside(), 1u);
}

TEST(TetrahedronImageSampler, RefusesWhatItDoesNotKnow)
{
  const auto image = MakeImage([](const Point &) { return 4.0; });
  const auto sampler = Sampler::New();
  EXPECT_THROW(sampler->Sample(image), itk::ExceptionObject);
  sampler->SetMesh(MakeMesh(RandomTetrahedra(image, 1.0, 1)));
  EXPECT_THROW(sampler->Sample(nullptr), itk::ExceptionObject);
  sampler->SetMode("median");
  EXPECT_THROW(sampler->Sample(image), itk::ExceptionObject);
}
