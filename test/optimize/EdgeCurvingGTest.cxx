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
#include "optimize/EdgeCurving.h"

#include "mesh/QuadraticTetrahedron.h"
#include "optimize/OptimizationParameters.h"
#include "pipeline/Mesher.h"
#include "support/TestMeasures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

using mmm::CurvedEdge;
using mmm::PointId;
using mmm::Vector;
using mmmtest::MakeMaterials;
using mmmtest::Scene;

namespace
{
using Ends = std::array<PointId, 2>;

mmm::MeshingResult
Mesh(const Scene & scene, int exterior = 0, bool surfaceOnly = false, const mmm::SizingParameters & sizing = {})
{
  mmm::MeshingResult     result;
  mmm::Monitor           monitor;
  mmm::MeshingParameters parameters;
  parameters.exterior = exterior;
  parameters.secondOrder = true;
  parameters.surfaceOnly = surfaceOnly;
  const auto sizes = mmm::ComputeSizing(*scene.indicators, exterior, sizing, {}, monitor);
  mmm::BuildMesh(*scene.indicators, mmm::SizingField(scene.image.grid, sizes.data()), parameters, monitor, result);
  return result;
}

/** Two halves of a ball, which the box cuts on one side: surfaces, a curve where three materials meet, and flat faces.
 */
Scene
MakeCutHalves()
{
  return Scene(MakeMaterials({ { 25, 25, 17 } }, Vector::Ones(), 3, [](const Vector & x) {
    const Vector d = x - Vector(12.2, 11.9, 7.1);
    return d.norm() > 9.3 ? 0 : (d[0] < 0.2 ? 1 : 2);
  }));
}

std::map<Ends, Vector>
MiddlesOf(const mmm::CurvedEdges & edges)
{
  std::map<Ends, Vector> middles;
  for (const CurvedEdge & edge : edges)
  {
    middles[edge.ends] = edge.middle;
  }
  return middles;
}

Ends
Sorted(PointId a, PointId b)
{
  return { { std::min(a, b), std::max(a, b) } };
}

/** The nodes of all tetrahedra. */
std::vector<mmm::QuadraticTetrahedron>
NodesOf(const mmm::MeshingResult & result)
{
  const auto                             middles = MiddlesOf(result.curvedEdges);
  std::vector<mmm::QuadraticTetrahedron> all;
  for (const auto & t : result.tetrahedra.tetrahedra)
  {
    mmm::QuadraticTetrahedron nodes;
    for (int c = 0; c < 4; ++c)
    {
      nodes[c] = result.points[t[c]];
    }
    for (int e = 0; e < 6; ++e)
    {
      const Ends ends = Sorted(t[mmm::TetrahedronEdges[e][0]], t[mmm::TetrahedronEdges[e][1]]);
      const auto found = middles.find(ends);
      nodes[4 + e] =
        found == middles.end() ? Vector(0.5 * (result.points[ends[0]] + result.points[ends[1]])) : found->second;
    }
    all.push_back(nodes);
  }
  return all;
}
} // namespace

TEST(EdgeCurving, CurvedBallHasTheVolumeOfItsIndicator)
{
  const mmmtest::Ellipsoid ball(Vector(13.2, 12.9, 13.1), Eigen::Matrix3d::Identity(), Vector::Constant(9.0));
  const Scene              scene(mmmtest::Digitize(ball, 27));
  mmm::SizingParameters    sizing;
  sizing.chordTolerance = 0.04;
  const auto   result = Mesh(scene, 0, false, sizing);
  const double exact = ball.Volume() * (1.0 + mmmtest::MeasureSurface(*scene.indicators, ball, 20000).volume);
  double       straight = 0.0;
  double       curved = 0.0;
  for (const auto & nodes : NodesOf(result))
  {
    straight += mmm::TetrahedronVolume(nodes[0], nodes[1], nodes[2], nodes[3]);
    curved += mmm::QuadraticVolume(nodes);
  }
  EXPECT_NEAR(curved, exact, 1e-4 * exact);
  EXPECT_LT(straight, (1.0 - 5e-3) * exact);
  EXPECT_NEAR(result.report.curving.volumes.at(1), curved, 1e-9 * exact);
  EXPECT_EQ(result.report.curving.withoutPlace + result.report.curving.inverting, 0u);
  EXPECT_EQ(result.report.curving.edges, result.curvedEdges.size());
}

TEST(EdgeCurving, MidNodesLieOnTheInterfacesOfAllTrianglesBesideThem)
{
  const Scene scene = MakeCutHalves();
  const auto  result = Mesh(scene);
  const auto  middles = MiddlesOf(result.curvedEdges);
  std::size_t onSurfaces = 0;
  for (std::size_t t = 0; t < result.interfaces.triangles.size(); ++t)
  {
    const auto & triangle = result.interfaces.triangles[t];
    const auto & sides = result.interfaces.sides[t];
    for (int c = 0; c < 3; ++c)
    {
      const auto found = middles.find(Sorted(triangle[c], triangle[(c + 1) % 3]));
      const bool isCut = std::all_of(triangle.begin(), triangle.end(), [&](PointId p) {
        return result.points[p][2] == scene.image.grid.LowerFace(2) ||
               result.points[p][2] == scene.image.grid.UpperFace(2);
      });
      if (found != middles.end() && !isCut)
      {
        ++onSurfaces;
        EXPECT_LT(std::abs(scene.indicators->Difference(sides[0], sides[1], found->second)), 1e-6);
      }
    }
  }
  EXPECT_GT(onSurfaces, 1000u);
  // the corners do, too: the edges between them stand for the surface instead of the triangles
  EXPECT_LT(result.report.residualsAfterOptimization[2].leftShare, 0.01);
}

TEST(EdgeCurving, EdgesInFacesOfTheBoxStayThere)
{
  const Scene  scene = MakeCutHalves();
  const auto   result = Mesh(scene);
  const double face = scene.image.grid.LowerFace(2);
  std::size_t  curved = 0;
  for (const CurvedEdge & edge : result.curvedEdges)
  {
    if (result.points[edge.ends[0]][2] == face && result.points[edge.ends[1]][2] == face)
    {
      EXPECT_EQ(edge.middle[2], face);
      ++curved;
    }
  }
  // the rims of the cut, and where the halves meet in it
  EXPECT_GT(curved, 10u);
}

TEST(EdgeCurving, JacobiansArePositiveInLayersOfAVoxel)
{
  const Scene scene(MakeMaterials({ { 24, 24, 20 } }, Vector::Ones(), 3, [](const Vector & x) {
    const double height = x[2] - 9.7 - 3.0 * std::sin(0.6 * x[0]) * std::cos(0.5 * x[1]);
    return std::abs(height) < 1.0 ? 1 : (height < 0.0 ? 0 : 2);
  }));
  const auto  result = Mesh(scene, -1);
  double      smallest = 1.0;
  for (const auto & nodes : NodesOf(result))
  {
    const double straight = 6.0 * mmm::TetrahedronVolume(nodes[0], nodes[1], nodes[2], nodes[3]);
    smallest = std::min(smallest, mmm::SmallestJacobian(nodes) / straight);
  }
  const auto & report = result.report.curving;
  EXPECT_GE(smallest, mmm::EdgeCurvingParameters::LeastJacobian);
  EXPECT_DOUBLE_EQ(report.smallestJacobian, smallest);
  EXPECT_EQ(report.edges, result.curvedEdges.size() + report.withoutPlace + report.inverting);
  EXPECT_GT(result.curvedEdges.size(), 9 * report.edges / 10);
  EXPECT_EQ(result.report.warnings.size(), report.edges == result.curvedEdges.size() ? 0u : 1u);
}

TEST(EdgeCurving, OfTheSurfaceAloneIsOnTheInterfacesAsWell)
{
  const Scene    scene(mmmtest::MakeBallMaterials(21, Vector(10.2, 9.9, 10.1), 6.5));
  const auto     result = Mesh(scene, 0, true);
  std::set<Ends> edges;
  for (const auto & triangle : result.interfaces.triangles)
  {
    for (int c = 0; c < 3; ++c)
    {
      edges.insert(Sorted(triangle[c], triangle[(c + 1) % 3]));
    }
  }
  EXPECT_TRUE(result.tetrahedra.tetrahedra.empty());
  EXPECT_EQ(result.curvedEdges.size(), edges.size());
  for (const CurvedEdge & edge : result.curvedEdges)
  {
    EXPECT_EQ(edges.count(edge.ends), 1u);
    EXPECT_LT(std::abs(scene.indicators->Difference(0, 1, edge.middle)), 1e-6);
  }
}

TEST(EdgeCurving, LeavesOutTheEdgesAloneThatTurnTetrahedraInsideOut)
{
  // two tetrahedra over and under a triangle
  const std::vector<Vector> points{
    Vector(0.0, 0.0, 0.0), Vector(1.0, 0.0, 0.0), Vector(0.0, 1.0, 0.0), Vector(0.2, 0.2, 1.0), Vector(0.2, 0.2, -1.0)
  };
  const std::vector<mmm::Tetrahedron> tetrahedra{ { { 0, 1, 2, 3 } }, { { 0, 2, 1, 4 } } };
  const CurvedEdge                    slight{ { { 0, 1 } }, Vector(0.5, -0.05, 0.0) };
  const CurvedEdge                    inverting{ { { 1, 2 } }, Vector(0.4, 0.4, 0.6) };
  const CurvedEdge                    upper{ { { 0, 3 } }, Vector(0.08, 0.08, 0.5) };
  mmm::CurvedEdges                    edges{ slight, upper, inverting };
  std::sort(edges.begin(), edges.end());
  EXPECT_EQ(mmm::StraightenInvertingEdges(tetrahedra, points, edges), 1u);
  ASSERT_EQ(edges.size(), 2u);
  EXPECT_EQ(edges[0].ends, slight.ends);
  EXPECT_EQ(edges[1].ends, upper.ends);
}
