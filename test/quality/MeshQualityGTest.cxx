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

#include "base/Points.h"
#include "mesh/MeshTopology.h"

#include "itkMath.h"
#include "itkMultiThreaderBase.h"

#include <gtest/gtest.h>

#include <functional>
#include <iomanip>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>

namespace
{
using mmm::Tetrahedron;
using mmm::Vector;

struct LabeledMesh
{
  std::vector<Vector>      points;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<int>         labels;

  mmm::MeshQualityReport
  Measure(bool computeBettiNumbers = true) const
  {
    mmm::MeshQualityOptions options;
    options.computeBettiNumbers = computeBettiNumbers;
    return mmm::ComputeMeshQuality(points, tetrahedra, labels, options);
  }
};

constexpr int Nothing = -1;

/** Unit voxels, each cut into six tetrahedra around the same diagonal, so that all faces match. Voxels of the label
 * Nothing are left out, with the points that only they have. */
LabeledMesh
MeshOfVoxels(int nx, int ny, int nz, const std::function<int(int, int, int)> & labelOf)
{
  LabeledMesh                                 mesh;
  std::map<std::array<int, 3>, std::uint32_t> indices;
  const auto                                  indexOf = [&](const std::array<int, 3> & node) {
    const auto found = indices.emplace(node, std::uint32_t(mesh.points.size()));
    if (found.second)
    {
      mesh.points.emplace_back(node[0], node[1], node[2]);
    }
    return found.first->second;
  };
  for (int k = 0; k < nz; ++k)
  {
    for (int j = 0; j < ny; ++j)
    {
      for (int i = 0; i < nx; ++i)
      {
        const int label = labelOf(i, j, k);
        if (label == Nothing)
        {
          continue;
        }
        std::array<int, 3> axes{ { 0, 1, 2 } };
        do
        {
          // along three edges of the voxel from one corner to the opposite one
          std::array<int, 3> node{ { i, j, k } };
          Tetrahedron        tetrahedron;
          tetrahedron[0] = indexOf(node);
          for (int step = 0; step < 3; ++step)
          {
            ++node[axes[step]];
            tetrahedron[step + 1] = indexOf(node);
          }
          const bool isEven = (axes[1] - axes[0] + 3) % 3 == 1;
          if (!isEven)
          {
            std::swap(tetrahedron[1], tetrahedron[2]);
          }
          mesh.tetrahedra.push_back(tetrahedron);
          mesh.labels.push_back(label);
        } while (std::next_permutation(axes.begin(), axes.end()));
      }
    }
  }
  return mesh;
}

void
Jitter(LabeledMesh & mesh, double amplitude)
{
  std::mt19937                           generator(11);
  std::uniform_real_distribution<double> offset(-amplitude, amplitude);
  for (auto & point : mesh.points)
  {
    point += Vector(offset(generator), offset(generator), offset(generator));
  }
}

/** A mesh with three labels, irregular shapes and some negative tetrahedra. */
LabeledMesh
IrregularMesh(int size)
{
  auto mesh = MeshOfVoxels(size, size, size, [](int i, int j, int k) { return 5 * ((i / 3 + j / 4 + k / 5) % 3); });
  Jitter(mesh, 0.35);
  return mesh;
}

/** Tetrahedra of random shape, not connected with each other. */
LabeledMesh
LooseTetrahedra(std::size_t count)
{
  LabeledMesh                            mesh;
  std::mt19937                           generator(3);
  std::uniform_real_distribution<double> coordinate(0.0, 1.0);
  for (std::uint32_t t = 0; t < count; ++t)
  {
    for (int i = 0; i < 4; ++i)
    {
      mesh.points.emplace_back(coordinate(generator) + 2.0 * t, coordinate(generator), coordinate(generator));
    }
    mesh.tetrahedra.push_back({ { 4 * t, 4 * t + 1, 4 * t + 2, 4 * t + 3 } });
    mesh.labels.push_back(t % 7 == 0 ? -2 : 40);
  }
  return mesh;
}

using Betti = std::array<std::ptrdiff_t, 3>;

std::size_t
RankModulo2(std::vector<std::vector<char>> rows)
{
  std::size_t rank = 0;
  if (rows.empty())
  {
    return rank;
  }
  for (std::size_t column = 0; column < rows[0].size() && rank < rows.size(); ++column)
  {
    std::size_t pivot = rank;
    while (pivot < rows.size() && !rows[pivot][column])
    {
      ++pivot;
    }
    if (pivot == rows.size())
    {
      continue;
    }
    std::swap(rows[rank], rows[pivot]);
    for (std::size_t row = rank + 1; row < rows.size(); ++row)
    {
      if (rows[row][column])
      {
        for (std::size_t c = column; c < rows[row].size(); ++c)
        {
          rows[row][c] ^= rows[rank][c];
        }
      }
    }
    ++rank;
  }
  return rank;
}

/** The Betti numbers by definition, from the ranks of the boundary operators. */
Betti
HomologyOf(const LabeledMesh & mesh, int label)
{
  using Simplex = std::vector<std::uint32_t>;
  std::array<std::set<Simplex>, 4> simplices;
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
  {
    if (mesh.labels[t] == label)
    {
      for (unsigned int subset = 1; subset < 16; ++subset)
      {
        Simplex simplex;
        for (int i = 0; i < 4; ++i)
        {
          if (subset >> i & 1)
          {
            simplex.push_back(mesh.tetrahedra[t][i]);
          }
        }
        std::sort(simplex.begin(), simplex.end());
        simplices[simplex.size() - 1].insert(simplex);
      }
    }
  }
  std::array<std::size_t, 5> rank{ {} };
  for (int dimension = 1; dimension < 4; ++dimension)
  {
    std::vector<std::vector<char>> boundary;
    for (const auto & simplex : simplices[dimension])
    {
      std::vector<char> row(simplices[dimension - 1].size(), 0);
      for (std::size_t left = 0; left < simplex.size(); ++left)
      {
        Simplex face = simplex;
        face.erase(face.begin() + left);
        row[std::distance(simplices[dimension - 1].begin(), simplices[dimension - 1].find(face))] = 1;
      }
      boundary.push_back(row);
    }
    rank[dimension] = RankModulo2(boundary);
  }
  Betti betti;
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    betti[dimension] = std::ptrdiff_t(simplices[dimension].size()) - std::ptrdiff_t(rank[dimension]) -
                       std::ptrdiff_t(rank[dimension + 1]);
  }
  return betti;
}

void
ExpectEqual(const mmm::Distribution & a, const mmm::Distribution & b)
{
  EXPECT_EQ(a.average, b.average);
  EXPECT_EQ(a.minimum, b.minimum);
  EXPECT_EQ(a.firstPercentile, b.firstPercentile);
}

void
ExpectEqual(const mmm::TetrahedronStatistics & a, const mmm::TetrahedronStatistics & b)
{
  EXPECT_EQ(a.count, b.count);
  EXPECT_EQ(a.volume, b.volume);
  EXPECT_EQ(a.nonPositive, b.nonPositive);
  ExpectEqual(a.radiusRatio, b.radiusRatio);
  ExpectEqual(a.smallestAngle, b.smallestAngle);
  EXPECT_EQ(a.largestAngle, b.largestAngle);
  EXPECT_EQ(a.below, b.below);
  EXPECT_EQ(a.above, b.above);
  EXPECT_EQ(a.radiusRatioHistogram, b.radiusRatioHistogram);
  EXPECT_EQ(a.dihedralAngleHistogram, b.dihedralAngleHistogram);
}

/** Everything, to the last bit. */
void
ExpectEqual(const mmm::MeshQualityReport & a, const mmm::MeshQualityReport & b)
{
  ExpectEqual(a.tetrahedra, b.tetrahedra);
  ASSERT_EQ(a.labels.size(), b.labels.size());
  for (std::size_t i = 0; i < a.labels.size(); ++i)
  {
    EXPECT_EQ(a.labels[i].label, b.labels[i].label);
    ExpectEqual(a.labels[i].tetrahedra, b.labels[i].tetrahedra);
    EXPECT_EQ(a.labels[i].components, b.labels[i].components);
    EXPECT_EQ(a.labels[i].boundaryFaces, b.labels[i].boundaryFaces);
    EXPECT_EQ(a.labels[i].openEdges, b.labels[i].openEdges);
    EXPECT_EQ(a.labels[i].nonManifoldEdges, b.labels[i].nonManifoldEdges);
    EXPECT_EQ(a.labels[i].betti, b.labels[i].betti);
  }
  EXPECT_EQ(a.interfaceTriangles, b.interfaceTriangles);
  ExpectEqual(a.interfaceRadiusRatio, b.interfaceRadiusRatio);
  EXPECT_EQ(a.unusedPoints, b.unusedPoints);
  EXPECT_EQ(a.duplicatePoints, b.duplicatePoints);
  EXPECT_EQ(a.overusedFaces, b.overusedFaces);
  EXPECT_EQ(a.poorTetrahedra, b.poorTetrahedra);
  ASSERT_EQ(a.poorest.size(), b.poorest.size());
  for (std::size_t i = 0; i < a.poorest.size(); ++i)
  {
    EXPECT_EQ(a.poorest[i].index, b.poorest[i].index);
    EXPECT_EQ(a.poorest[i].smallestAngle, b.poorest[i].smallestAngle);
    EXPECT_EQ(a.poorest[i].neighborLabels, b.poorest[i].neighborLabels);
    EXPECT_EQ(a.poorest[i].boundaryFaces, b.poorest[i].boundaryFaces);
  }
}
} // namespace

TEST(mmmMeshQuality, CubeOfTwoLabels)
{
  const auto mesh = MeshOfVoxels(2, 2, 2, [](int i, int, int) { return i == 0 ? 3 : 17; });
  const auto report = mesh.Measure();
  EXPECT_EQ(report.points, 27u);
  EXPECT_EQ(report.unusedPoints, 0u);
  EXPECT_EQ(report.duplicatePoints, 0u);
  EXPECT_EQ(report.overusedFaces, 0u);
  EXPECT_EQ(report.tetrahedra.count, 48u);
  EXPECT_EQ(report.tetrahedra.nonPositive, 0u);
  EXPECT_NEAR(report.tetrahedra.volume, 8.0, 1e-13);
  EXPECT_NEAR(report.tetrahedra.smallestAngle.minimum, 45.0, 1e-12);
  EXPECT_NEAR(report.tetrahedra.smallestAngle.average, 45.0, 1e-12);
  EXPECT_NEAR(report.tetrahedra.largestAngle, 90.0, 1e-12);
  EXPECT_EQ(report.poorTetrahedra, 0u);

  // 24 unit squares outside and 4 between the labels, of two triangles with two equal sides each
  EXPECT_EQ(report.interfaceTriangles, 56u);
  const double radiusRatio = 2.0 * (std::sqrt(2.0) - 1.0);
  EXPECT_NEAR(report.interfaceRadiusRatio.average, radiusRatio, 1e-13);
  EXPECT_NEAR(report.interfaceRadiusRatio.minimum, radiusRatio, 1e-13);
  EXPECT_NEAR(report.interfaceRadiusRatio.firstPercentile, radiusRatio, 1e-13);

  ASSERT_EQ(report.labels.size(), 2u);
  EXPECT_EQ(report.labels[0].label, 3);
  EXPECT_EQ(report.labels[1].label, 17);
  for (const auto & label : report.labels)
  {
    EXPECT_EQ(label.tetrahedra.count, 24u);
    EXPECT_NEAR(label.tetrahedra.volume, 4.0, 1e-13);
    EXPECT_EQ(label.components, 1u);
    EXPECT_EQ(label.boundaryFaces, 32u);
    EXPECT_EQ(label.openEdges, 0u);
    EXPECT_EQ(label.nonManifoldEdges, 0u);
    EXPECT_EQ(label.betti, (Betti{ { 1, 0, 0 } }));
  }
}

TEST(mmmMeshQuality, CubeOfFiveTetrahedra)
{
  LabeledMesh mesh;
  for (int corner = 0; corner < 8; ++corner)
  {
    mesh.points.emplace_back(corner & 1, corner >> 1 & 1, corner >> 2);
  }
  mesh.tetrahedra = {
    { { 0, 3, 5, 6 } }, { { 1, 0, 3, 5 } }, { { 2, 3, 0, 6 } }, { { 4, 5, 6, 0 } }, { { 7, 6, 5, 3 } }
  };
  mesh.labels = { 1, 2, 2, 2, 2 };
  for (auto & t : mesh.tetrahedra)
  {
    if (mmm::TetrahedronVolume(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]) < 0.0)
    {
      std::swap(t[0], t[1]);
    }
  }
  const auto report = mesh.Measure();
  ASSERT_EQ(report.labels.size(), 2u);
  // the regular tetrahedron inside
  const auto & inside = report.labels[0];
  EXPECT_NEAR(inside.tetrahedra.volume, 1.0 / 3.0, 1e-14);
  EXPECT_NEAR(inside.tetrahedra.radiusRatio.minimum, 1.0, 1e-14);
  EXPECT_EQ(inside.tetrahedra.radiusRatioHistogram.back(), 1u);
  EXPECT_EQ(inside.tetrahedra.dihedralAngleHistogram[7], 6u);
  EXPECT_EQ(inside.boundaryFaces, 4u);
  EXPECT_EQ(inside.betti, (Betti{ { 1, 0, 0 } }));
  // and the four corners, two of which meet at each edge of it: a ring around each of its faces
  const auto & corners = report.labels[1];
  EXPECT_NEAR(corners.tetrahedra.volume, 2.0 / 3.0, 1e-14);
  EXPECT_NEAR(corners.tetrahedra.radiusRatio.average, std::sqrt(3.0) - 1.0, 1e-14);
  EXPECT_EQ(corners.tetrahedra.radiusRatioHistogram[14], 4u);
  EXPECT_EQ(corners.tetrahedra.dihedralAngleHistogram[5], 12u);
  EXPECT_EQ(corners.components, 4u);
  EXPECT_EQ(corners.nonManifoldEdges, 6u);
  EXPECT_EQ(corners.openEdges, 0u);
  EXPECT_EQ(corners.betti, (Betti{ { 1, 0, 1 } }));
  EXPECT_EQ(report.interfaceTriangles, 16u);
}

TEST(mmmMeshQuality, BettiNumbersOfVoxelShapes)
{
  const auto bettiOf = [](const LabeledMesh & mesh, int label) {
    for (const auto & quality : mesh.Measure().labels)
    {
      if (quality.label == label)
      {
        return quality.betti;
      }
    }
    return Betti{ { -1, -1, -1 } };
  };
  const auto isMiddle = [](int i) { return i == 1; };

  const auto torus = MeshOfVoxels(3, 3, 1, [&](int i, int j, int) { return isMiddle(i) && isMiddle(j) ? Nothing : 1; });
  EXPECT_EQ(bettiOf(torus, 1), (Betti{ { 1, 1, 0 } }));

  const auto filled = MeshOfVoxels(3, 3, 1, [&](int i, int j, int) { return isMiddle(i) && isMiddle(j) ? 2 : 1; });
  EXPECT_EQ(bettiOf(filled, 1), (Betti{ { 1, 1, 0 } }));
  EXPECT_EQ(bettiOf(filled, 2), (Betti{ { 1, 0, 0 } }));

  for (const int content : { Nothing, 2 })
  {
    const auto box = MeshOfVoxels(
      3, 3, 3, [&](int i, int j, int k) { return isMiddle(i) && isMiddle(j) && isMiddle(k) ? content : 1; });
    EXPECT_EQ(bettiOf(box, 1), (Betti{ { 1, 0, 1 } }));
    EXPECT_EQ(box.Measure().labels[0].components, 1u);
  }

  // the frame of a cube: a graph of 8 nodes and 12 edges
  const auto frame =
    MeshOfVoxels(3, 3, 3, [&](int i, int j, int k) { return isMiddle(i) + isMiddle(j) + isMiddle(k) >= 2 ? 2 : 1; });
  EXPECT_EQ(bettiOf(frame, 1), (Betti{ { 1, 5, 0 } }));

  // a part inside the cavity of another one
  const auto shells = MeshOfVoxels(5, 5, 5, [](int i, int j, int k) {
    const int depth = std::min({ i, j, k, 4 - i, 4 - j, 4 - k });
    return depth == 1 ? 2 : 1;
  });
  EXPECT_EQ(bettiOf(shells, 1), (Betti{ { 2, 0, 1 } }));
  EXPECT_EQ(bettiOf(shells, 2), (Betti{ { 1, 0, 1 } }));
}

TEST(mmmMeshQuality, PartsThatTouch)
{
  // at an edge
  auto report = MeshOfVoxels(2, 2, 1, [](int i, int j, int) { return i == j ? 1 : 2; }).Measure();
  for (const auto & label : report.labels)
  {
    EXPECT_EQ(label.components, 2u);
    EXPECT_EQ(label.nonManifoldEdges, 1u);
    EXPECT_EQ(label.openEdges, 0u);
    EXPECT_EQ(label.betti, (Betti{ { 1, 0, 0 } }));
  }
  // at a point
  report = MeshOfVoxels(2, 2, 2, [](int i, int j, int k) { return i == j && j == k ? 1 : 2; }).Measure();
  EXPECT_EQ(report.labels[0].components, 2u);
  EXPECT_EQ(report.labels[0].nonManifoldEdges, 0u);
  EXPECT_EQ(report.labels[0].betti, (Betti{ { 1, 0, 0 } }));
  // the other six form a ring, but all of them have that point: it closes the hole
  EXPECT_EQ(report.labels[1].components, 1u);
  EXPECT_EQ(report.labels[1].betti, (Betti{ { 1, 0, 0 } }));
}

TEST(mmmMeshQuality, BettiNumbersAreThoseOfHomology)
{
  // random regions touch themselves at points and edges, three and more times as well
  std::mt19937 generator(5);
  for (int trial = 0; trial < 30; ++trial)
  {
    auto                               mesh = MeshOfVoxels(3, 3, 3, [](int, int, int) { return 0; });
    std::uniform_int_distribution<int> anyLabel(0, 1 + trial % 3);
    for (auto & label : mesh.labels)
    {
      label = anyLabel(generator);
    }
    for (const auto & quality : mesh.Measure().labels)
    {
      EXPECT_EQ(quality.betti, HomologyOf(mesh, quality.label)) << "trial " << trial << ", label " << quality.label;
      EXPECT_EQ(quality.openEdges, 0u);
    }
  }
}

TEST(mmmMeshQuality, StatisticsAreThoseOfTheSingleTetrahedra)
{
  const auto mesh = LooseTetrahedra(1234);
  const auto report = mesh.Measure();
  ASSERT_EQ(report.labels.size(), 2u);
  EXPECT_EQ(report.interfaceTriangles, 4 * mesh.tetrahedra.size());

  std::vector<std::pair<double, std::size_t>> badness;
  for (const int label : { -2, 40, 1000 })
  {
    const bool                  isWhole = label == 1000;
    std::vector<double>         radiusRatios;
    std::vector<double>         smallestAngles;
    std::vector<double>         largestAngles;
    std::array<std::size_t, 20> radiusRatioHistogram{ {} };
    std::array<std::size_t, 18> angleHistogram{ {} };
    double                      volume = 0.0;
    std::size_t                 nonPositive = 0;
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
    {
      if (!isWhole && mesh.labels[t] != label)
      {
        continue;
      }
      const auto & p = mesh.tetrahedra[t];
      const auto & a = mesh.points[p[0]];
      const auto & b = mesh.points[p[1]];
      const auto & c = mesh.points[p[2]];
      const auto & d = mesh.points[p[3]];
      volume += std::abs(mmm::TetrahedronVolume(a, b, c, d));
      nonPositive += mmm::TetrahedronVolume(a, b, c, d) <= 0.0;
      radiusRatios.push_back(mmm::TetrahedronRadiusRatio(a, b, c, d));
      const auto angles = mmm::DihedralAngles(a, b, c, d);
      smallestAngles.push_back(*std::min_element(angles.begin(), angles.end()));
      largestAngles.push_back(*std::max_element(angles.begin(), angles.end()));
      ++radiusRatioHistogram[int(radiusRatios.back() * 20.0)];
      for (const double angle : angles)
      {
        ++angleHistogram[int(angle / 10.0)];
      }
      if (isWhole && (smallestAngles.back() < 10.0 || largestAngles.back() > 165.0))
      {
        badness.emplace_back(std::min(smallestAngles.back(), 180.0 - largestAngles.back()), t);
      }
    }
    const auto & found = isWhole ? report.tetrahedra : report.labels[label == -2 ? 0 : 1].tetrahedra;
    const auto   percentile = [](std::vector<double> values) {
      std::sort(values.begin(), values.end());
      const double rank = 0.01 * double(values.size() - 1);
      const auto   below = std::size_t(rank);
      return values[below] + (rank - double(below)) * (values[below + 1] - values[below]);
    };
    const auto average = [](const std::vector<double> & values) {
      return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
    };
    EXPECT_EQ(found.count, radiusRatios.size());
    EXPECT_EQ(found.nonPositive, nonPositive);
    EXPECT_NEAR(found.volume, volume, 1e-11);
    EXPECT_NEAR(found.radiusRatio.average, average(radiusRatios), 1e-12);
    EXPECT_EQ(found.radiusRatio.minimum, *std::min_element(radiusRatios.begin(), radiusRatios.end()));
    EXPECT_NEAR(found.radiusRatio.firstPercentile, percentile(radiusRatios), 1e-12);
    EXPECT_NEAR(found.smallestAngle.average, average(smallestAngles), 1e-10);
    EXPECT_EQ(found.smallestAngle.minimum, *std::min_element(smallestAngles.begin(), smallestAngles.end()));
    EXPECT_NEAR(found.smallestAngle.firstPercentile, percentile(smallestAngles), 1e-12);
    EXPECT_EQ(found.largestAngle, *std::max_element(largestAngles.begin(), largestAngles.end()));
    EXPECT_EQ(found.radiusRatioHistogram, radiusRatioHistogram);
    EXPECT_EQ(found.dihedralAngleHistogram, angleHistogram);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(found.below[k],
                std::size_t(std::count_if(
                  smallestAngles.begin(), smallestAngles.end(), [k](double angle) { return angle < 5 + 5 * k; })));
      EXPECT_EQ(found.above[k],
                std::size_t(std::count_if(
                  largestAngles.begin(), largestAngles.end(), [k](double angle) { return angle > 165 + 5 * k; })));
      EXPECT_GT(found.below[k], 0u);
      EXPECT_GT(found.above[k], 0u);
    }
  }

  std::sort(badness.begin(), badness.end());
  EXPECT_EQ(report.poorTetrahedra, badness.size());
  ASSERT_EQ(report.poorest.size(), badness.size());
  mmm::MeshQualityOptions options;
  options.maximumListed = 10;
  const auto shortReport = mmm::ComputeMeshQuality(mesh.points, mesh.tetrahedra, mesh.labels, options);
  EXPECT_EQ(shortReport.poorTetrahedra, badness.size());
  ASSERT_EQ(shortReport.poorest.size(), 10u);
  for (std::size_t i = 0; i < badness.size(); ++i)
  {
    EXPECT_EQ(report.poorest[i].index, badness[i].second);
    if (i < 10)
    {
      EXPECT_EQ(shortReport.poorest[i].index, badness[i].second);
    }
  }
}

TEST(mmmMeshQuality, PoorTetrahedraTellWhereTheyAre)
{
  // a sliver on top of a tetrahedron of another label, and one more label on its side
  LabeledMesh mesh;
  mesh.points = { Vector(0, 0, 0),      Vector(1, 0, 0),        Vector(0, 1, 0),
                  Vector(0.3, 0.3, -1), Vector(0.3, 0.3, 0.02), Vector(1, 1, 1) };
  mesh.tetrahedra = { { { 0, 2, 1, 3 } }, { { 0, 1, 2, 4 } }, { { 1, 2, 4, 5 } } };
  mesh.labels = { 9, 4, 7 };
  mmm::MeshQualityOptions options;
  options.smallestAngle = 5.0;
  options.largestAngle = 178.0;
  const auto report = mmm::ComputeMeshQuality(mesh.points, mesh.tetrahedra, mesh.labels, options);
  ASSERT_EQ(report.poorest.size(), 1u);
  const auto & poor = report.poorest[0];
  EXPECT_EQ(poor.index, 1u);
  EXPECT_EQ(poor.label, 4);
  EXPECT_EQ(poor.neighborLabels, (std::vector<int>{ 7, 9 }));
  EXPECT_EQ(poor.boundaryFaces, 4);
  EXPECT_EQ(poor.boundaryCorners, 4);
  EXPECT_STREQ(mmm::ToString(poor.GetPlace()), "on an interface");
  EXPECT_NEAR((mmm::ToVector(poor.center) - Vector(0.325, 0.325, 0.005)).norm(), 0.0, 1e-14);
  EXPECT_NEAR(poor.smallestAngle, std::atan(0.02 / 0.3) * itk::Math::deg_per_rad, 1e-9);
  EXPECT_GT(poor.largestAngle, 165.0);
}

TEST(mmmMeshQuality, PoorTetrahedraTellHowTheyTouchInterfaces)
{
  const auto              mesh = IrregularMesh(8);
  mmm::MeshQualityOptions options;
  options.smallestAngle = 180.0;
  options.maximumListed = mesh.tetrahedra.size();
  const auto report = mmm::ComputeMeshQuality(mesh.points, mesh.tetrahedra, mesh.labels, options);
  ASSERT_EQ(report.poorest.size(), mesh.tetrahedra.size());
  std::map<std::array<std::uint32_t, 3>, std::multiset<int>> sides;
  const auto                                                 facesOf = [](const mmm::Tetrahedron & t) {
    std::array<std::array<std::uint32_t, 3>, 4> faces;
    for (int f = 0; f < 4; ++f)
    {
      faces[f] = { { t[(f + 1) % 4], t[(f + 2) % 4], t[(f + 3) % 4] } };
      std::sort(faces[f].begin(), faces[f].end());
    }
    return faces;
  };
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
  {
    for (const auto & face : facesOf(mesh.tetrahedra[t]))
    {
      sides[face].insert(mesh.labels[t]);
    }
  }
  std::set<std::uint32_t> onInterface;
  for (const auto & side : sides)
  {
    if (side.second.size() == 1 || *side.second.begin() != *side.second.rbegin())
    {
      onInterface.insert(side.first.begin(), side.first.end());
    }
  }
  std::set<std::string> places;
  for (const auto & poor : report.poorest)
  {
    const auto & corners = mesh.tetrahedra[poor.index];
    const auto   expected =
      std::count_if(corners.begin(), corners.end(), [&](auto p) { return onInterface.count(p) > 0; });
    ASSERT_EQ(poor.boundaryCorners, expected);
    const std::string place = mmm::ToString(poor.GetPlace());
    EXPECT_EQ(place == "interior", expected == 0);
    EXPECT_EQ(place == "beside an interface", expected > 0 && expected < 4);
    EXPECT_EQ(place == "across a thin layer", expected == 4 && poor.boundaryFaces == 0);
    places.insert(place);
  }
  EXPECT_GT(places.size(), 1u);
}

TEST(mmmMeshQuality, DoesNotDependOnTheNumberOfThreads)
{
  const auto mesh = IrregularMesh(24);
  const auto threads = itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads();
  itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(1);
  const auto expected = mesh.Measure();
  EXPECT_EQ(expected.tetrahedra.count, 6u * 24 * 24 * 24);
  for (const unsigned int number : { 2u, 5u })
  {
    itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(number);
    ExpectEqual(mesh.Measure(), expected);
  }
  itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(threads);
}

TEST(mmmMeshQuality, DoesNotDependOnNumbering)
{
  const auto                 mesh = IrregularMesh(8);
  auto                       shuffled = mesh;
  std::mt19937               generator(2);
  std::vector<std::uint32_t> place(mesh.points.size());
  std::iota(place.begin(), place.end(), 0u);
  std::shuffle(place.begin(), place.end(), generator);
  for (std::size_t p = 0; p < place.size(); ++p)
  {
    shuffled.points[place[p]] = mesh.points[p];
  }
  std::vector<std::uint32_t> order(mesh.tetrahedra.size());
  std::iota(order.begin(), order.end(), 0u);
  std::shuffle(order.begin(), order.end(), generator);
  for (std::size_t t = 0; t < order.size(); ++t)
  {
    shuffled.labels[t] = mesh.labels[order[t]];
    const auto & p = mesh.tetrahedra[order[t]];
    // an even permutation
    shuffled.tetrahedra[t] = { { place[p[2]], place[p[0]], place[p[1]], place[p[3]] } };
  }
  const auto a = mesh.Measure();
  const auto b = shuffled.Measure();
  EXPECT_EQ(a.interfaceTriangles, b.interfaceTriangles);
  EXPECT_NEAR(a.interfaceRadiusRatio.firstPercentile, b.interfaceRadiusRatio.firstPercentile, 1e-12);
  EXPECT_NEAR(a.tetrahedra.radiusRatio.average, b.tetrahedra.radiusRatio.average, 1e-12);
  EXPECT_EQ(a.nonManifoldEdges, b.nonManifoldEdges);
  ASSERT_EQ(a.labels.size(), b.labels.size());
  for (std::size_t i = 0; i < a.labels.size(); ++i)
  {
    EXPECT_EQ(a.labels[i].tetrahedra.nonPositive, b.labels[i].tetrahedra.nonPositive);
    EXPECT_EQ(a.labels[i].tetrahedra.below, b.labels[i].tetrahedra.below);
    EXPECT_EQ(a.labels[i].components, b.labels[i].components);
    EXPECT_EQ(a.labels[i].boundaryFaces, b.labels[i].boundaryFaces);
  }
  ASSERT_EQ(a.poorest.size(), b.poorest.size());
  for (std::size_t i = 0; i < a.poorest.size(); ++i)
  {
    EXPECT_NEAR(a.poorest[i].smallestAngle, b.poorest[i].smallestAngle, 1e-9);
  }
}

TEST(mmmMeshQuality, IsInvariantUnderSimilarities)
{
  const auto            mesh = IrregularMesh(8);
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(1.1, Vector(2, 1, -1).normalized()).toRotationMatrix();
  const double          scale = 0.37;
  auto                  moved = mesh;
  for (auto & point : moved.points)
  {
    point = scale * (rotation * point) + Vector(-90, 126, 72);
  }
  const auto a = mesh.Measure();
  const auto b = moved.Measure();
  EXPECT_NEAR(b.tetrahedra.volume / (scale * scale * scale), a.tetrahedra.volume, 1e-9);
  EXPECT_EQ(b.tetrahedra.nonPositive, a.tetrahedra.nonPositive);
  EXPECT_NEAR(b.tetrahedra.radiusRatio.average, a.tetrahedra.radiusRatio.average, 1e-10);
  EXPECT_NEAR(b.tetrahedra.radiusRatio.minimum, a.tetrahedra.radiusRatio.minimum, 1e-10);
  EXPECT_NEAR(b.tetrahedra.radiusRatio.firstPercentile, a.tetrahedra.radiusRatio.firstPercentile, 1e-10);
  EXPECT_NEAR(b.tetrahedra.smallestAngle.minimum, a.tetrahedra.smallestAngle.minimum, 1e-8);
  EXPECT_NEAR(b.tetrahedra.largestAngle, a.tetrahedra.largestAngle, 1e-8);
  EXPECT_EQ(b.tetrahedra.below, a.tetrahedra.below);
  EXPECT_EQ(b.tetrahedra.above, a.tetrahedra.above);
  EXPECT_EQ(b.tetrahedra.radiusRatioHistogram, a.tetrahedra.radiusRatioHistogram);
  EXPECT_EQ(b.tetrahedra.dihedralAngleHistogram, a.tetrahedra.dihedralAngleHistogram);
  EXPECT_EQ(b.interfaceTriangles, a.interfaceTriangles);
  EXPECT_NEAR(b.interfaceRadiusRatio.average, a.interfaceRadiusRatio.average, 1e-10);
  EXPECT_EQ(b.duplicatePoints, a.duplicatePoints);
}

TEST(mmmMeshQuality, CountsDefectsOfPoints)
{
  auto mesh = MeshOfVoxels(1, 1, 1, [](int, int, int) { return 1; });
  mesh.points.emplace_back(7, 7, 7);
  mesh.points.emplace_back(0.0, -0.0, 4e-10);
  mesh.points.emplace_back(0.0, 0.0, 4e-9);
  auto report = mesh.Measure();
  EXPECT_EQ(report.unusedPoints, 3u);
  EXPECT_EQ(report.duplicatePoints, 1u);

  mmm::MeshQualityOptions options;
  options.duplicateTolerance = 1e-7;
  report = mmm::ComputeMeshQuality(mesh.points, mesh.tetrahedra, mesh.labels, options);
  EXPECT_EQ(report.duplicatePoints, 2u);
  options.duplicateTolerance = 0.0;
  report = mmm::ComputeMeshQuality(mesh.points, mesh.tetrahedra, mesh.labels, options);
  EXPECT_EQ(report.duplicatePoints, 0u);
  mesh.points.back() = Vector(-0.0, 0.0, 0.0);
  report = mmm::ComputeMeshQuality(mesh.points, mesh.tetrahedra, mesh.labels, options);
  EXPECT_EQ(report.duplicatePoints, 1u);
}

TEST(mmmMeshQuality, CountsTetrahedraThatAreFlatOrTurnedOver)
{
  auto mesh = MeshOfVoxels(1, 1, 1, [](int, int, int) { return 1; });
  std::swap(mesh.tetrahedra[2][0], mesh.tetrahedra[2][3]);
  mesh.labels[2] = 2;
  auto report = mesh.Measure();
  EXPECT_EQ(report.tetrahedra.nonPositive, 1u);
  EXPECT_EQ(report.labels[0].tetrahedra.nonPositive, 0u);
  EXPECT_EQ(report.labels[1].tetrahedra.nonPositive, 1u);
  EXPECT_NEAR(report.tetrahedra.volume, 1.0, 1e-14);

  // the four corners of a square
  mesh = LabeledMesh();
  mesh.points = { Vector(0, 0, 0), Vector(1, 0, 0), Vector(1, 1, 0), Vector(0, 1, 0) };
  mesh.tetrahedra = { { { 0, 1, 2, 3 } } };
  mesh.labels = { 1 };
  report = mesh.Measure();
  EXPECT_EQ(report.tetrahedra.nonPositive, 1u);
  EXPECT_EQ(report.tetrahedra.radiusRatio.minimum, 0.0);
  EXPECT_EQ(report.tetrahedra.smallestAngle.minimum, 0.0);
  EXPECT_EQ(report.tetrahedra.largestAngle, 180.0);
  EXPECT_EQ(report.tetrahedra.dihedralAngleHistogram.front(), 4u);
  EXPECT_EQ(report.tetrahedra.dihedralAngleHistogram.back(), 2u);
}

TEST(mmmMeshQuality, CountsFacesWithThreeTetrahedraAndOpenEdges)
{
  LabeledMesh mesh;
  mesh.points = {
    Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1), Vector(0, 0, -1), Vector(1, 1, 1)
  };
  mesh.tetrahedra = { { { 0, 1, 2, 3 } }, { { 0, 2, 1, 4 } }, { { 0, 1, 2, 5 } } };
  mesh.labels = { 1, 1, 1 };
  auto report = mesh.Measure();
  EXPECT_EQ(report.overusedFaces, 1u);
  EXPECT_EQ(report.interfaceTriangles, 9u);
  EXPECT_EQ(report.openEdges, 3u);
  EXPECT_EQ(report.labels[0].components, 1u);

  mesh.labels = { 1, 1, 2 };
  report = mesh.Measure();
  EXPECT_EQ(report.overusedFaces, 1u);
  EXPECT_EQ(report.interfaceTriangles, 10u);
  EXPECT_EQ(report.labels[0].boundaryFaces, 7u);
  EXPECT_EQ(report.labels[0].openEdges, 3u);
  EXPECT_EQ(report.labels[1].boundaryFaces, 4u);
  EXPECT_EQ(report.labels[1].openEdges, 0u);
}

TEST(mmmMeshQuality, SurvivesTetrahedraThatUseAPointTwice)
{
  auto mesh = MeshOfVoxels(2, 2, 2, [](int i, int, int) { return i; });
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); t += 5)
  {
    mesh.tetrahedra[t][t % 4] = mesh.tetrahedra[t][(t + 1) % 4];
  }
  mesh.tetrahedra[1].fill(3);
  const auto report = mesh.Measure();
  EXPECT_EQ(report.tetrahedra.nonPositive, 11u);
  EXPECT_EQ(report.tetrahedra.smallestAngle.minimum, 0.0);

  mesh.tetrahedra = { { { 0, 0, 1, 2 } } };
  mesh.labels = { 1 };
  EXPECT_EQ(mesh.Measure().overusedFaces, 0u) << "a tetrahedron was counted twice at a point";
}

TEST(mmmMeshQuality, EmptyMeshGivesZeros)
{
  const auto report = LabeledMesh().Measure();
  EXPECT_EQ(report.tetrahedra.count, 0u);
  EXPECT_EQ(report.tetrahedra.radiusRatio.average, 0.0);
  EXPECT_EQ(report.interfaceTriangles, 0u);
  EXPECT_TRUE(report.labels.empty());
}

TEST(mmmMeshQuality, RejectsInvalidInputByName)
{
  const auto valid = MeshOfVoxels(1, 1, 1, [](int, int, int) { return 1; });
  const auto messageOf = [](const LabeledMesh & mesh) -> std::string {
    try
    {
      mesh.Measure();
    }
    catch (const std::invalid_argument & error)
    {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(messageOf(valid), "");

  auto mesh = valid;
  mesh.tetrahedra[4][1] = 8;
  EXPECT_EQ(messageOf(mesh), "Tetrahedron 4 has the point 8, but there are 8 points.");
  mesh = valid;
  mesh.labels.pop_back();
  EXPECT_EQ(messageOf(mesh), "There are 6 tetrahedra but 5 labels.");
  for (const double coordinate : { std::nan(""), std::numeric_limits<double>::infinity(), -1e200 })
  {
    mesh = valid;
    mesh.points[3][1] = coordinate;
    EXPECT_EQ(messageOf(mesh), "Point 3 has a coordinate that is not finite or too large.");
  }
}

TEST(mmmMeshQuality, PrintsALineForEachLabel)
{
  const auto         mesh = MeshOfVoxels(2, 1, 1, [](int i, int, int) { return i == 0 ? 11 : 2035; });
  std::ostringstream os;
  os << std::hex << std::setprecision(9) << mesh.Measure(false) << 255 << ' ' << 0.123456789;
  const std::string text = os.str();
  EXPECT_NE(text.find("\n     all        12           2 "), std::string::npos) << text;
  EXPECT_NE(text.find("\n      11         6           1 "), std::string::npos) << text;
  EXPECT_NE(text.find("\n    2035         6           1 "), std::string::npos) << text;
  EXPECT_EQ(text.find("b0 b1 b2"), std::string::npos) << text;
  EXPECT_NE(text.find("ff 0.123456789"), std::string::npos) << "the stream's format was not restored";

  os.str("");
  os << mesh.Measure(true);
  EXPECT_NE(os.str().find("b0 b1 b2"), std::string::npos);
  EXPECT_NE(os.str().find("  1 0 0\n"), std::string::npos);
}
