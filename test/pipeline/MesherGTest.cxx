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
#include "quality/MeshQuality.h"
#include "base/Hash.h"
#include "pipeline/Mesher.h"
#include "support/TestScenes.h"
#include "delaunay/TetGen.h"

#include "itkMacro.h"

#include <gtest/gtest.h>

#include <map>

using mmm::Cell;
using mmm::Vector;
using mmmtest::MakeBallMaterials;
using mmmtest::MakeMaterials;
using mmmtest::Scene;

namespace
{
struct Built
{
  std::vector<float> sizes;
  mmm::MeshingResult result;
};

Built
Build(const Scene & scene, int exterior, mmm::MeshingParameters parameters = {})
{
  Built        built;
  mmm::Monitor monitor;
  parameters.exterior = exterior;
  built.sizes = mmm::ComputeSizing(*scene.indicators, exterior, {}, {}, monitor);
  mmm::BuildMesh(
    *scene.indicators, mmm::SizingField(scene.image.grid, built.sizes.data()), parameters, monitor, built.result);
  return built;
}

std::map<mmm::Material, double>
Volumes(const mmm::MeshingResult & result)
{
  std::map<mmm::Material, double> volumes;
  for (std::size_t t = 0; t < result.tetrahedra.tetrahedra.size(); ++t)
  {
    const auto & c = result.tetrahedra.tetrahedra[t];
    volumes[result.tetrahedra.materials[t]] +=
      mmm::TetrahedronVolume(result.points[c[0]], result.points[c[1]], result.points[c[2]], result.points[c[3]]);
  }
  return volumes;
}

mmm::MeshQualityReport
Quality(const mmm::MeshingResult & result)
{
  const std::vector<int>  labels(result.tetrahedra.materials.begin(), result.tetrahedra.materials.end());
  mmm::MeshQualityOptions options;
  options.computeBettiNumbers = true;
  return mmm::ComputeMeshQuality(result.points, result.tetrahedra.tetrahedra, labels, options);
}

/** A ball of two halves in a box: materials 1 and 2 meet in a disk, and both meet 0 in a circle around it. */
Scene
MakeHalves()
{
  return Scene(MakeMaterials({ { 27, 27, 27 } }, Vector::Ones(), 3, [](const Vector & x) {
    const Vector d = x - Vector(13.2, 12.9, 13.1);
    return d.norm() > 9.0 ? 0 : (d[2] < 0.2 ? 1 : 2);
  }));
}
/** Blobs of three materials with a voxel of another one here and there: parts, layers and junctions of one voxel. */
Scene
MakeNoise()
{
  return Scene(MakeMaterials({ { 22, 21, 20 } }, Vector::Ones(), 4, [](const Vector & x) {
    if (x.minCoeff() < 3.0 || x[0] > 18.0 || x[1] > 17.0 || x[2] > 16.0)
    {
      return 0;
    }
    const auto draw = mmm::Hash(std::uint64_t(x[0] + 32.0 * (x[1] + 32.0 * x[2])));
    const int  blob = int(1.5 + 1.4 * std::sin(0.9 * x[0] + 0.4 * x[2]) * std::sin(0.8 * x[1]));
    return draw % 8 == 0 ? int(draw / 8 % 4) : blob + 1;
  }));
}
} // namespace

TEST(Mesher, FillsABallWithoutSlivers)
{
  const Scene  scene(MakeBallMaterials(27, Vector(13.2, 12.9, 13.1), 9.0));
  const auto   built = Build(scene, 0);
  const auto   quality = Quality(built.result);
  const double exact = 4.0 / 3.0 * EIGEN_PI * 729.0;
  // flat triangles with their corners on the sphere lie inside of it: by the chord tolerance, 0.1 voxel, at most
  EXPECT_NEAR(Volumes(built.result).at(1), exact, 0.06 * exact);
  EXPECT_GT(quality.tetrahedra.smallestAngle.minimum, 10.0);
  EXPECT_LT(quality.tetrahedra.largestAngle, 165.0);
  EXPECT_GT(quality.tetrahedra.radiusRatio.average, 0.7);
  EXPECT_GT(quality.interfaceRadiusRatio.average, 0.89);
  EXPECT_EQ(quality.tetrahedra.nonPositive, 0u);
  EXPECT_EQ(quality.unusedPoints, 0u);
}

TEST(Mesher, SamplesJunctionsOfThreeMaterials)
{
  const Scene  scene = MakeHalves();
  const auto   built = Build(scene, 0);
  const auto   volumes = Volumes(built.result);
  const double exact = 4.0 / 3.0 * EIGEN_PI * 729.0;
  EXPECT_EQ(volumes.size(), 2u);
  EXPECT_NEAR(volumes.at(1) + volumes.at(2), exact, 0.06 * exact);
  // 1-cell particles lie on the circle where all three meet
  std::size_t  onCurve = 0;
  const auto & particles = built.result.particles;
  for (std::size_t p = 0; p < particles.Size(); ++p)
  {
    if (particles.CellOf(p).Dimension() == 1)
    {
      ++onCurve;
      const Vector d = particles.positions[p] - Vector(13.2, 12.9, 13.1);
      EXPECT_NEAR(std::hypot(d[0], d[1]), 9.0, 0.7);
      EXPECT_LT(scene.indicators->CellIndicator(particles.CellOf(p), particles.positions[p]), 1e-3);
    }
  }
  EXPECT_GT(onCurve, 15u);
}

TEST(Mesher, ParticlesLieOnTheirCellsToAHundredthOfAVoxel)
{
  const Scene  scene = MakeHalves();
  const auto   built = Build(scene, 0);
  const auto & particles = built.result.particles;
  for (std::size_t p = 0; p < particles.Size(); ++p)
  {
    Vector x = particles.positions[p];
    ASSERT_TRUE(scene.indicators->Project(particles.CellOf(p), x, 1.0));
    EXPECT_LT((x - particles.positions[p]).norm(), 0.01);
  }
}

TEST(Mesher, RegionsHaveTheTopologyOfTheirMaterials)
{
  const auto built = Build(MakeHalves(), 0);
  const auto quality = Quality(built.result);
  for (const auto & label : quality.labels)
  {
    EXPECT_EQ(label.components, 1u);
    EXPECT_EQ(label.openEdges, 0u);
    EXPECT_EQ(label.nonManifoldEdges, 0u);
    EXPECT_EQ(label.betti[0], 1);
    EXPECT_EQ(label.betti[1], 0);
    EXPECT_EQ(label.betti[2], 0);
  }
}

TEST(Mesher, OptimizationKeepsTheTopology)
{
  const Scene            scene = MakeNoise();
  mmm::MeshingParameters parameters;
  parameters.compareTopology = true;
  const auto optimized = Build(scene, 0, parameters).result;
  parameters.optimization.rounds = 0;
  const auto before = Build(scene, 0, parameters).result;
  ASSERT_GT(optimized.report.optimization.collapses, 50u);
  const auto labels = Quality(optimized).labels;
  const auto labelsBefore = Quality(before).labels;
  ASSERT_EQ(labels.size(), labelsBefore.size());
  for (std::size_t m = 0; m < labels.size(); ++m)
  {
    EXPECT_EQ(labels[m].betti, labelsBefore[m].betti) << "material " << m;
  }
}

TEST(Mesher, ReportsTheBettiNumbersOfTheFinalMesh)
{
  mmm::MeshingParameters parameters;
  parameters.compareTopology = true;
  const auto result = Build(MakeNoise(), 0, parameters).result;
  const auto labels = Quality(result).labels;
  ASSERT_FALSE(result.report.topology.labels.empty());
  for (const auto & entry : result.report.topology.labels)
  {
    const auto label =
      std::find_if(labels.begin(), labels.end(), [&](const auto & l) { return l.label == entry.label; });
    ASSERT_NE(label, labels.end());
    EXPECT_EQ(entry.mesh, label->betti);
  }
}

TEST(Mesher, KeptTopologyDiffersLessOnNoise)
{
  const Scene            scene = MakeNoise();
  mmm::MeshingParameters parameters;
  parameters.compareTopology = true;
  const auto sumOfDifferences = [&] {
    std::ptrdiff_t sum = 0;
    for (const auto & label : Build(scene, 0, parameters).result.report.topology.labels)
    {
      for (int b = 0; b < 3; ++b)
      {
        sum += std::abs(label.mesh[b] - label.partition[b]);
      }
    }
    return sum;
  };
  const auto usual = sumOfDifferences();
  parameters.keepTopology = true;
  EXPECT_LT(sumOfDifferences(), usual);
}

TEST(Mesher, ParticlesOfBentLayersComeToRest)
{
  const auto   built = Build(MakeNoise(), 0);
  const auto & relaxation = built.result.report.relaxation;
  for (int dimension = 1; dimension <= 2; ++dimension)
  {
    EXPECT_TRUE(relaxation[dimension].converged) << relaxation[dimension].meanMove << " h, dimension " << dimension;
    EXPECT_LT(relaxation[dimension].meanMove, mmm::RelaxationParameters().tolerance);
  }
}

TEST(Mesher, NoTriangleOfNoiseIsFlat)
{
  const auto quality = Quality(Build(MakeNoise(), 0).result);
  EXPECT_GT(quality.interfaceRadiusRatio.minimum, 0.3);
  EXPECT_GT(quality.interfaceRadiusRatio.firstPercentile, 0.6);
}

TEST(Mesher, TrianglesOfAFoldedSheetAreBetweenTheMaterialsOfTheirCorners)
{
  // a voxel thick or less, and torn where it is steep
  const Scene scene(MakeMaterials({ { 32, 32, 32 } }, Vector::Ones(), 3, [](const Vector & x) {
    const double height = 15.5 + 6.0 * std::sin(0.7 * x[0]) * std::cos(0.6 * x[1] + 0.3 * x[0]);
    return x[2] < height ? 0 : x[2] < height + 1.2 ? 1 : 2;
  }));
  const auto  result = Build(scene, -1).result;
  EXPECT_LE(double(result.report.inconsistentTriangles.size()), 0.001 * double(result.interfaces.triangles.size()));
}

TEST(Mesher, JunctionPointsStayNearTheirJunction)
{
  const Scene  scene = MakeNoise();
  const auto   built = Build(scene, 0);
  const auto & particles = built.result.particles;
  const double tolerance = mmm::OptimizationParameters().interfaceTolerance;
  std::size_t  count = 0;
  std::size_t  far = 0;
  for (std::size_t p = 0; p < particles.Size(); ++p)
  {
    const mmm::Cell & cell = particles.CellOf(p);
    // no place is known of those that were joined
    if (cell.count != 4 ||
        std::any_of(cell.begin(), cell.end(), [&](mmm::Material m) { return scene.indicators->IsPlane(m); }))
    {
      continue;
    }
    Vector junction = built.result.points[p];
    if (scene.indicators->ProjectWhereMaximal(cell, junction, 1.0))
    {
      ++count;
      far += (built.result.points[p] - junction).norm() > tolerance + 0.01;
    }
  }
  EXPECT_GT(count, 50u);
  // other materials may meet there than its cell says
  EXPECT_LE(far, count / 20);
}

TEST(Mesher, LeavesEnclosedExteriorEmpty)
{
  const Scene  scene(MakeMaterials({ { 27, 27, 27 } }, Vector::Ones(), 2, [](const Vector & x) {
    const double r = (x - Vector(13.2, 12.9, 13.1)).norm();
    return r < 10.0 && r > 5.0 ? 1 : 0;
  }));
  const auto   built = Build(scene, 0);
  const auto   quality = Quality(built.result);
  const double exact = 4.0 / 3.0 * EIGEN_PI * (1000.0 - 125.0);
  EXPECT_NEAR(Volumes(built.result).at(1), exact, 0.03 * exact);
  ASSERT_EQ(quality.labels.size(), 1u);
  EXPECT_EQ(quality.labels[0].betti[2], 1);
}

TEST(Mesher, CutsAreFlatAndSharp)
{
  // material 1 fills half of the image and is cut by five of its faces
  const Scene  scene(MakeMaterials({ { 14, 14, 14 } }, Vector::Ones(), 2, [](const Vector & x) { return x[2] < 6.8; }));
  const auto   built = Build(scene, 0);
  const double volume = Volumes(built.result).at(1);
  EXPECT_NEAR(volume, 14.0 * 14.0 * 7.0, 1.0);
  std::size_t corners = 0;
  for (const Vector & x : built.result.points)
  {
    const bool ends = (x[0] == -0.5 || x[0] == 13.5) && (x[1] == -0.5 || x[1] == 13.5);
    corners += ends && x[2] == -0.5;
    EXPECT_GE(x.minCoeff(), -0.5);
    EXPECT_LE(x.maxCoeff(), 13.5);
  }
  EXPECT_EQ(corners, 4u);
}

TEST(Mesher, MeshesEverythingWithoutAnExterior)
{
  const auto built = Build(MakeHalves(), -1);
  double     total = 0.0;
  for (const auto & entry : Volumes(built.result))
  {
    total += entry.second;
  }
  EXPECT_NEAR(total, 27.0 * 27.0 * 27.0, 1e-6 * 27.0 * 27.0 * 27.0);
}

TEST(Mesher, GivesTheSameMeshTwice)
{
  const auto first = Build(MakeHalves(), 0);
  const auto second = Build(MakeHalves(), 0);
  EXPECT_EQ(first.result.tetrahedra.tetrahedra, second.result.tetrahedra.tetrahedra);
  EXPECT_EQ(first.result.points, second.result.points);
}

namespace
{
/** Two tetrahedra that pierce each other. */
struct PiercingTetrahedra
{
  std::vector<Vector>        points{ { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 0, 0, 4 },
                                     { 1, 1, 1 }, { 5, 1, 1 }, { 1, 5, 1 }, { 1, 1, -3 } };
  std::vector<mmm::Triangle> facets{ { { 0, 1, 2 } }, { { 0, 1, 3 } }, { { 0, 2, 3 } }, { { 1, 2, 3 } },
                                     { { 4, 5, 6 } }, { { 4, 5, 7 } }, { { 4, 6, 7 } }, { { 5, 6, 7 } } };
};
} // namespace

TEST(TetGen, PassesOnItsWordsAboutFacetsThatItCannotKeep)
{
  PiercingTetrahedra input;
  try
  {
    mmm::ConstrainedTetrahedralization(input.points, input.facets);
    FAIL() << "no exception";
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_NE(std::string(error.GetDescription()).find("TetGen"), std::string::npos);
    EXPECT_NE(std::string(error.GetDescription()).find("8 facets"), std::string::npos);
  }
}

TEST(TetGen, TellsWhichFacetsIntersectOthers)
{
  const PiercingTetrahedra input;
  const auto               words = mmm::DescribeIntersections(input.points, input.facets);
  EXPECT_NE(words.find("surface: 0, 3, 4, 5, 6 (5 in all)"), std::string::npos) << words;
}
