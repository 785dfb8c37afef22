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
#include "mmmSampleNeighbours.h"
#include "mmmTestScenes.h"
#include "mmmTopologyComparison.h"
#include "mmmTopologyDifferences.h"

#include "gtest/gtest.h"

#include <cmath>

using mmm::Index;
using mmm::Vector;

namespace
{
constexpr int Size = 20;

/** A ball of material 1, so large that samples around its surface are kept. */
mmmtest::Scene
MakeBall()
{
  return mmmtest::Scene(mmmtest::MakeBallMaterials(Size, Vector::Constant(0.5 * (Size - 1)), 5.3));
}

Vector
FromCentre(const mmm::SampleLattice & lattice, const Index & sample)
{
  return lattice.Position(sample) - Vector::Constant(0.5 * (Size - 1));
}

/** The samples, with another material where a function of the place says so. */
template <typename TFunction>
mmm::SampledMaterials
Changed(const mmm::SampleLattice &    lattice,
        const mmm::SampledMaterials & samples,
        mmm::Material                 material,
        const TFunction &             isChanged)
{
  auto changed = samples;
  for (std::size_t place = 0; place < changed.size(); ++place)
  {
    if (isChanged(FromCentre(lattice, lattice.SampleAt(place))))
    {
      changed[place] = material;
    }
  }
  return changed;
}

std::ptrdiff_t
CharacteristicOf(const mmm::BettiNumbers & betti)
{
  return betti[0] - betti[1] + betti[2];
}
} // namespace

TEST(SampleNeighbours, FormDisksAndRings)
{
  const mmm::SampleNeighbours neighbours;
  EXPECT_FALSE(neighbours.IsDisk(0));
  EXPECT_EQ(neighbours.CharacteristicOf(0), 0);
  EXPECT_FALSE(neighbours.IsDisk((1u << mmm::SampleNeighbours::Count) - 1));
  EXPECT_EQ(neighbours.CharacteristicOf((1u << mmm::SampleNeighbours::Count) - 1), 2);
  EXPECT_TRUE(neighbours.IsDisk(1));
  unsigned opposite = 0;
  unsigned plane = 0;
  for (int n = 0; n < mmm::SampleNeighbours::Count; ++n)
  {
    const Index at = mmm::SampleNeighbours::Of({ { 0, 0, 0 } }, n);
    opposite |= unsigned(at[1] == 0 && at[2] == 0) << n;
    plane |= unsigned(at[2] == 0) << n;
  }
  EXPECT_FALSE(neighbours.IsDisk(opposite));
  EXPECT_EQ(neighbours.CharacteristicOf(opposite), 2);
  EXPECT_FALSE(neighbours.IsDisk(plane));
  EXPECT_EQ(neighbours.CharacteristicOf(plane), 0);
}

TEST(SampleLattice, PlacesAndSamplesAreInverse)
{
  const auto               scene = MakeBall();
  const mmm::SampleLattice lattice(*scene.indicators);
  ASSERT_GT(lattice.NumberOfKept(), 0u);
  ASSERT_LT(lattice.NumberOfKept(), std::size_t(8) * Size * Size * Size);
  for (std::size_t place = 0; place < lattice.NumberOfKept(); ++place)
  {
    EXPECT_EQ(lattice.PlaceOf(lattice.SampleAt(place)), place);
  }
}

TEST(TopologyDifferences, AreNoneBetweenEqualPartitions)
{
  const auto               scene = MakeBall();
  const mmm::SampleLattice lattice(*scene.indicators);
  const auto               samples = lattice.SamplePartition(0);
  EXPECT_TRUE(mmm::FindTopologyDifferences(lattice, samples, samples).empty());
}

TEST(TopologyDifferences, AreNoneWhereASurfaceIsALittleOff)
{
  const auto               scene = MakeBall();
  const mmm::SampleLattice lattice(*scene.indicators);
  const auto               samples = lattice.SamplePartition(0);
  const auto bulge = Changed(lattice, samples, 1, [](const Vector & x) { return x.norm() < 6.2 && x[0] > 1.0; });
  ASSERT_NE(bulge, samples);
  EXPECT_TRUE(mmm::FindTopologyDifferences(lattice, samples, bulge).empty());
}

TEST(TopologyDifferences, TellOfAPartThatIsExtra)
{
  const auto               scene = MakeBall();
  const mmm::SampleLattice lattice(*scene.indicators);
  const auto               samples = lattice.SamplePartition(0);
  const Vector             at(6.5, 0.0, 0.0);
  const auto extra = Changed(lattice, samples, 1, [&](const Vector & x) { return (x - at).norm() < 0.6; });
  const auto differences = mmm::FindTopologyDifferences(lattice, samples, extra);
  ASSERT_EQ(differences.size(), 1u);
  for (const auto place : differences[0].samples)
  {
    EXPECT_LT((FromCentre(lattice, lattice.SampleAt(place)) - at).norm(), 0.6);
  }
  ASSERT_EQ(differences[0].changes.size(), 2u);
  EXPECT_EQ(differences[0].changes[0].material, 0);
  EXPECT_EQ(differences[0].changes[0].change, 1); // a cavity around it
  EXPECT_EQ(differences[0].changes[1].material, 1);
  EXPECT_EQ(differences[0].changes[1].change, 1);
}

TEST(TopologyDifferences, TellOfATunnelThatIsFilled)
{
  // a torus whose hole is narrower than a voxel's diagonal
  const Vector         centre(9.5, 9.5, 9.5);
  const auto           radius = [&](const Vector & x) { return std::hypot(x[0] - centre[0], x[1] - centre[1]); };
  const mmmtest::Scene scene(mmmtest::MakeMaterials({ { Size, Size, Size } }, Vector::Ones(), 2, [&](const Vector & x) {
    return std::hypot(radius(x) - 3.7, x[2] - centre[2]) < 2.9 ? 1 : 0;
  }));
  const mmm::SampleLattice lattice(*scene.indicators);
  const auto               samples = lattice.SamplePartition(0);
  ASSERT_EQ(mmm::ComputePartitionTopology(lattice, samples)[1], (mmm::BettiNumbers{ { 1, 1, 0 } }));
  const auto filled = Changed(
    lattice, samples, 1, [&](const Vector & x) { return std::hypot(x[0], x[1]) < 2.0 && std::abs(x[2]) < 0.6; });
  const auto differences = mmm::FindTopologyDifferences(lattice, samples, filled);
  ASSERT_EQ(differences.size(), 1u);
  const Vector at = FromCentre(lattice, lattice.SampleAt(differences[0].samples[0]));
  EXPECT_LT(std::hypot(at[0], at[1]), 2.0);
  EXPECT_LT(std::abs(at[2]), 0.6);
  ASSERT_EQ(differences[0].changes.size(), 2u);
  EXPECT_EQ(differences[0].changes[0].change, 1);
  EXPECT_EQ(differences[0].changes[1].change, 1);
}

TEST(TopologyDifferences, AddUpToThatOfTheCharacteristics)
{
  const auto               scene = MakeBall();
  const mmm::SampleLattice lattice(*scene.indicators);
  const auto               samples = lattice.SamplePartition(0);
  for (int seed = 0; seed < 5; ++seed)
  {
    auto noise = samples;
    for (std::size_t place = 0; place < noise.size(); ++place)
    {
      noise[place] = mmm::Hash(place + 1000003 * seed) % 5 == 0 ? 1 - noise[place] : noise[place];
    }
    std::ptrdiff_t sums[2] = { 0, 0 };
    for (const auto & difference : mmm::FindTopologyDifferences(lattice, samples, noise))
    {
      for (const auto & change : difference.changes)
      {
        sums[change.material] += change.change;
      }
    }
    const auto wanted = mmm::ComputePartitionTopology(lattice, samples);
    const auto actual = mmm::ComputePartitionTopology(lattice, noise);
    for (int m = 0; m < 2; ++m)
    {
      EXPECT_NE(sums[m], 0);
      EXPECT_EQ(sums[m], CharacteristicOf(actual[m]) - CharacteristicOf(wanted[m]));
    }
  }
}

TEST(SampleLattice, MeshOfTheWholeBoxIsOfItsMaterial)
{
  const auto               scene = MakeBall();
  const mmm::SampleLattice lattice(*scene.indicators);
  const double             far = 100.0;
  mmm::TetrahedralMesh     mesh;
  mesh.tetrahedra = { { { 0, 1, 2, 3 } } };
  mesh.materials = { 1 };
  std::vector<Vector> points{
    { -far, -far, -far }, { 3 * far, -far, -far }, { -far, 3 * far, -far }, { -far, -far, 3 * far }
  };
  if (mmm::TetrahedronVolume(points[0], points[1], points[2], points[3]) < 0.0)
  {
    std::swap(points[0], points[1]);
  }
  const auto samples = lattice.SampleMesh(points, mesh, 0, lattice.SamplePartition(0));
  for (const auto m : samples)
  {
    EXPECT_EQ(m, 1);
  }
  // without any tetrahedron, all is exterior
  for (const auto m : lattice.SampleMesh(points, mmm::TetrahedralMesh(), 0, lattice.SamplePartition(0)))
  {
    EXPECT_EQ(m, 0);
  }
}

TEST(TopologyComparison, ExplainsAPartThatTheMeshLacks)
{
  const mmmtest::Scene scene(mmmtest::MakeBallMaterials(Size, Vector::Constant(0.5 * (Size - 1)), 2.0));
  // without a tetrahedron, the ball is missing
  const auto report = mmm::CompareTopology(*scene.indicators, {}, mmm::TetrahedralMesh(), 0, 4);
  ASSERT_EQ(report.labels.size(), 1u);
  EXPECT_EQ(report.labels[0].label, 1);
  EXPECT_EQ(report.labels[0].mesh, (mmm::BettiNumbers{ { 0, 0, 0 } }));
  EXPECT_EQ(report.labels[0].partition, (mmm::BettiNumbers{ { 1, 0, 0 } }));
  EXPECT_EQ(report.labels[0].unexplained, 0);
  ASSERT_EQ(report.differences.size(), 1u);
  const mmm::TopologyPlace & place = report.differences[0];
  ASSERT_EQ(place.place.labels, (std::vector<int>{ 0, 1 }));
  EXPECT_EQ(place.changes, (std::vector<std::ptrdiff_t>{ -1, -1 }));
  EXPECT_LT((place.place.position - Vector::Constant(0.5 * (Size - 1))).norm(), 2.0);
}
