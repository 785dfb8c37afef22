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
#include "pipeline/Mesher.h"
#include "support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using mmm::MaterialList;
using mmm::Vector;
using mmmtest::MakeMaterials;
using mmmtest::Scene;

namespace
{
constexpr double Radius = 9.0;
const Vector     Centre(13.2, 12.9, 13.1);

/** A ball in exterior whose part above a plane is material 1; a second plane cuts what is below, into 2 and 3. */
const Scene &
QuarterCutBall()
{
  static const Scene scene(MakeMaterials({ { 27, 27, 27 } }, Vector::Ones(), 4, [](const Vector & x) {
    const Vector d = x - Centre;
    return d.norm() > Radius ? 0 : (d[2] > 0.2 ? 1 : (d[0] > 0.1 ? 2 : 3));
  }));
  return scene;
}

/** A ball of two halves in exterior. */
const Scene &
HalvedBall()
{
  static const Scene scene(MakeMaterials({ { 27, 27, 27 } }, Vector::Ones(), 3, [](const Vector & x) {
    const Vector d = x - Centre;
    return d.norm() > Radius ? 0 : (d[2] < 0.2 ? 1 : 2);
  }));
  return scene;
}

/** Exterior above, material 1 below, which five faces of the image cut. */
const Scene &
Slab()
{
  static const Scene scene(
    MakeMaterials({ { 14, 14, 14 } }, Vector::Ones(), 2, [](const Vector & x) { return x[2] < 6.8; }));
  return scene;
}

mmm::MeshingResult
Build(const Scene & scene, int exterior, bool surfaceOnly = false)
{
  mmm::Monitor           monitor;
  mmm::MeshingParameters parameters;
  parameters.exterior = exterior;
  parameters.surfaceOnly = surfaceOnly;
  const auto         sizes = mmm::ComputeSizing(*scene.indicators, exterior, {}, {}, monitor);
  mmm::MeshingResult result;
  mmm::BuildMesh(*scene.indicators, mmm::SizingField(scene.image.grid, sizes.data()), parameters, monitor, result);
  return result;
}

double
LengthOf(const mmm::JunctionCurve & curve, const mmm::MeshingResult & result)
{
  double length = 0.0;
  for (std::size_t p = 1; p < curve.points.size(); ++p)
  {
    length += (result.points[curve.points[p]] - result.points[curve.points[p - 1]]).norm();
  }
  return length;
}

/** The curves' lengths by their materials. */
std::map<MaterialList, double>
LengthsOf(const mmm::MeshingResult & result)
{
  std::map<MaterialList, double> lengths;
  for (const auto & curve : result.junctions.curves)
  {
    lengths[curve.materials] += LengthOf(curve, result);
  }
  return lengths;
}
} // namespace

TEST(Junctions, TwoHalvesMeetTheirOutsideInACircle)
{
  const auto result = Build(HalvedBall(), 0);
  ASSERT_EQ(result.junctions.curves.size(), 1u);
  const auto & curve = result.junctions.curves[0];
  EXPECT_EQ(curve.materials, (MaterialList{ 0, 1, 2 }));
  EXPECT_EQ(curve.points.front(), curve.points.back());
  EXPECT_NEAR(LengthOf(curve, result), 2.0 * EIGEN_PI * Radius, 0.05 * 2.0 * EIGEN_PI * Radius);
  EXPECT_TRUE(result.junctions.points.empty());
}

TEST(Junctions, FourMaterialsMeetInPointsWhereFourCurvesEnd)
{
  const auto result = Build(QuarterCutBall(), 0);
  ASSERT_EQ(result.junctions.points.size(), 2u);
  for (const auto & junction : result.junctions.points)
  {
    EXPECT_EQ(junction.materials, (MaterialList{ 0, 1, 2, 3 }));
    const Vector d = result.points[junction.point] - Centre;
    EXPECT_NEAR(std::abs(d[1]), Radius, 1.0);
    EXPECT_NEAR(std::hypot(d[0], d[2]), 0.0, 1.0);
  }
  EXPECT_EQ(result.junctions.curves.size(), 4u);
  const auto lengths = LengthsOf(result);
  ASSERT_EQ(lengths.size(), 4u);
  const double arc = EIGEN_PI * Radius;
  for (const auto & materials : { MaterialList{ 0, 1, 2 }, MaterialList{ 0, 1, 3 }, MaterialList{ 0, 2, 3 } })
  {
    EXPECT_NEAR(lengths.at(materials), arc, 0.06 * arc);
  }
  EXPECT_NEAR(lengths.at({ 1, 2, 3 }), 2.0 * Radius, 0.06 * 2.0 * Radius);
}

TEST(Junctions, CurvesEndAtJunctionPoints)
{
  for (const auto * scene : { &QuarterCutBall(), &Slab() })
  {
    const auto             result = Build(*scene, 0);
    std::set<mmm::PointId> ends;
    for (const auto & junction : result.junctions.points)
    {
      ends.insert(junction.point);
    }
    for (const auto & curve : result.junctions.curves)
    {
      EXPECT_TRUE(ends.count(curve.points.front()));
      EXPECT_TRUE(ends.count(curve.points.back()));
      EXPECT_TRUE(std::none_of(
        curve.points.begin() + 1, curve.points.end() - 1, [&](mmm::PointId p) { return ends.count(p) != 0; }));
    }
  }
}

TEST(Junctions, CurvesAreMadeOfTheEdgesOfTheirMaterials)
{
  const auto                                                result = Build(QuarterCutBall(), 0);
  std::map<std::set<mmm::PointId>, std::set<mmm::Material>> around;
  for (std::size_t t = 0; t < result.interfaces.triangles.size(); ++t)
  {
    const auto & corners = result.interfaces.triangles[t];
    for (int c = 0; c < 3; ++c)
    {
      around[{ corners[c], corners[(c + 1) % 3] }].insert(result.interfaces.sides[t].begin(),
                                                          result.interfaces.sides[t].end());
    }
  }
  std::size_t edges = 0;
  for (const auto & curve : result.junctions.curves)
  {
    for (std::size_t p = 1; p < curve.points.size(); ++p)
    {
      const auto & materials = around.at({ curve.points[p - 1], curve.points[p] });
      EXPECT_EQ(MaterialList(materials.begin(), materials.end()), curve.materials);
      ++edges;
    }
  }
  const auto isJunction = [](const auto & edge) { return edge.second.size() > 2; };
  EXPECT_EQ(edges, std::size_t(std::count_if(around.begin(), around.end(), isJunction)));
}

TEST(Junctions, BoxEdgesAndRimsOfCutsAreCurves)
{
  const auto result = Build(Slab(), 0);
  // planes are numbered after the materials: x-, x+, y-, y+, z-, z+
  const auto lengths = LengthsOf(result);
  EXPECT_EQ(lengths.size(), 12u);
  for (const mmm::Material side : { 2, 3, 4, 5 })
  {
    EXPECT_NEAR(lengths.at({ 0, 1, side }), 14.0, 0.1);
    EXPECT_NEAR(lengths.at({ 1, side, 6 }), 14.0, 1e-9);
  }
  for (const mmm::Material x : { 2, 3 })
  {
    for (const mmm::Material y : { 4, 5 })
    {
      EXPECT_NEAR(lengths.at({ 1, x, y }), 7.0, 0.1);
    }
  }
  EXPECT_EQ(result.junctions.curves.size(), 12u);
  EXPECT_EQ(result.junctions.points.size(), 8u);
}

TEST(Junctions, BoxHasItsEdgesWithoutAnExterior)
{
  const auto result = Build(HalvedBall(), -1);
  double     length = 0.0;
  for (const auto & curve : result.junctions.curves)
  {
    length += curve.materials == MaterialList{ 0, 1, 2 } ? 0.0 : LengthOf(curve, result);
  }
  EXPECT_NEAR(length, 12.0 * 27.0, 1e-6);
  EXPECT_EQ(result.junctions.points.size(), 8u);
  EXPECT_EQ(result.junctions.curves.size(), 13u);
}

TEST(Junctions, ABallHasNone)
{
  const auto result = Build(Scene(mmmtest::MakeBallMaterials(20, Vector::Constant(9.6), 6.0)), 0);
  EXPECT_TRUE(result.junctions.curves.empty());
  EXPECT_TRUE(result.junctions.points.empty());
}

TEST(Junctions, SurfaceAloneHasThem)
{
  const auto result = Build(QuarterCutBall(), 0, true);
  EXPECT_TRUE(result.tetrahedra.tetrahedra.empty());
  EXPECT_EQ(result.junctions.points.size(), 2u);
  EXPECT_EQ(result.junctions.curves.size(), 4u);
}
