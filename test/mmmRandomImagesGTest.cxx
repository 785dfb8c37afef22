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
#include "mmmHash.h"
#include "mmmMesher.h"
#include "mmmMeshQuality.h"
#include "mmmSizing.h"
#include "mmmTestScenes.h"

#include "itkMacro.h"

#include <gtest/gtest.h>

using mmm::Vector;
using mmmtest::MakeMaterials;
using mmmtest::Scene;

namespace
{
/** Meshes a scene; a valid mesh or an exception is what may come. */
void
ExpectValidOrException(const Scene & scene, int exterior)
{
  mmm::Monitor           monitor;
  mmm::MeshingParameters parameters;
  mmm::MeshingResult     result;
  parameters.exterior = exterior;
  try
  {
    const auto sizes = mmm::ComputeSizing(*scene.indicators, exterior, {}, {}, monitor);
    mmm::BuildMesh(*scene.indicators, mmm::SizingField(scene.image.grid, sizes.data()), parameters, monitor, result);
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_FALSE(std::string(error.GetDescription()).empty());
    return;
  }
  const std::vector<int> labels(result.tetrahedra.materials.begin(), result.tetrahedra.materials.end());
  const auto             quality = mmm::ComputeMeshQuality(result.points, result.tetrahedra.tetrahedra, labels, {});
  EXPECT_EQ(quality.tetrahedra.nonPositive, 0u);
  EXPECT_EQ(quality.unusedPoints, 0u);
  EXPECT_EQ(quality.overusedFaces, 0u);
  for (const auto & label : quality.labels)
  {
    EXPECT_EQ(label.openEdges, 0u);
    EXPECT_LT(label.label, int(scene.image.numberOfMaterials));
    EXPECT_NE(label.label, exterior);
  }
}

class RandomImages : public ::testing::TestWithParam<int>
{};
} // namespace

TEST_P(RandomImages, NoiseGivesAValidMeshOrAnException)
{
  const auto       seed = std::uint64_t(GetParam());
  const mmm::Index size{
    { 3 + int(mmm::Hash(seed) % 9), 3 + int(mmm::Hash(seed + 100) % 9), 3 + int(mmm::Hash(seed + 200) % 9) }
  };
  const int    materials = 2 + int(mmm::Hash(seed + 300) % 4);
  const Vector spacing(1.0, 1.0, seed % 3 == 0 ? 4.0 : 1.0);
  ExpectValidOrException(Scene(MakeMaterials(size,
                                             spacing,
                                             materials,
                                             [&](const Vector & x) {
                                               const auto at = std::uint64_t(x[0] + 0.5) +
                                                               100 * std::uint64_t(x[1] + 0.5) +
                                                               10000 * std::uint64_t(x[2] + 0.5);
                                               return int(mmm::Hash(seed ^ mmm::Hash(at)) % materials);
                                             })),
                         seed % 2 ? 0 : -1);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomImages, ::testing::Range(0, 40));

class Slabs : public ::testing::TestWithParam<int>
{};

TEST_P(Slabs, OfAnySizeAreMeshed)
{
  const int n = GetParam();
  ExpectValidOrException(
    Scene(MakeMaterials({ { n, n, n } }, Vector::Ones(), 3, [n](const Vector & x) { return x[0] < n / 2 ? 1 : 2; })),
    0);
}

INSTANTIATE_TEST_SUITE_P(Sizes, Slabs, ::testing::Range(4, 17));
