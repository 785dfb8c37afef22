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
#include "topology/PartitionTopology.h"
#include "support/TestScenes.h"

#include "gtest/gtest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace
{
using Betti = mmm::BettiNumbers;

/** The topology of samples whose material is a function of their indices. */
template <typename TFunction>
std::vector<Betti>
TopologyOf(const mmm::Index & size, std::size_t materials, const TFunction & materialAt)
{
  return mmm::ComputeSampleTopology(size, materials, [&](int j, int k, std::vector<mmm::Material> & labels) {
    labels.resize(size[0]);
    for (int i = 0; i < size[0]; ++i)
    {
      labels[i] = mmm::Material(materialAt(i, j, k));
    }
  });
}

/** Components by flooding: samples of one material are neighbours if indices differ by 0 or 1, all in one direction. */
template <typename TFunction>
std::ptrdiff_t
CountByFlooding(int size, const TFunction & isInside)
{
  std::set<std::array<int, 3>> left;
  for (int n = 0; n < size * size * size; ++n)
  {
    const std::array<int, 3> at{ { n % size, n / size % size, n / size / size } };
    if (isInside(at[0], at[1], at[2]))
    {
      left.insert(at);
    }
  }
  std::ptrdiff_t components = 0;
  for (; !left.empty(); ++components)
  {
    std::vector<std::array<int, 3>> stack{ *left.begin() };
    left.erase(left.begin());
    while (!stack.empty())
    {
      const auto at = stack.back();
      stack.pop_back();
      for (int n = 0; n < 16; ++n)
      {
        const int                sign = n < 8 ? 1 : -1;
        const std::array<int, 3> other{
          { at[0] + sign * (n & 1), at[1] + sign * (n >> 1 & 1), at[2] + sign * (n >> 2 & 1) }
        };
        if (left.erase(other) > 0)
        {
          stack.push_back(other);
        }
      }
    }
  }
  return components;
}

/** Simplices of 0 to 3 dimensions, with alternating signs: chains of samples, each a step of 0 or 1 from all before. */
template <typename TFunction>
std::ptrdiff_t
CharacteristicByChains(int size, const TFunction & isInside)
{
  std::ptrdiff_t sum = 0;
  const auto     holds = [&](int n, int step) {
    const int at[3] = { n % size + (step & 1), n / size % size + (step >> 1 & 1), n / size / size + (step >> 2) };
    return std::max({ at[0], at[1], at[2] }) < size && isInside(at[0], at[1], at[2]);
  };
  for (int n = 0; n < size * size * size; ++n)
  {
    for (int chain = 0; chain < 512 && holds(n, 0); ++chain)
    {
      // three steps, ascending by bits; those that stay are of lower dimension
      const int steps[4] = { 0, chain & 7, chain >> 3 & 7, chain >> 6 };
      int       dimension = 0;
      bool      isChain = true;
      for (int s = 1; s < 4; ++s)
      {
        const bool ends = steps[s] == 0;
        isChain = isChain &&
                  (ends ? s == 3 || steps[s + 1] == 0
                        : (steps[s] & steps[s - 1]) == steps[s - 1] && steps[s] != steps[s - 1] && holds(n, steps[s]));
        dimension += !ends;
      }
      if (isChain)
      {
        sum += dimension % 2 ? -1 : 1;
      }
    }
  }
  return sum;
}
} // namespace

TEST(PartitionTopology, BallHasOneComponent)
{
  const auto topology =
    TopologyOf({ { 11, 11, 11 } }, 2, [](int i, int j, int k) { return std::hypot(i - 5, j - 5, k - 5) < 4.2; });
  EXPECT_EQ(topology[1], (Betti{ { 1, 0, 0 } }));
}

TEST(PartitionTopology, SurroundingsOfABallHaveACavity)
{
  const auto topology =
    TopologyOf({ { 11, 11, 11 } }, 2, [](int i, int j, int k) { return std::hypot(i - 5, j - 5, k - 5) < 4.2; });
  EXPECT_EQ(topology[0], (Betti{ { 1, 0, 1 } }));
}

TEST(PartitionTopology, TorusHasATunnel)
{
  const auto topology = TopologyOf(
    { { 21, 21, 9 } }, 2, [](int i, int j, int k) { return std::hypot(std::hypot(i - 10, j - 10) - 7, k - 4) < 2.5; });
  EXPECT_EQ(topology[1], (Betti{ { 1, 1, 0 } }));
}

TEST(PartitionTopology, ShellHasACavity)
{
  const auto topology = TopologyOf({ { 11, 11, 11 } }, 2, [](int i, int j, int k) {
    const double r = std::hypot(i - 5, j - 5, k - 5);
    return r < 4.9 && r > 2.9;
  });
  EXPECT_EQ(topology[1], (Betti{ { 1, 0, 1 } }));
}

TEST(PartitionTopology, MaterialsThatMeetCrosswiseDoNotBothConnect)
{
  // a checkerboard of four columns
  const auto topology = TopologyOf({ { 2, 2, 3 } }, 2, [](int i, int j, int) { return (i + j) % 2; });
  EXPECT_EQ(topology[0][0] + topology[1][0], 3);
}

TEST(PartitionTopology, MaterialWithoutSamplesHasNothing)
{
  const auto topology = TopologyOf({ { 3, 3, 3 } }, 2, [](int, int, int) { return 0; });
  EXPECT_EQ(topology[1], (Betti{ { 0, 0, 0 } }));
}

TEST(PartitionTopology, NoiseAgreesWithFloodingAndWithTheCharacteristic)
{
  constexpr int Size = 9;
  for (int seed = 0; seed < 8; ++seed)
  {
    const auto materialAt = [=](int i, int j, int k) {
      return int(mmm::Hash(std::uint64_t(seed * 1000 + i + Size * (j + Size * k))) % 3);
    };
    const auto topology = TopologyOf({ { Size, Size, Size } }, 3, materialAt);
    for (int m = 0; m < 3; ++m)
    {
      const auto isInside = [=](int i, int j, int k) { return materialAt(i, j, k) == m; };
      EXPECT_EQ(topology[m][0], CountByFlooding(Size, isInside));
      EXPECT_EQ(topology[m][0] - topology[m][1] + topology[m][2], CharacteristicByChains(Size, isInside));
    }
  }
}

TEST(PartitionTopology, IndicatorsOfABallHaveTheBall)
{
  const mmmtest::Scene scene(
    mmmtest::MakeMaterials({ { 15, 15, 15 } }, mmm::Vector::Ones(), 2, [](const mmm::Vector & x) {
      return (x - mmm::Vector(7, 7, 7)).norm() < 4.3;
    }));
  const mmm::SampleLattice lattice(*scene.indicators);
  const auto               topology = mmm::ComputePartitionTopology(lattice, lattice.SamplePartition(0));
  EXPECT_EQ(topology[0], (Betti{ { 1, 0, 1 } }));
  EXPECT_EQ(topology[1], (Betti{ { 1, 0, 0 } }));
}
