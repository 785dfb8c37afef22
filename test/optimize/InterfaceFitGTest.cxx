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
#include "quality/MeshQuality.h"
#include "support/TestScenes.h"
#include "mesh/TetrahedronRaster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using mmm::Vector;
using mmmtest::MakeMaterials;
using mmmtest::Scene;

namespace
{
/** A folded layer, a voxel thick or two, between two materials that fill the rest of the image. */
Scene
MakeFolds(const Vector & spacing)
{
  return Scene(MakeMaterials({ { 24, 24, 20 } }, spacing, 3, [&](const Vector & x) {
    const Vector at = x.cwiseQuotient(spacing);
    const double height = at[2] - 9.7 - 3.0 * std::sin(0.6 * at[0]) * std::cos(0.5 * at[1]);
    return std::abs(height) < 1.0 ? 1 : (height < 0.0 ? 0 : 2);
  }));
}

/** A folded layer of material 1 in empty space, far from the image's border on all sides. */
Scene
MakeSheetInSpace()
{
  return Scene(MakeMaterials({ { 60, 60, 60 } }, Vector::Ones(), 2, [&](const Vector & x) {
    const double height = x[2] - 29.7 - 3.0 * std::sin(0.6 * x[0]) * std::cos(0.5 * x[1]);
    return std::abs(height) < 1.0 && std::hypot(x[0] - 30.0, x[1] - 30.0) < 12.0;
  }));
}

mmm::MeshingResult
Mesh(const Scene & scene, int exterior = -1)
{
  mmm::MeshingResult     result;
  mmm::Monitor           monitor;
  mmm::MeshingParameters parameters;
  parameters.exterior = exterior;
  auto sizes = mmm::ComputeSizing(*scene.indicators, parameters.exterior, {}, {}, monitor);
  mmm::BuildMesh(*scene.indicators, mmm::SizingField(scene.image.grid, sizes.data()), parameters, monitor, result);
  return result;
}

/** The share of a material's voxels whose centres lie in no tetrahedron of it. */
double
ShareOfMissingCentres(const Scene & scene, const mmm::MeshingResult & result, mmm::Material material)
{
  const auto &      grid = scene.image.grid;
  const auto &      materials = scene.image.materials;
  std::vector<char> isFound(materials.size(), 0);
  for (std::size_t t = 0; t < result.tetrahedra.tetrahedra.size(); ++t)
  {
    const auto corners = mmm::CornersInVoxels(grid, result.points, result.tetrahedra.tetrahedra[t]);
    mmm::VisitIndicesInside(grid.size, corners, 1e-9, [&](const mmm::Index & at) {
      isFound[grid.Offset(at)] |= result.tetrahedra.materials[t] == material;
    });
  }
  std::size_t all = 0;
  std::size_t missing = 0;
  for (std::size_t n = 0; n < materials.size(); ++n)
  {
    all += materials[n] == material;
    missing += materials[n] == material && !isFound[n];
  }
  return double(missing) / double(all);
}
} // namespace

TEST(InterfaceFit, VoxelCentresOfThinLayersLieInTetrahedraOfTheirMaterial)
{
  const Scene scene = MakeFolds(Vector::Ones());
  const auto  result = Mesh(scene);
  EXPECT_LT(ShareOfMissingCentres(scene, result, 0), 0.003);
  EXPECT_LT(ShareOfMissingCentres(scene, result, 1), 0.01);
  EXPECT_LT(ShareOfMissingCentres(scene, result, 2), 0.005);
}

TEST(InterfaceFit, VoxelCentresOfLongVoxelsAreRecoveredAsWell)
{
  const Scene scene = MakeFolds(Vector(1.0, 1.0, 2.0));
  EXPECT_LT(ShareOfMissingCentres(scene, Mesh(scene), 1), 0.01);
}

TEST(InterfaceFit, VoxelCentresBesideTheExteriorAreRecoveredAsWell)
{
  const Scene scene = MakeSheetInSpace();
  EXPECT_LT(ShareOfMissingCentres(scene, Mesh(scene, 0), 1), 0.02);
}

TEST(InterfaceFit, TheWholeImageStaysMeshed)
{
  const auto result = Mesh(MakeFolds(Vector::Ones()));
  double     volume = 0.0;
  for (const auto & t : result.tetrahedra.tetrahedra)
  {
    const auto & x = result.points;
    volume += mmm::TetrahedronVolume(x[t[0]], x[t[1]], x[t[2]], x[t[3]]);
  }
  EXPECT_NEAR(volume, 24.0 * 24.0 * 20.0, 1e-6);
}

TEST(InterfaceFit, TrianglesAndTetrahedraStayGood)
{
  const auto result = Mesh(MakeFolds(Vector::Ones()));
  const auto quality =
    mmm::ComputeMeshQuality(result.points,
                            result.tetrahedra.tetrahedra,
                            std::vector<int>(result.tetrahedra.materials.begin(), result.tetrahedra.materials.end()),
                            {});
  EXPECT_GT(quality.tetrahedra.smallestAngle.minimum, 20.0);
  EXPECT_GT(quality.interfaceRadiusRatio.average, 0.94);
  EXPECT_GT(quality.interfaceRadiusRatio.minimum, 0.6);
}

TEST(InterfaceFit, PointsStayNearTheirCells)
{
  const Scene  scene = MakeFolds(Vector::Ones());
  const auto   result = Mesh(scene);
  const auto & particles = result.particles;
  std::size_t  far = 0;
  for (std::size_t p = 0; p < particles.Size(); ++p)
  {
    Vector x = result.points[p];
    far += !scene.indicators->Project(particles.CellOf(p), x, 1.0) || (x - result.points[p]).norm() > 0.3;
  }
  EXPECT_EQ(far, 0u);
}
