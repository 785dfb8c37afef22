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
#include "mmmPartitionTopology.h"
#include "mmmTestScenes.h"

#include "gtest/gtest.h"

#include <array>
#include <cmath>
#include <map>
#include <set>

namespace
{
using Betti = mmm::BettiNumbers;

/** The topology of boxes whose material is a function of their indices. */
template <typename TFunction>
std::vector<Betti>
TopologyOf(const mmm::Index & size, std::size_t materials, const TFunction & materialAt)
{
  return mmm::ComputeBoxTopology(size, materials, [&](int j, int k, std::vector<mmm::Material> & labels) {
    labels.resize(size[0]);
    for (int i = 0; i < size[0]; ++i)
    {
      labels[i] = mmm::Material(materialAt(i, j, k));
    }
  });
}

/** Components by flooding: boxes of one material are neighbours if no index differs by more than one. */
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
      for (int n = 0; n < 27; ++n)
      {
        const std::array<int, 3> other{ { at[0] + n % 3 - 1, at[1] + n / 3 % 3 - 1, at[2] + n / 9 - 1 } };
        if (left.erase(other) > 0)
        {
          stack.push_back(other);
        }
      }
    }
  }
  return components;
}

/** Points, edges, faces and bodies of boxes, with alternating signs; twice the indices are the elements' centres. */
template <typename TFunction>
std::ptrdiff_t
CharacteristicByElements(int size, const TFunction & isInside)
{
  std::set<std::array<int, 3>> elements;
  for (int n = 0; n < size * size * size; ++n)
  {
    const std::array<int, 3> at{ { n % size, n / size % size, n / size / size } };
    for (int e = 0; e < 27 && isInside(at[0], at[1], at[2]); ++e)
    {
      elements.insert({ { 2 * at[0] + e % 3 - 1, 2 * at[1] + e / 3 % 3 - 1, 2 * at[2] + e / 9 - 1 } });
    }
  }
  std::ptrdiff_t sum = 0;
  for (const auto & element : elements)
  {
    int odd = 0;
    for (const int x : element)
    {
      odd += x & 1;
    }
    // a body has even coordinates, a point odd ones
    sum += odd % 2 ? 1 : -1;
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

TEST(PartitionTopology, BoxesThatTouchInACornerAreConnected)
{
  const auto topology = TopologyOf({ { 2, 2, 2 } }, 2, [](int i, int j, int k) { return i == j && j == k; });
  EXPECT_EQ(topology[1], (Betti{ { 1, 0, 0 } }));
}

TEST(PartitionTopology, MaterialWithoutBoxesHasNothing)
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
      EXPECT_EQ(topology[m][0] - topology[m][1] + topology[m][2], CharacteristicByElements(Size, isInside));
    }
  }
}

TEST(PartitionTopology, IndicatorsOfABallHaveTheBall)
{
  const mmmtest::Scene scene(
    mmmtest::MakeMaterials({ { 15, 15, 15 } }, mmm::Vector::Ones(), 2, [](const mmm::Vector & x) {
      return (x - mmm::Vector(7, 7, 7)).norm() < 4.3;
    }));
  const auto topology = mmm::ComputePartitionTopology(*scene.indicators);
  EXPECT_EQ(topology[0], (Betti{ { 1, 0, 1 } }));
  EXPECT_EQ(topology[1], (Betti{ { 1, 0, 0 } }));
}
