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
#include "topology/TopologyDifferences.h"
#include "base/Hash.h"
#include "base/Points.h"
#include "topology/PartitionTopology.h"
#include "indicators/SampleNeighbours.h"
#include "support/TestScenes.h"
#include "support/TestTetrahedra.h"
#include "topology/TopologyComparison.h"

#include "gtest/gtest.h"

#include <cmath>
#include <functional>
#include <map>

using mmm::Index;
using mmm::Vector;

namespace
{
constexpr int Size = 16;
/** None of the materials. */
constexpr mmm::Material Exterior = 7;

const Vector &
Centre()
{
  static const Vector centre = Vector::Constant(0.5 * (Size - 1));
  return centre;
}

/** The tetrahedra of a Freudenthal subdivision between the nodes of a grid, with materials by a function of their
 * centres' distance to the middle. */
class Tetrahedra
{
public:
  template <typename TFunction>
  Tetrahedra(const mmm::Grid & grid, const TFunction & materialAt)
    : points(mmmtest::MakeNodes(grid))
  {
    mesh.tetrahedra = mmmtest::MakeFreudenthalTetrahedra(grid);
    for (const auto & c : mesh.tetrahedra)
    {
      const Vector x = 0.25 * (points[c[0]] + points[c[1]] + points[c[2]] + points[c[3]]) - Centre();
      mesh.materials.push_back(mmm::Material(materialAt(x)));
    }
  }

  mmm::TetrahedronAdjacency
  Adjacency() const
  {
    return { mesh.tetrahedra, points.size() };
  }

  std::vector<Vector>  points;
  mmm::TetrahedralMesh mesh;
};

mmm::TopologyDifferences
FindDifferences(const mmm::IndicatorSet & indicators, const Tetrahedra & tetrahedra, int samplesPerVoxel = 4)
{
  const mmm::SampleLattice lattice(indicators, samplesPerVoxel);
  const auto               partition = lattice.SamplePartition(Exterior);
  return mmm::TopologyDifferenceFinder(lattice, partition, Exterior)
    .Find(tetrahedra.points, tetrahedra.mesh, tetrahedra.Adjacency());
}

template <typename TFunction>
mmm::TopologyDifferences
FindDifferences(const mmm::IndicatorSet & indicators, const TFunction & materialAt)
{
  return FindDifferences(indicators, Tetrahedra(indicators.GetGrid(), materialAt));
}

using Changes = std::map<mmm::Material, std::ptrdiff_t>;

/** Those that are not zero. */
Changes
Sum(const std::vector<mmm::EulerChange> & changes)
{
  Changes sum;
  for (const auto & change : changes)
  {
    if (change.change != 0)
    {
      sum[change.material] += change.change;
    }
  }
  return sum;
}

/** Those of all places. */
Changes
Sum(const std::vector<mmm::TopologyDifference> & places)
{
  std::vector<mmm::EulerChange> changes;
  for (const auto & place : places)
  {
    changes.insert(changes.end(), place.changes.begin(), place.changes.end());
  }
  return Sum(changes);
}

constexpr double Radius = 4.3;

mmmtest::Scene
MakeBall()
{
  return mmmtest::Scene(mmmtest::MakeBallMaterials(Size, Centre(), Radius));
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
  EXPECT_FALSE(neighbours.IsDisk((1u << mmm::SampleNeighbours::Count) - 1));
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
  EXPECT_FALSE(neighbours.IsDisk(plane));
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

TEST(TopologyDifferences, AreNoneWhereASurfaceIsALittleOff)
{
  const auto scene = MakeBall();
  const auto same = FindDifferences(*scene.indicators, [](const Vector & x) { return x.norm() < Radius; });
  EXPECT_TRUE(same.places.empty());
  const auto larger = FindDifferences(*scene.indicators, [](const Vector & x) { return x.norm() < Radius + 0.3; });
  EXPECT_TRUE(larger.places.empty());
  EXPECT_TRUE(larger.cancelling.empty());
}

TEST(TopologyDifferences, TellOfAPartThatIsExtra)
{
  const auto   scene = MakeBall();
  const Vector extra(4.0, 4.0, 4.0);
  const auto   differences =
    FindDifferences(*scene.indicators, [&](const Vector & x) { return x.norm() < Radius || (x - extra).norm() < 1.2; });
  ASSERT_EQ(differences.places.size(), 1u);
  const auto & place = differences.places[0];
  EXPECT_EQ(Sum(place.changes), (Changes{ { 0, 1 }, { 1, 1 } })); // a cavity around it, and the part
  EXPECT_LT((place.position - Centre() - extra).norm(), 1.2);
}

TEST(TopologyDifferences, TellOfASheetAcrossAPart)
{
  const auto scene = MakeBall();
  const auto differences = FindDifferences(
    *scene.indicators, [&](const Vector & x) { return x.norm() < Radius && std::abs(x[2] - 1.0) > 0.5; });
  for (const auto & place : differences.places)
  {
    EXPECT_NEAR(place.position[2] - Centre()[2], 1.0, 0.8);
  }
  EXPECT_EQ(Sum(differences.places), (Changes{ { 0, 1 }, { 1, 1 } })); // two parts, in two cavities
}

TEST(TopologyDifferences, TellOfATunnelThatIsFilled)
{
  // a torus whose hole is narrower than a voxel's diagonal
  const auto               radius = [](const Vector & x) { return std::hypot(x[0], x[1]); };
  const auto               isTorus = [&](const Vector & x) { return std::hypot(radius(x) - 3.7, x[2]) < 2.9; };
  const mmmtest::Scene     scene(mmmtest::MakeMaterials(
    { { Size, Size, Size } }, Vector::Ones(), 2, [&](const Vector & x) { return isTorus(x - Centre()); }));
  const mmm::SampleLattice lattice(*scene.indicators, 4);
  ASSERT_EQ(mmm::ComputePartitionTopology(lattice, lattice.SamplePartition(Exterior))[1],
            (mmm::BettiNumbers{ { 1, 1, 0 } }));
  const auto differences = FindDifferences(
    *scene.indicators, [&](const Vector & x) { return isTorus(x) || (radius(x) < 3.0 && std::abs(x[2]) < 1.0); });
  ASSERT_EQ(differences.places.size(), 1u);
  const auto & place = differences.places[0];
  EXPECT_EQ(Sum(place.changes), (Changes{ { 0, 1 }, { 1, 1 } }));
  EXPECT_LT(radius(place.position - Centre()), 2.0);
  // around it are samples of both sides
  EXPECT_FALSE(place.samples.empty());
  for (const Index & sample : place.samples)
  {
    EXPECT_LT((lattice.Position(sample) - place.position).norm(), 4.0);
  }
}

TEST(TopologyDifferences, AddUpToThatOfTheCharacteristics)
{
  const auto               scene = MakeBall();
  const mmm::SampleLattice lattice(*scene.indicators);
  const auto               partition = lattice.SamplePartition(Exterior);
  const auto               wanted = mmm::ComputePartitionTopology(lattice, partition);
  for (int seed = 0; seed < 5; ++seed)
  {
    std::size_t      n = 1000003 * seed;
    const Tetrahedra noise(scene.image.grid, [&](const Vector & x) {
      const bool isNear = std::abs(x.norm() - Radius) < 0.7;
      return (x.norm() < Radius) != (isNear && mmm::Hash(++n) % 5 == 0);
    });
    auto             sum = Sum(mmm::TopologyDifferenceFinder(lattice, partition, Exterior)
                     .Find(noise.points, noise.mesh, noise.Adjacency())
                     .places);
    const auto       actual = mmm::ComputeMeshTopology(noise.points, noise.mesh, 2);
    for (mmm::Material m = 0; m < 2; ++m)
    {
      EXPECT_NE(sum[m], 0);
      EXPECT_EQ(sum[m], CharacteristicOf(actual.regions[m].betti) - CharacteristicOf(wanted[m]));
    }
  }
}

TEST(TopologyDifferences, AreTheSameInAMeshThatHasChangedAsInANewOne)
{
  const auto                    scene = MakeBall();
  const mmm::SampleLattice      lattice(*scene.indicators);
  const auto                    partition = lattice.SamplePartition(Exterior);
  mmm::TopologyDifferenceFinder finder(lattice, partition, Exterior);
  Tetrahedra                    mesh(scene.image.grid, [](const Vector & x) { return x.norm() < Radius; });
  const auto                    expectSame = [&](std::size_t places) {
    const auto again = finder.Find(mesh.points, mesh.mesh, mesh.Adjacency()).places;
    const auto anew = FindDifferences(*scene.indicators, mesh, 2).places;
    EXPECT_EQ(anew.size(), places);
    ASSERT_EQ(again.size(), anew.size());
    for (std::size_t n = 0; n < anew.size(); ++n)
    {
      EXPECT_EQ(again[n].position, anew[n].position);
      EXPECT_EQ(again[n].samples, anew[n].samples);
    }
    EXPECT_EQ(Sum(again), Sum(anew));
  };
  expectSame(0);
  expectSame(0); // nothing has changed
  const auto turn = [&mesh](std::size_t t) { mesh.mesh.materials[t] = mmm::Material(1 - mesh.mesh.materials[t]); };
  turn(0);
  turn(mesh.mesh.tetrahedra.size() / 2); // the middle
  expectSame(2);
  expectSame(2);
  turn(0);
  expectSame(1);

  // a point in the tetrahedron that is left
  const std::size_t t = mesh.mesh.tetrahedra.size() / 2;
  const auto        corners = mesh.mesh.tetrahedra[t];
  const auto        material = mesh.mesh.materials[t];
  Vector            middle = Vector::Zero();
  for (const auto c : corners)
  {
    middle += 0.25 * mesh.points[c];
  }
  for (int c = 0; c < 4; ++c)
  {
    mesh.mesh.tetrahedra.push_back(corners);
    mesh.mesh.tetrahedra.back()[c] = mmm::PointId(mesh.points.size());
    mesh.mesh.materials.push_back(material);
  }
  mesh.points.push_back(middle);
  mesh.mesh.tetrahedra.erase(mesh.mesh.tetrahedra.begin() + t);
  mesh.mesh.materials.erase(mesh.mesh.materials.begin() + t);
  expectSame(1);

  for (Vector & x : mesh.points) // which moves all of them
  {
    x = Centre() + 0.99 * (x - Centre());
  }
  expectSame(1);
}

/** Between 0 and 1, there is a sheet of 2, this thick in the middle, halfway between two samples; in the mesh, it has
 * no hole in any case. */
struct ThinSheetScene
{
  explicit ThinSheetScene(double thickness)
    : grid(MakeGrid())
    , indicators(grid, MakeIndicators(grid, thickness), -100.0)
    // the layer of tetrahedra in the middle becomes the sheet
    , tetrahedra(grid, [](const Vector & x) { return std::abs(x[2]) < 0.5 ? 2
                                                     : x[2] > 0.0         ? 0
                                                                          : 1; })
  {
    constexpr int Middle = Size / 2;
    for (Vector & x : tetrahedra.points)
    {
      const double middle = Centre()[2] + Height;
      const double half = std::max(0.001, HalfThickness(thickness, x - Centre()));
      x[2] = x[2] < Middle ? (middle - half) * x[2] / (Middle - 1)
                           : middle + half + (Size - 1 - middle - half) * (x[2] - Middle) / (Size - 1 - Middle);
    }
  }

  mmm::Grid         grid;
  mmm::IndicatorSet indicators;
  Tetrahedra        tetrahedra;

private:
  static constexpr double Height = 0.125;

  static double
  HalfThickness(double inTheMiddle, const Vector & x)
  {
    return 0.5 * inTheMiddle + 0.05 * (x[0] * x[0] + x[1] * x[1]);
  }

  static mmm::Grid
  MakeGrid()
  {
    mmm::Grid grid;
    grid.size = { { Size, Size, Size } };
    return grid;
  }

  static std::vector<mmm::IndicatorBricks>
  MakeIndicators(const mmm::Grid & grid, double thickness)
  {
    std::vector<mmm::IndicatorBricks> bricks;
    for (int m = 0; m < 3; ++m)
    {
      std::vector<float> values;
      for (std::size_t n = 0; n < grid.NumberOfNodes(); ++n)
      {
        const Vector x = grid.Position(grid.IndexAt(n)) - Centre();
        values.push_back(float(m == 0 ? x[2] - Height : m == 1 ? Height - x[2] : HalfThickness(thickness, x)));
      }
      bricks.emplace_back(grid, mmm::BlockView<const float>{ { { 0, 0, 0 } }, grid.size, values.data() }, -100.0f);
    }
    return bricks;
  }
};

class ThinSheet : public testing::TestWithParam<double>
{};

TEST_P(ThinSheet, IsNoDifference)
{
  const ThinSheetScene     scene(GetParam());
  const mmm::SampleLattice lattice(scene.indicators, 4);
  ASSERT_EQ(mmm::ComputePartitionTopology(lattice, lattice.SamplePartition(Exterior))[2],
            (mmm::BettiNumbers{ { 1, 1, 0 } })); // a hole
  const auto differences = FindDifferences(scene.indicators, scene.tetrahedra);
  EXPECT_TRUE(differences.places.empty());
  EXPECT_EQ(Sum(differences.betweenSamples), (Changes{ { 2, 1 } }));

  const auto & tetrahedra = scene.tetrahedra;
  const auto   report = mmm::TopologyComparison(scene.indicators, Exterior, 4)
                        .Compare(tetrahedra.points, tetrahedra.mesh, tetrahedra.Adjacency());
  EXPECT_EQ(report.labels[2].mesh, (mmm::BettiNumbers{ { 1, 0, 0 } }));
  EXPECT_EQ(report.labels[2].partition, (mmm::BettiNumbers{ { 1, 0, 0 } }));
  EXPECT_EQ(report.labels[2].unexplained, 0);
}

INSTANTIATE_TEST_SUITE_P(TopologyDifferences, ThinSheet, testing::Values(0.06, 0.002));

TEST(SampleLattice, FindsASheetBetweenTwoPlacesWhereverItIsBetweenThem)
{
  const ThinSheetScene     scene(0.0001);
  const mmm::SampleLattice lattice(scene.indicators, 4);
  const double             middle = 4 * Centre()[2];
  for (const double share : { 0.1, 0.3, 0.5, 0.9 })
  {
    const Vector below(middle, middle, middle + 0.5 - share);
    const Vector above = below + Vector::UnitZ();
    EXPECT_EQ(lattice.MaterialBetween(below, above, 1, 0), 2) << share;
    EXPECT_EQ(lattice.MaterialBetween(above, below, 0, 1), 2) << share;
  }
}

TEST(SampleLattice, FindsOneOfTwoMaterialsWhereNoSheetIsBetweenThem)
{
  const ThinSheetScene     scene(-0.1);
  const mmm::SampleLattice lattice(scene.indicators, 4);
  const double             middle = 4 * Centre()[2];
  EXPECT_LT(lattice.MaterialBetween(Vector::Constant(middle), Vector::Constant(middle + 1.0), 1, 0), 2);
}

TEST(SampleLattice, FindsTheMaterialAtTheBoxBetweenAPlaceWithinAndOneBeyond)
{
  const ThinSheetScene     scene(0.1);
  const mmm::SampleLattice lattice(scene.indicators, 4);
  const double             face = 4 * (Size - 0.5);
  // away from the middle the sheet is thick
  const Vector inSheet(face - 0.5, 2 * Size, 2 * Size);
  EXPECT_EQ(lattice.MaterialBetween(inSheet, inSheet + Vector::UnitX(), 2, Exterior), 2);
  EXPECT_EQ(lattice.MaterialBetween(inSheet + Vector::UnitX(), inSheet, Exterior, 2), 2);
}

TEST(TopologyDifferences, StayWhereAThinSheetHasAHole)
{
  // of a radius of 0.15, where samples are 0.25 apart
  const ThinSheetScene scene(-0.00225);
  const auto           differences = FindDifferences(scene.indicators, scene.tetrahedra);
  ASSERT_EQ(differences.places.size(), 1u);
  EXPECT_EQ(Sum(differences.places[0].changes), (Changes{ { 2, 1 } }));
}

TEST(TopologyComparison, IsCompleteWhereTheMeshIsFarOff)
{
  constexpr int  Large = 32;
  const Vector   shift = Vector::Constant(0.5 * (Large - Size)); // from the one middle to the other
  const auto     center = Vector::Constant(0.5 * (Large - 1));
  mmmtest::Scene scene(mmmtest::MakeBallMaterials(Large, center, 7.0));
  const auto     norm = [&](const Vector & x) { return (x - shift).norm(); };
  const auto     compare = [&](mmm::Material exterior, const std::function<bool(const Vector &)> & isInside) {
    Tetrahedra           all(scene.image.grid, isInside);
    mmm::TetrahedralMesh mesh;
    for (std::size_t t = 0; t < all.mesh.tetrahedra.size(); ++t)
    {
      if (all.mesh.materials[t] != exterior)
      {
        mesh.tetrahedra.push_back(all.mesh.tetrahedra[t]);
        mesh.materials.push_back(all.mesh.materials[t]);
      }
    }
    const auto report = mmm::TopologyComparison(*scene.indicators, exterior, 4)
                          .Compare(all.points, mesh, { mesh.tetrahedra, all.points.size() });
    for (const auto & label : report.labels)
    {
      EXPECT_EQ(label.unexplained, 0) << "exterior " << exterior << " label " << label.label;
    }
    return report;
  };
  for (const mmm::Material exterior : { mmm::Material(0), Exterior })
  {
    EXPECT_TRUE(compare(exterior, [&](const Vector & x) { return norm(x) < 7.0; }).differences.empty());
    EXPECT_TRUE(compare(exterior, [&](const Vector & x) { return norm(x) < 11.0; }).differences.empty());
    EXPECT_FALSE(compare(exterior, [](const Vector &) { return false; }).differences.empty());
    const Vector far = shift + Vector::Constant(7.0);
    EXPECT_FALSE(
      compare(exterior, [&](const Vector & x) { return norm(x) < 7.0 || (x - far).norm() < 1.5; }).differences.empty());
    EXPECT_FALSE(
      compare(exterior, [&](const Vector & x) { return norm(x) < 7.0 && norm(x) > 2.0; }).differences.empty());
  }
}

TEST(TopologyComparison, ExplainsAPartThatTheMeshLacks)
{
  const mmmtest::Scene scene(mmmtest::MakeBallMaterials(Size, Centre(), 2.0));
  // without a tetrahedron, the ball is missing
  const auto report = mmm::TopologyComparison(*scene.indicators, 0, 4).Compare({}, mmm::TetrahedralMesh(), { {}, 0 });
  ASSERT_EQ(report.labels.size(), 1u);
  EXPECT_EQ(report.labels[0].label, 1);
  EXPECT_EQ(report.labels[0].mesh, (mmm::BettiNumbers{ { 0, 0, 0 } }));
  EXPECT_EQ(report.labels[0].partition, (mmm::BettiNumbers{ { 1, 0, 0 } }));
  EXPECT_EQ(report.labels[0].unexplained, 0);
  ASSERT_EQ(report.differences.size(), 1u);
  const mmm::TopologyPlace & place = report.differences[0];
  ASSERT_EQ(place.place.labels, (std::vector<int>{ 1 }));
  EXPECT_EQ(place.changes, (std::vector<std::ptrdiff_t>{ -1 }));
  EXPECT_LT((mmm::ToVector(place.place.position) - Centre()).norm(), 2.0);
}
