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
#include "base/Hash.h"
#include "pipeline/Mesher.h"
#include "support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using mmm::Vector;
using mmmtest::MakeMaterials;
using mmmtest::Scene;

namespace
{
struct Plane
{
  Vector normal;
  double offset;
};

/** Materials that fill the image to its faces. */
mmm::MeshingResult
BuildAll(const Scene & scene)
{
  mmm::MeshingResult result;
  mmm::Monitor       monitor;
  const auto         sizes = mmm::ComputeSizing(*scene.indicators, -1, {}, {}, monitor);
  mmm::BuildMesh(*scene.indicators, mmm::SizingField(scene.image.grid, sizes.data()), {}, monitor, result);
  return result;
}

/** Expects that all materials meet in one of some planes, and that no triangle is anywhere else. */
void
ExpectInterfacesInPlanes(const Scene & scene, const std::vector<Plane> & planes, double tolerance = 0.1)
{
  const auto  result = BuildAll(scene);
  std::size_t count = 0;
  double      furthest = 0.0;
  for (std::size_t t = 0; t < result.interfaces.triangles.size(); ++t)
  {
    if (result.interfaces.sides[t][1] >= scene.indicators->GetNumberOfMaterials())
    {
      continue; // a face of the image
    }
    for (const auto corner : result.interfaces.triangles[t])
    {
      double nearest = std::numeric_limits<double>::infinity();
      for (const Plane & plane : planes)
      {
        nearest = std::min(nearest, std::abs(plane.normal.dot(result.points[corner]) - plane.offset));
      }
      furthest = std::max(furthest, nearest);
    }
    ++count;
  }
  EXPECT_GT(count, 4 * planes.size());
  EXPECT_LT(furthest, tolerance);
  EXPECT_TRUE(result.report.inconsistentTriangles.empty());
}

/** Layers whose first voxels along an axis are at these numbers. */
void
ExpectFlatLayers(const mmm::Index & size, int axis, const std::vector<int> & starts)
{
  std::vector<Plane> planes;
  for (const int start : starts)
  {
    planes.push_back({ Vector::Unit(axis), start - 0.5 });
  }
  ExpectInterfacesInPlanes(Scene(MakeMaterials(size,
                                               Vector::Ones(),
                                               starts.size() + 1,
                                               [&](const Vector & x) {
                                                 return std::upper_bound(starts.begin(), starts.end(), x[axis] + 0.25) -
                                                        starts.begin();
                                               })),
                           planes);
}
} // namespace

TEST(Borders, EqualLayersAreFlatUpToTheFacesOfTheImage)
{
  ExpectFlatLayers({ { 24, 24, 24 } }, 0, { 8, 16 });
  ExpectFlatLayers({ { 30, 26, 22 } }, 0, { 13 });
}

TEST(Borders, LayersOfDifferentThicknessAreFlatUpToTheFacesOfTheImage)
{
  ExpectFlatLayers({ { 30, 30, 32 } }, 2, { 3, 8, 20 });
  ExpectFlatLayers({ { 20, 25, 24 } }, 1, { 2, 4, 11 });
}

TEST(Borders, LayersThatEndAtALayerAreFlatUpToTheFacesOfTheImage)
{
  constexpr double roundedJunction = 0.3;
  ExpectInterfacesInPlanes(
    Scene(MakeMaterials(
      { { 24, 24, 24 } }, Vector::Ones(), 3, [](const Vector & x) { return x[0] < 11.5 ? 0 : (x[1] < 11.5 ? 1 : 2); })),
    { { Vector::UnitX(), 11.5 }, { Vector::UnitY(), 11.5 } },
    roundedJunction);
}

TEST(Borders, OctantsOfDifferentMaterialsAreFlat)
{
  ExpectInterfacesInPlanes(
    Scene(MakeMaterials({ { 20, 20, 20 } },
                        Vector::Ones(),
                        8,
                        [](const Vector & x) { return (x[0] > 9.5) + 2 * (x[1] > 9.5) + 4 * (x[2] > 9.5); })),
    { { Vector::UnitX(), 9.5 }, { Vector::UnitY(), 9.5 }, { Vector::UnitZ(), 9.5 } });
}

TEST(Borders, TrianglesOfSlantedLayersLieWhereTheirMaterialsMeet)
{
  const Scene scene(MakeMaterials({ { 30, 26, 22 } }, Vector::Ones(), 4, [](const Vector & x) {
    return std::min(3, int((0.8 * x[0] + 0.5 * x[1] + 0.33 * x[2]) / 11.0));
  }));
  EXPECT_TRUE(BuildAll(scene).report.inconsistentTriangles.empty());
}

TEST(Borders, TrianglesOfGrainsLieWhereTheirMaterialsMeet)
{
  // those of the points of which none is nearer
  constexpr int       Count = 14;
  constexpr int       Size = 24;
  std::vector<Vector> centres;
  for (std::uint64_t n = 0; n < Count; ++n)
  {
    centres.emplace_back(
      double(mmm::Hash(3 * n) % Size), double(mmm::Hash(3 * n + 1) % Size), double(mmm::Hash(3 * n + 2) % Size));
  }
  const Scene scene(MakeMaterials({ { Size, Size, Size } }, Vector::Ones(), Count, [&](const Vector & x) {
    const auto isNearer = [&](const Vector & a, const Vector & b) { return (a - x).norm() < (b - x).norm(); };
    return std::min_element(centres.begin(), centres.end(), isNearer) - centres.begin();
  }));
  EXPECT_TRUE(BuildAll(scene).report.inconsistentTriangles.empty());
}

TEST(Borders, CylindersThatTwoSlicesCutKeepTheirVolume)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    mmm::Index size{ { 22, 22, 22 } };
    size[axis] = 2;
    double      voxels = 0.0;
    const Scene scene(MakeMaterials(size, Vector::Ones(), 2, [&](Vector x) {
      x -= Vector::Constant(10.5);
      x[axis] = 0.0;
      const bool isInside = x.squaredNorm() < 12.0;
      voxels += isInside;
      return int(isInside);
    }));
    const auto  result = BuildAll(scene);
    double      volume = 0.0;
    for (std::size_t t = 0; t < result.tetrahedra.tetrahedra.size(); ++t)
    {
      const auto & c = result.tetrahedra.tetrahedra[t];
      const auto & x = result.points;
      volume += result.tetrahedra.materials[t] == 1 ? mmm::TetrahedronVolume(x[c[0]], x[c[1]], x[c[2]], x[c[3]]) : 0.0;
    }
    EXPECT_NEAR(volume / voxels, 1.0, 0.02) << "along axis " << axis;
  }
}
