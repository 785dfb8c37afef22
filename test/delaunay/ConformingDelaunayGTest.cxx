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
#include "delaunay/ConformingDelaunay.h"

#include "base/Hash.h"
#include "delaunay/Enclosure.h"
#include "delaunay/LocalRecovery.h"
#include "delaunay/TetGen.h"
#include "mesh/InterfaceMesh.h"
#include "mesh/TriangleLookup.h"

#include "gtest/gtest.h"

#include <algorithm>
#include <cmath>

using mmm::Vector;

namespace
{
constexpr int Size = 20;

mmm::Grid
MakeGrid()
{
  mmm::Grid grid;
  grid.size = { { Size + 1, Size + 1, Size + 1 } };
  return grid;
}

/** A number between 0 and 1. */
double
Random(std::uint64_t number)
{
  return double(mmm::Hash(number) >> 11) * 0x1p-53;
}

/** Points and triangles of a surface that is part of their Delaunay tetrahedralization, which comes within corners that
 * are far outside. */
struct Surface
{
  explicit Surface(std::vector<Vector> places)
    : points(std::move(places))
  {
    const auto within = mmm::TetrahedralizeWithin(MakeGrid(), points);
    triangles = mmm::ExtractInterfaces({ within, std::vector<mmm::Material>(within.size(), 0) }, 1).triangles;
    const auto corners = mmm::EnclosingCorners(MakeGrid());
    points.insert(points.end(), corners.begin(), corners.end());
    fixed = points.size();
  }

  std::vector<Vector>        points;
  std::vector<mmm::Triangle> triangles;
  std::size_t                fixed;
};

/** A sphere of a radius of 8 around the middle. */
Surface
MakeSphere()
{
  constexpr int       Count = 600;
  std::vector<Vector> points;
  for (int p = 0; p < Count; ++p)
  {
    const double z = 1.0 - (2.0 * p + 1.0) / Count;
    const double turn = 2.399963229728653 * p;
    const double r = std::sqrt(1.0 - z * z);
    points.push_back(Vector::Constant(0.5 * Size) + 8.0 * Vector(r * std::cos(turn), r * std::sin(turn), z));
  }
  return Surface(points);
}

/** The six sides of a cube, with points on a lattice: any four neighbours are on a circle. */
Surface
MakeCube()
{
  std::vector<Vector> points;
  for (int k = 0; k <= 8; ++k)
  {
    for (int j = 0; j <= 8; ++j)
    {
      for (int i = 0; i <= 8; ++i)
      {
        if (i % 8 == 0 || j % 8 == 0 || k % 8 == 0)
        {
          points.push_back(Vector(6.0 + i, 6.0 + j, 6.0 + k));
        }
      }
    }
  }
  return Surface(points);
}

/** Random points in the ball of that radius around the middle. */
void
AddRandomPoints(int count, double radius, std::vector<Vector> & points)
{
  for (std::uint64_t n = 0; count > 0; ++n)
  {
    const Vector x =
      2.0 * radius * (Vector(Random(3 * n), Random(3 * n + 1), Random(3 * n + 2)) - Vector::Constant(0.5));
    if (x.norm() < radius)
    {
      points.push_back(Vector::Constant(0.5 * Size) + x);
      --count;
    }
  }
}

bool
HaveAll(const std::vector<mmm::Tetrahedron> & tetrahedra, const std::vector<mmm::Triangle> & triangles)
{
  const mmm::TriangleLookup lookup(triangles);
  std::vector<char>         isFound(triangles.size(), 0);
  for (const auto & t : tetrahedra)
  {
    for (int f = 0; f < 4; ++f)
    {
      const auto found = lookup.Find(mmm::FaceOf(t, f));
      if (found != mmm::TriangleLookup::None)
      {
        isFound[found] = 1;
      }
    }
  }
  return std::count(isFound.begin(), isFound.end(), 0) == 0;
}

/** The sum of volumes, or not a number where one is negative. */
double
VolumeOf(const std::vector<mmm::Tetrahedron> & tetrahedra, const std::vector<Vector> & points)
{
  double volume = 0.0;
  for (const auto & t : tetrahedra)
  {
    const double own = mmm::TetrahedronVolume(points[t[0]], points[t[1]], points[t[2]], points[t[3]]);
    volume += own >= -1e-12 ? own : std::nan("");
  }
  return volume;
}

/** Of the cube between the corners that are far outside. */
double
VolumeOfEnclosure()
{
  const auto corners = mmm::EnclosingCorners(MakeGrid());
  return std::pow(corners[1][0] - corners[0][0], 3);
}
} // namespace

TEST(ConformingTetrahedralization, HasAllTrianglesAmongPointsThatAreEverywhere)
{
  Surface surface = MakeSphere();
  AddRandomPoints(2000, 7.9, surface.points);
  std::vector<mmm::Tetrahedron> tetrahedra;
  const auto                    leftOut =
    mmm::ConformingTetrahedralization(MakeGrid(), surface.fixed, surface.triangles, surface.points, tetrahedra);
  EXPECT_TRUE(HaveAll(tetrahedra, surface.triangles));
  EXPECT_GT(leftOut, 0u);
  EXPECT_LT(leftOut, 200u);
  EXPECT_NEAR(VolumeOf(tetrahedra, surface.points) / VolumeOfEnclosure(), 1.0, 1e-9);
}

TEST(ConformingTetrahedralization, LeavesNoPointOutThatIsInNoWay)
{
  Surface surface = MakeSphere();
  AddRandomPoints(200, 5.0, surface.points);
  std::vector<mmm::Tetrahedron> tetrahedra;
  EXPECT_EQ(mmm::ConformingTetrahedralization(MakeGrid(), surface.fixed, surface.triangles, surface.points, tetrahedra),
            0u);
}

TEST(ConformingTetrahedralization, HasTrianglesOfPointsThatAreOnCircles)
{
  Surface surface = MakeCube();
  AddRandomPoints(500, 3.9, surface.points);
  std::vector<mmm::Tetrahedron> tetrahedra;
  mmm::ConformingTetrahedralization(MakeGrid(), surface.fixed, surface.triangles, surface.points, tetrahedra);
  EXPECT_TRUE(HaveAll(tetrahedra, surface.triangles));
  EXPECT_NEAR(VolumeOf(tetrahedra, surface.points) / VolumeOfEnclosure(), 1.0, 1e-9);
}

TEST(LocalRecovery, MakesATriangleThroughAnEdge)
{
  // a flat octahedron, whose axis is an edge of the Delaunay tetrahedra, among many points
  std::vector<Vector> points;
  AddRandomPoints(3000, 9.0, points);
  const Vector middle = Vector::Constant(0.5 * Size);
  points.erase(
    std::remove_if(points.begin(), points.end(), [&](const Vector & x) { return (x - middle).norm() < 3.0; }),
    points.end());
  const auto first = mmm::PointId(points.size());
  for (const double turn : { 0.0, 2.0, 4.0 })
  {
    points.push_back(middle + 2.0 * Vector(std::cos(turn), std::sin(turn), 0.0));
  }
  points.push_back(middle + Vector(0.0, 0.0, 0.2));
  points.push_back(middle - Vector(0.0, 0.0, 0.2));
  auto                             tetrahedra = mmm::DelaunayTetrahedralization(points);
  const double                     volume = VolumeOf(tetrahedra, points);
  const std::size_t                count = tetrahedra.size();
  const std::vector<mmm::Triangle> triangles{ { { first, first + 1, first + 2 } } };
  ASSERT_FALSE(HaveAll(tetrahedra, triangles));
  mmm::RecoverLocally(triangles, { 1 }, points, tetrahedra);
  EXPECT_TRUE(HaveAll(tetrahedra, triangles));
  EXPECT_NEAR(VolumeOf(tetrahedra, points) / volume, 1.0, 1e-9);
  EXPECT_NEAR(double(tetrahedra.size()), double(count), 0.05 * double(count));
}
