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
#include "surface/Sampling.h"
#include "support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

using mmm::Vector;
using mmmtest::MakeMaterials;
using mmmtest::Scene;

namespace
{
/** A square of two triangles in a scene whose materials 0 and 1 meet in the plane z = 5, where h is 2. */
struct Square
{
  Scene scene{ MakeMaterials({ { 12, 12, 12 } }, Vector::Ones(), 2, [](const Vector & x) { return x[2] < 5.0; }) };
  std::vector<float>  sizes = std::vector<float>(scene.image.grid.NumberOfNodes(), 2.0f);
  std::vector<Vector> points{ { 4, 4, 4.5 }, { 6, 4, 4.5 }, { 6, 6, 4.5 }, { 4, 6, 4.5 } };
  mmm::InterfaceMesh  interfaces;
  mmm::ParticleSet    particles;

  Square()
  {
    interfaces.triangles = { { { 0, 1, 2 } }, { { 0, 2, 3 } } };
    interfaces.sides = { { { 0, 1 } }, { { 0, 1 } } };
    particles.positions = points;
    particles.cells = { 0, 0, 0, 0 };
    particles.cellTable = { mmm::Cell{ 0, 1 } };
  }

  mmm::SamplingReport
  Measure() const
  {
    return mmm::MeasureSampling(mmm::SizingField(scene.image.grid, sizes.data()), interfaces, points);
  }
};

/** A ball of two halves, meshed. */
mmm::MeshingResult
MeshHalves(bool surfaceOnly)
{
  const Scene            scene(MakeMaterials({ { 27, 27, 27 } }, Vector::Ones(), 3, [](const Vector & x) {
    const Vector d = x - Vector(13.2, 12.9, 13.1);
    return d.norm() > 9.0 ? 0 : (d[2] < 0.2 ? 1 : 2);
  }));
  mmm::Monitor           monitor;
  mmm::MeshingParameters parameters;
  parameters.exterior = 0;
  parameters.surfaceOnly = surfaceOnly;
  const auto         sizes = mmm::ComputeSizing(*scene.indicators, 0, {}, {}, monitor);
  mmm::MeshingResult result;
  mmm::BuildMesh(*scene.indicators, mmm::SizingField(scene.image.grid, sizes.data()), parameters, monitor, result);
  return result;
}
} // namespace

TEST(Sampling, EdgesAreCountedOnceInUnitsOfTheirSize)
{
  const auto report = Square().Measure();
  // four sides of 2 and a diagonal
  EXPECT_NEAR(report.percentile1Spacing, 1.0, 1e-6);
  EXPECT_NEAR(report.medianSpacing, 1.0, 1e-6);
  EXPECT_NEAR(report.nearShare, 1.0, 1e-9);
  Square fine;
  std::fill(fine.sizes.begin(), fine.sizes.end(), 1.5f);
  EXPECT_NEAR(fine.Measure().medianSpacing, 4.0 / 3.0, 1e-6);
  EXPECT_NEAR(fine.Measure().nearShare, 0.8, 1e-9);
}

TEST(Sampling, ResidualIsTheDistanceToTheCell)
{
  Square     square;
  const auto before = mmm::MeasureResiduals(*square.scene.indicators, square.particles);
  EXPECT_LT(before[2].maximum, 1e-6);
  EXPECT_EQ(before[2].leftShare, 0.0);
  square.particles.positions[1][2] += 0.125;
  const auto after = mmm::MeasureResiduals(*square.scene.indicators, square.particles);
  EXPECT_NEAR(after[2].maximum, 0.125, 1e-6);
  EXPECT_NEAR(after[2].leftShare, 0.25, 1e-9);
  EXPECT_EQ(after[1].maximum, 0.0);
}

TEST(Sampling, OfAMeshIsNearWhatWasAskedFor)
{
  for (const bool surfaceOnly : { false, true })
  {
    const auto report = MeshHalves(surfaceOnly).report;
    EXPECT_NEAR(report.sampling.medianSpacing, 1.0, 0.1);
    EXPECT_GT(report.sampling.nearShare, 0.97);
    for (int dimension = 1; dimension <= 2; ++dimension)
    {
      EXPECT_LT(report.residualsOfParticles[dimension].maximum, mmm::ResidualReport::Largest);
      EXPECT_LT(report.residualsAfterOptimization[dimension].percentile99, mmm::ResidualReport::Largest);
    }
  }
}

TEST(SurfaceAlone, HasNoHolesWhereItIsNearlyFlat)
{
  const Scene            scene(MakeMaterials({ { 72, 72, 24 } }, Vector::Ones(), 2, [](const Vector & x) {
    return x[2] < 12.0 + 1.7 * std::sin(x[0] / 6.0) + 1.2 * std::cos(x[1] / 8.0 + x[0] / 15.0);
  }));
  mmm::Monitor           monitor;
  mmm::MeshingParameters parameters;
  parameters.exterior = 0;
  parameters.surfaceOnly = true;
  const auto             sizes = mmm::ComputeSizing(*scene.indicators, 0, {}, {}, monitor);
  const mmm::SizingField sizing(scene.image.grid, sizes.data());
  mmm::MeshingResult     result;
  mmm::BuildMesh(*scene.indicators, sizing, parameters, monitor, result);
  double longest = 0.0;
  for (const auto & t : result.interfaces.triangles)
  {
    for (int c = 0; c < 3; ++c)
    {
      const Vector & a = result.points[t[c]];
      const Vector & b = result.points[t[(c + 1) % 3]];
      longest = std::max(longest, (a - b).norm() / sizing(0.5 * (a + b)));
    }
  }
  // 1.84; where the indicators decide on flat tetrahedra it is 2.40
  EXPECT_LT(longest, 2.2);
}

TEST(SurfaceAlone, IsMadeOfGoodTriangles)
{
  const auto result = MeshHalves(true);
  EXPECT_TRUE(result.tetrahedra.tetrahedra.empty());
  double average = 0.0;
  for (const auto & t : result.interfaces.triangles)
  {
    const double ratio = mmm::TriangleRadiusRatio(result.points[t[0]], result.points[t[1]], result.points[t[2]]);
    EXPECT_GT(ratio, 0.3);
    average += ratio / double(result.interfaces.triangles.size());
  }
  EXPECT_GT(average, 0.93);
}

TEST(SurfaceAlone, EnclosesTheVolumes)
{
  const auto                      result = MeshHalves(true);
  std::map<mmm::Material, double> volumes;
  for (std::size_t t = 0; t < result.interfaces.triangles.size(); ++t)
  {
    const auto & c = result.interfaces.triangles[t];
    // the normal points to the second side, out of the first
    const double volume = result.points[c[0]].dot(result.points[c[1]].cross(result.points[c[2]])) / 6.0;
    volumes[result.interfaces.sides[t][0]] += volume;
    volumes[result.interfaces.sides[t][1]] -= volume;
  }
  const double exact = 4.0 / 3.0 * EIGEN_PI * 729.0;
  EXPECT_NEAR(volumes.at(1) + volumes.at(2), exact, 0.02 * exact);
  EXPECT_NEAR(volumes.at(0), -exact, 0.02 * exact);
}

TEST(SurfaceAlone, IsClosedAndHasNoOtherPoints)
{
  const auto                                 result = MeshHalves(true);
  std::map<std::array<mmm::PointId, 2>, int> edges;
  std::vector<char>                          used(result.points.size(), 0);
  for (const auto & triangle : result.interfaces.triangles)
  {
    for (int c = 0; c < 3; ++c)
    {
      const auto ends = std::minmax(triangle[c], triangle[(c + 1) % 3]);
      ++edges[{ { ends.first, ends.second } }];
      used[triangle[c]] = 1;
    }
  }
  for (const auto & edge : edges)
  {
    EXPECT_TRUE(edge.second == 2 || edge.second == 3);
  }
  EXPECT_EQ(std::count(used.begin(), used.end(), 0), 0);
  EXPECT_EQ(result.numberOfSurfacePoints, result.points.size());
}
