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
#include "surface/SurfaceConnectivity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
using mmm::PointId;
using mmm::Triangle;
using mmm::Vector;

constexpr int Columns = 7;
constexpr int Rows = 7;

/** A flat patch of equilateral triangles. */
struct Patch
{
  std::vector<Vector> points;
  mmm::InterfaceMesh  interfaces;

  Patch()
  {
    for (int row = 0; row < Rows; ++row)
    {
      for (int column = 0; column < Columns; ++column)
      {
        points.push_back(Vector(column + 0.5 * row, 0.5 * std::sqrt(3.0) * row, 0.0));
      }
    }
    for (int row = 0; row + 1 < Rows; ++row)
    {
      for (int column = 0; column + 1 < Columns; ++column)
      {
        const PointId first = At(column, row);
        const PointId above = At(column, row + 1);
        this->Add({ { first, first + 1, above } });
        this->Add({ { first + 1, above + 1, above } });
      }
    }
  }
  static PointId
  At(int column, int row)
  {
    return PointId(row * Columns + column);
  }
  void
  Add(const Triangle & triangle)
  {
    interfaces.triangles.push_back(triangle);
    interfaces.sides.push_back({ { 0, 1 } });
  }
  /** Replaces the triangles abc and bdc by abd and adc. */
  void
  Flip(PointId a, PointId b, PointId c, PointId d)
  {
    const Triangle old[] = { { { a, b, c } }, { { b, d, c } } };
    const Triangle fresh[] = { { { a, b, d } }, { { a, d, c } } };
    for (int n = 0; n < 2; ++n)
    {
      const auto found = std::find(interfaces.triangles.begin(), interfaces.triangles.end(), old[n]);
      ASSERT_NE(found, interfaces.triangles.end());
      *found = fresh[n];
    }
  }
  /** The flip around the patch's middle. */
  void
  FlipInTheMiddle()
  {
    this->Flip(At(3, 2), At(4, 2), At(3, 3), At(4, 3));
  }
};

/** The triangles as sorted sets of corners, in order. */
std::vector<Triangle>
SortedTriangles(std::vector<Triangle> triangles)
{
  for (auto & triangle : triangles)
  {
    std::sort(triangle.begin(), triangle.end());
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}
} // namespace

TEST(SurfaceConnectivity, LeavesARegularSurfaceAlone)
{
  const Patch              patch;
  mmm::SurfaceConnectivity connectivity(patch.interfaces, patch.points);
  EXPECT_EQ(connectivity.EqualizeValences(patch.points), 0u);
  EXPECT_EQ(connectivity.Triangles(), patch.interfaces.triangles);
}

TEST(SurfaceConnectivity, FlipsBackAnEdgeThatMakesPointsOfFiveAndSevenTriangles)
{
  const Patch regular;
  Patch       patch;
  patch.FlipInTheMiddle();
  mmm::SurfaceConnectivity connectivity(patch.interfaces, patch.points);
  EXPECT_EQ(connectivity.EqualizeValences(patch.points), 1u);
  EXPECT_EQ(SortedTriangles(connectivity.Triangles()), SortedTriangles(regular.interfaces.triangles));
}

TEST(SurfaceConnectivity, KeepsTheAreaAndTheOrientationOfAFlatPatch)
{
  Patch patch;
  patch.FlipInTheMiddle();
  mmm::SurfaceConnectivity connectivity(patch.interfaces, patch.points);
  connectivity.EqualizeValences(patch.points);
  double area = 0.0;
  for (const auto & t : connectivity.Triangles())
  {
    const Vector normal = (patch.points[t[1]] - patch.points[t[0]]).cross(patch.points[t[2]] - patch.points[t[0]]);
    EXPECT_GT(normal[2], 0.0);
    area += 0.5 * normal[2];
  }
  EXPECT_NEAR(area, (Rows - 1) * (Columns - 1) * 0.5 * std::sqrt(3.0), 1e-12);
}

TEST(SurfaceConnectivity, DoesNotFlipEdgesBetweenSheets)
{
  Patch patch;
  patch.FlipInTheMiddle();
  // the flipped edge becomes a junction: one of its triangles belongs to another sheet
  const Triangle one{ { Patch::At(3, 2), Patch::At(4, 2), Patch::At(4, 3) } };
  const auto     found = std::find(patch.interfaces.triangles.begin(), patch.interfaces.triangles.end(), one);
  ASSERT_NE(found, patch.interfaces.triangles.end());
  patch.interfaces.sides[found - patch.interfaces.triangles.begin()] = { { 0, 2 } };
  mmm::SurfaceConnectivity connectivity(patch.interfaces, patch.points);
  connectivity.EqualizeValences(patch.points);
  const auto triangles = SortedTriangles(connectivity.Triangles());
  EXPECT_TRUE(std::binary_search(triangles.begin(), triangles.end(), one));
}
