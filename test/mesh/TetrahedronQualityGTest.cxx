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
#include "mesh/TetrahedronQuality.h"

#include "itkMath.h"

#include <gtest/gtest.h>

#include <random>

namespace
{
using mmm::Vector;
using Points = std::array<Vector, 4>;

const double Degrees = itk::Math::deg_per_rad;

double
RadiusRatio(const Points & p)
{
  return mmm::TetrahedronRadiusRatio(p[0], p[1], p[2], p[3]);
}
double
Volume(const Points & p)
{
  return mmm::TetrahedronVolume(p[0], p[1], p[2], p[3]);
}
std::array<double, 6>
Angles(const Points & p)
{
  return mmm::DihedralAngles(p[0], p[1], p[2], p[3]);
}
mmm::DihedralCosines
Cosines(const Points & p)
{
  return mmm::detail::Cosines(mmm::detail::TetrahedronNormals(p[0], p[1], p[2], p[3]));
}

Points
Regular()
{
  return { { Vector(1, 1, 1), Vector(-1, 1, -1), Vector(1, -1, -1), Vector(-1, -1, 1) } };
}

Points
Corner()
{
  return { { Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1) } };
}

/** Two crossing edges of length 2, one above the other by 2 h. It is regular for h = sqrt(1/2). */
Points
Crossed(double h)
{
  return { { Vector(1, 0, h), Vector(-1, 0, h), Vector(0, 1, -h), Vector(0, -1, -h) } };
}

std::vector<Points>
RandomTetrahedra(std::size_t count)
{
  std::mt19937                           generator(7);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  std::vector<Points>                    result(count);
  for (auto & tetrahedron : result)
  {
    for (auto & point : tetrahedron)
    {
      point = Vector(coordinate(generator), coordinate(generator), coordinate(generator));
    }
  }
  return result;
}

/** The angle at an edge between the directions to the two other points, seen along the edge. */
double
AngleSeenAlongEdge(const Points & p, int edge)
{
  const auto & ends = mmm::TetrahedronEdges[edge];
  const auto & others = mmm::TetrahedronEdges[5 - edge];
  const Vector axis = (p[ends[1]] - p[ends[0]]).normalized();
  const Vector toFirst = p[others[0]] - p[ends[0]];
  const Vector toSecond = p[others[1]] - p[ends[0]];
  const Vector first = (toFirst - toFirst.dot(axis) * axis).normalized();
  const Vector second = (toSecond - toSecond.dot(axis) * axis).normalized();
  // of two unit vectors, by their sum and difference
  return 2.0 * std::atan2((first - second).norm(), (first + second).norm()) * Degrees;
}
} // namespace

TEST(mmmTetrahedronQuality, RegularTetrahedronIsBest)
{
  const auto p = Regular();
  EXPECT_NEAR(RadiusRatio(p), 1.0, 1e-14);
  EXPECT_NEAR(Volume(p), 8.0 / 3.0, 1e-14);
  for (const double angle : Angles(p))
  {
    EXPECT_NEAR(angle, 70.528779365509308, 1e-12);
  }
  EXPECT_NEAR(Cosines(p).largest, 1.0 / 3.0, 1e-14);
  EXPECT_NEAR(Cosines(p).smallest, 1.0 / 3.0, 1e-14);
}

TEST(mmmTetrahedronQuality, CornerTetrahedronHasItsAnglesAtTheRightEdges)
{
  const auto   p = Corner();
  const double slanted = std::acos(1.0 / std::sqrt(3.0)) * Degrees;
  const auto   angles = Angles(p);
  for (int edge = 0; edge < 6; ++edge)
  {
    // the first three edges meet in the corner
    EXPECT_NEAR(angles[edge], edge < 3 ? 90.0 : slanted, 1e-12) << "edge " << edge;
  }
  EXPECT_NEAR(Volume(p), 1.0 / 6.0, 1e-15);
  EXPECT_NEAR(RadiusRatio(p), std::sqrt(3.0) - 1.0, 1e-14);
}

TEST(mmmTetrahedronQuality, SliversKeepTheirRelativeAccuracy)
{
  for (const double h : { 1e-12, 1e-9, 1e-4, 0.1, std::sqrt(0.5) })
  {
    const auto   p = Crossed(h);
    const double crossing = 2.0 * std::atan(0.5 / h);
    const double side = std::atan(std::sqrt(8.0 * h * h + 16.0 * h * h * h * h));
    const auto   angles = Angles(p);
    EXPECT_NEAR(angles[0], crossing * Degrees, 1e-12) << h;
    EXPECT_NEAR(angles[5], crossing * Degrees, 1e-12) << h;
    for (int edge = 1; edge < 5; ++edge)
    {
      EXPECT_NEAR(angles[edge] / (side * Degrees), 1.0, 1e-12) << h;
    }
  }
}

TEST(mmmTetrahedronQuality, FlatTetrahedronHasAnglesOf0And180)
{
  const auto p = Crossed(0.0);
  EXPECT_EQ(Volume(p), 0.0);
  EXPECT_EQ(RadiusRatio(p), 0.0);
  EXPECT_EQ(Cosines(p).largest, 1.0);
  EXPECT_EQ(Cosines(p).smallest, -1.0);
  const auto angles = Angles(p);
  for (int edge = 0; edge < 6; ++edge)
  {
    EXPECT_EQ(angles[edge], edge == 0 || edge == 5 ? 180.0 : 0.0) << "edge " << edge;
  }
}

TEST(mmmTetrahedronQuality, CoincidentPointsAreTheWorstCaseAndNoSpecialOne)
{
  auto p = Regular();
  for (int collapsed = 1; collapsed < 4; ++collapsed)
  {
    p[collapsed] = p[0];
    EXPECT_EQ(Volume(p), 0.0);
    EXPECT_EQ(RadiusRatio(p), 0.0);
    EXPECT_EQ(Cosines(p).largest, 1.0);
    EXPECT_EQ(Cosines(p).smallest, -1.0);
    for (const double angle : Angles(p))
    {
      EXPECT_TRUE(angle >= 0.0 && angle <= 180.0);
    }
  }
}

TEST(mmmTetrahedronQuality, OrientationIsTheSignOfTheVolumeOnly)
{
  for (const auto & p : RandomTetrahedra(100))
  {
    const Points turned{ { p[1], p[0], p[2], p[3] } };
    EXPECT_NEAR(Volume(turned), -Volume(p), 1e-14);
    EXPECT_NEAR(RadiusRatio(turned), RadiusRatio(p), 1e-12);
    EXPECT_NEAR(Cosines(turned).largest, Cosines(p).largest, 1e-12);
    EXPECT_NEAR(Cosines(turned).smallest, Cosines(p).smallest, 1e-12);
    EXPECT_NEAR(Angles(turned)[0], Angles(p)[0], 1e-10);
  }
}

TEST(mmmTetrahedronQuality, AnglesAreThoseSeenAlongTheEdges)
{
  for (const auto & p : RandomTetrahedra(1000))
  {
    const auto angles = Angles(p);
    for (int edge = 0; edge < 6; ++edge)
    {
      EXPECT_NEAR(angles[edge], AngleSeenAlongEdge(p, edge), 1e-9);
    }
  }
}

TEST(mmmTetrahedronQuality, CosinesAgreeWithTheAngles)
{
  for (const auto & p : RandomTetrahedra(1000))
  {
    const auto   angles = Angles(p);
    const double smallest = *std::min_element(angles.begin(), angles.end());
    const double largest = *std::max_element(angles.begin(), angles.end());
    EXPECT_NEAR(Cosines(p).largest, std::cos(smallest / Degrees), 1e-13);
    EXPECT_NEAR(Cosines(p).smallest, std::cos(largest / Degrees), 1e-13);
  }
}

TEST(mmmTetrahedronQuality, RadiusRatioIsThatOfTheSpheres)
{
  for (const auto & p : RandomTetrahedra(1000))
  {
    Eigen::Matrix3d edges;
    Vector          halves;
    double          area = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      edges.row(i) = p[i + 1] - p[0];
      halves[i] = 0.5 * edges.row(i).squaredNorm();
    }
    for (const auto & face : mmm::TetrahedronFaces)
    {
      area += 0.5 * (p[face[1]] - p[face[0]]).cross(p[face[2]] - p[face[0]]).norm();
    }
    const double circumscribed = edges.partialPivLu().solve(halves).norm();
    const double inscribed = 3.0 * std::abs(Volume(p)) / area;
    EXPECT_NEAR(RadiusRatio(p), 3.0 * inscribed / circumscribed, 1e-11);
    EXPECT_LE(RadiusRatio(p), 1.0 + 1e-14);
  }
}

TEST(mmmTetrahedronQuality, RadiusRatiosOfEightAreThoseOfOneToTheLastBit)
{
  std::mt19937                           random(1);
  std::uniform_real_distribution<double> coordinate(-2.0, 2.0);
  for (int trial = 0; trial < 1000; ++trial)
  {
    std::array<Points, mmm::EightTetrahedra::Count> shapes;
    mmm::EightTetrahedra                            eight;
    for (int t = 0; t < mmm::EightTetrahedra::Count; ++t)
    {
      for (int c = 0; c < 4; ++c)
      {
        shapes[t][c] = Vector(coordinate(random), coordinate(random), coordinate(random));
        // one is flat, one has no extent
        shapes[t][c][2] *= t == 6 ? 0.0 : 1.0;
        shapes[t][c] *= t == 7 ? 0.0 : 1.0;
        eight.SetCorner(t, c, shapes[t][c]);
      }
    }
    const auto ratios = mmm::TetrahedronRadiusRatios(eight);
    for (int t = 0; t < mmm::EightTetrahedra::Count; ++t)
    {
      EXPECT_EQ(ratios[t], RadiusRatio(shapes[t]));
    }
  }
}

TEST(mmmTetrahedronQuality, ShapeIsInvariantUnderSimilarities)
{
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(0.7, Vector(1, -2, 3).normalized()).toRotationMatrix();
  for (const double scale : { 1e-6, 25.4, 1e6 })
  {
    for (const auto & p : RandomTetrahedra(100))
    {
      Points moved;
      for (int i = 0; i < 4; ++i)
      {
        moved[i] = scale * (rotation * p[i] + Vector(3, 1, -2));
      }
      EXPECT_NEAR(Volume(moved) / (scale * scale * scale), Volume(p), 1e-13);
      EXPECT_NEAR(RadiusRatio(moved), RadiusRatio(p), 1e-11);
      EXPECT_NEAR(Cosines(moved).largest, Cosines(p).largest, 1e-11);
      EXPECT_NEAR(Cosines(moved).smallest, Cosines(p).smallest, 1e-11);
      EXPECT_NEAR(
        mmm::TriangleRadiusRatio(moved[0], moved[1], moved[2]), mmm::TriangleRadiusRatio(p[0], p[1], p[2]), 1e-12);
    }
  }
}

TEST(mmmTetrahedronQuality, FacesOfAPositiveTetrahedronPointOutward)
{
  const auto p = Corner();
  ASSERT_GT(Volume(p), 0.0);
  for (int opposite = 0; opposite < 4; ++opposite)
  {
    const auto & face = mmm::TetrahedronFaces[opposite];
    const Vector normal = (p[face[1]] - p[face[0]]).cross(p[face[2]] - p[face[0]]);
    EXPECT_LT(normal.dot(p[opposite] - p[face[0]]), 0.0) << "face " << opposite;
  }
}

TEST(mmmTetrahedronQuality, TriangleRadiusRatios)
{
  const Vector a(0, 0, 5);
  const Vector b(2, 0, 5);
  EXPECT_NEAR(mmm::TriangleRadiusRatio(a, b, Vector(1, std::sqrt(3.0), 5)), 1.0, 1e-14);
  EXPECT_NEAR(mmm::TriangleRadiusRatio(a, b, Vector(0, 2, 5)), 2.0 * (std::sqrt(2.0) - 1.0), 1e-14);
  EXPECT_EQ(mmm::TriangleRadiusRatio(a, b, Vector(7, 0, 5)), 0.0);
  EXPECT_EQ(mmm::TriangleRadiusRatio(a, b, b), 0.0);
  EXPECT_EQ(mmm::TriangleRadiusRatio(a, a, a), 0.0);
}

TEST(mmmTetrahedronQuality, GradientsAreThoseOfTheRadiusRatios)
{
  std::mt19937                           random(7);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  for (int trial = 0; trial < 100; ++trial)
  {
    Points p;
    for (Vector & x : p)
    {
      x = Vector(coordinate(random), coordinate(random), coordinate(random));
    }
    const Vector     ofTetrahedron = mmm::TetrahedronRadiusRatioGradient(p[0], p[1], p[2], p[3]);
    const Vector     ofTriangle = mmm::TriangleRadiusRatioGradient(p[0], p[1], p[2]);
    constexpr double Step = 1e-6;
    for (int a = 0; a < 3; ++a)
    {
      const Vector before = p[0] - Step * Vector::Unit(a);
      const Vector after = p[0] + Step * Vector::Unit(a);
      EXPECT_NEAR(
        ofTetrahedron[a],
        (mmm::TetrahedronRadiusRatio(after, p[1], p[2], p[3]) - mmm::TetrahedronRadiusRatio(before, p[1], p[2], p[3])) /
          (2.0 * Step),
        1e-5 * (1.0 + ofTetrahedron.norm()));
      EXPECT_NEAR(ofTriangle[a],
                  (mmm::TriangleRadiusRatio(after, p[1], p[2]) - mmm::TriangleRadiusRatio(before, p[1], p[2])) /
                    (2.0 * Step),
                  1e-5 * (1.0 + ofTriangle.norm()));
    }
  }
}

TEST(mmmTetrahedronQuality, GradientsOfFlatShapesAreZero)
{
  const Vector a(0, 0, 5);
  const Vector b(2, 0, 5);
  EXPECT_EQ(mmm::TriangleRadiusRatioGradient(a, b, Vector(7, 0, 5)), Vector::Zero());
  EXPECT_EQ(mmm::TriangleRadiusRatioGradient(a, a, b), Vector::Zero());
  EXPECT_EQ(mmm::TetrahedronRadiusRatioGradient(a, b, Vector(1, 1, 5), Vector(1, 2, 5)), Vector::Zero());
  EXPECT_EQ(mmm::TetrahedronRadiusRatioGradient(a, a, a, a), Vector::Zero());
}
