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
#include "mmmMesher.h"
#include "mmmMeshQuality.h"
#include "mmmTestScenes.h"
#include "mmmTetrahedronRaster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

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

mmm::MeshingResult
Mesh(const Scene & scene)
{
  mmm::MeshingResult     result;
  mmm::Monitor           monitor;
  mmm::MeshingParameters parameters;
  parameters.exterior = -1;
  auto sizes = mmm::ComputeSizing(*scene.indicators, parameters.exterior, {}, {}, monitor);
  mmm::BuildMesh(*scene.indicators, mmm::SizingField(scene.image.grid, sizes.data()), parameters, monitor, result);
  return result;
}

/** The share of a material's voxels whose centres lie in tetrahedra of another one. */
double
ShareOfWrongCentres(const Scene & scene, const mmm::MeshingResult & result, mmm::Material material)
{
  const auto & grid = scene.image.grid;
  const auto & materials = scene.image.materials;
  std::size_t  wrong = 0;
  for (std::size_t t = 0; t < result.tetrahedra.tetrahedra.size(); ++t)
  {
    std::array<Vector, 4> corners;
    for (int c = 0; c < 4; ++c)
    {
      corners[c] = result.points[result.tetrahedra.tetrahedra[t][c]].cwiseQuotient(grid.spacing);
    }
    mmm::VisitIndicesInside(grid.size, corners, -1e-9, [&](const mmm::Index & at) {
      wrong += materials[grid.Offset(at)] == material && result.tetrahedra.materials[t] != material;
    });
  }
  return double(wrong) / double(std::count(materials.begin(), materials.end(), material));
}
} // namespace

TEST(InterfaceFit, VoxelCentresOfThinLayersLieInTetrahedraOfTheirMaterial)
{
  const Scene scene = MakeFolds(Vector::Ones());
  const auto  result = Mesh(scene);
  for (const mmm::Material m : { 0, 1, 2 })
  {
    EXPECT_LT(ShareOfWrongCentres(scene, result, m), 0.01) << "material " << int(m);
  }
}

TEST(InterfaceFit, VoxelCentresOfLongVoxelsAreRecoveredAsWell)
{
  const Scene scene = MakeFolds(Vector(1.0, 1.0, 2.0));
  EXPECT_LT(ShareOfWrongCentres(scene, Mesh(scene), 1), 0.01);
}

TEST(InterfaceFit, TrianglesAndTetrahedraStayGood)
{
  const auto result = Mesh(MakeFolds(Vector::Ones()));
  const auto quality =
    mmm::ComputeMeshQuality(result.points,
                            result.tetrahedra.tetrahedra,
                            std::vector<int>(result.tetrahedra.materials.begin(), result.tetrahedra.materials.end()),
                            {});
  EXPECT_GT(quality.tetrahedra.smallestAngle.minimum, 15.0);
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
  EXPECT_LT(double(far), 0.01 * double(particles.Size()));
}
