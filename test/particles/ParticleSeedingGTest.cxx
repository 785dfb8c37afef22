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
#include "particles/Particles.h"
#include "support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using mmm::Index;
using mmm::Vector;

namespace
{
constexpr int Size = 12;
} // namespace

TEST(ParticleSeeding, AroundSamplesGoesToTheBorder)
{
  // an interface in the plane x = 4.5, which the faces of the box cut
  const mmmtest::Scene scene(
    mmmtest::MakeMaterials({ { Size, Size, Size } }, Vector::Ones(), 2, [](const Vector & x) { return x[0] < 4.5; }));
  const mmm::SampleLattice lattice(*scene.indicators, 4);
  const auto               partition = lattice.SamplePartition(2);
  std::vector<Index>       column;
  for (int k = 0; k < lattice.GetSize()[2]; ++k)
  {
    column.push_back({ { 18, 20, k } });
  }
  const std::vector<float> sizes(scene.image.grid.NumberOfNodes(), 1.0f);
  mmm::ParticleSet         particles;
  ASSERT_GT(
    mmm::SeedParticlesAround(
      mmm::SampleCubes(lattice, partition), column, mmm::SizingField(scene.image.grid, sizes.data()), -1, 1, particles),
    0u);
  for (const double border : { -0.5, Size - 0.5 })
  {
    const auto plane = mmm::Material(2 + 2 * 2 + (border > 0.0));
    bool       isThere = false;
    for (std::size_t p = 0; p < particles.Size(); ++p)
    {
      const mmm::Cell & cell = particles.CellOf(p);
      isThere = isThere || (cell.Has(0) && cell.Has(1) && cell.Has(plane) &&
                            (particles.positions[p] - Vector(4.5, 5.0, border)).norm() < 0.5);
    }
    EXPECT_TRUE(isThere) << border;
  }
}
