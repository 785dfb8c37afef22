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
#include "quality/Distribution.h"
#include "mesh/Incidence.h"
#include "base/MakeUnique.h"
#include "mesh/MeshTopology.h"
#include "base/ParallelCollect.h"
#include "quality/TetrahedronMeasurement.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <unordered_map>
#include <unordered_set>

namespace mmm
{
namespace
{
constexpr std::size_t ItemsPerRange = 16384;
/** Beyond, squares of areas overflow. */
constexpr double LargestCoordinate = 1e50;

void
CheckInput(const std::vector<Vector> &      points,
           const std::vector<Tetrahedron> & tetrahedra,
           const std::vector<int> &         labels)
{
  std::ostringstream message;
  if (labels.size() != tetrahedra.size())
  {
    message << "There are " << tetrahedra.size() << " tetrahedra but " << labels.size() << " labels.";
    throw std::invalid_argument(message.str());
  }
  if (points.size() > std::numeric_limits<std::uint32_t>::max())
  {
    message << "There are " << points.size() << " points, too many for indices of 32 bits.";
    throw std::invalid_argument(message.str());
  }
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    if (!(points[p].cwiseAbs().array() < LargestCoordinate).all())
    {
      message << "Point " << p << " has a coordinate that is not finite or too large.";
      throw std::invalid_argument(message.str());
    }
  }
  for (std::size_t t = 0; t < tetrahedra.size(); ++t)
  {
    for (const auto p : tetrahedra[t])
    {
      if (p >= points.size())
      {
        message << "Tetrahedron " << t << " has the point " << p << ", but there are " << points.size() << " points.";
        throw std::invalid_argument(message.str());
      }
    }
  }
}

/** The labels present, ascending. */
std::vector<int>
DistinctLabels(const std::vector<int> & labels)
{
  std::unordered_set<int> seen;
  for (std::size_t t = 0; t < labels.size(); ++t)
  {
    if (t == 0 || labels[t] != labels[t - 1])
    {
      seen.insert(labels[t]);
    }
  }
  std::vector<int> distinct(seen.begin(), seen.end());
  std::sort(distinct.begin(), distinct.end());
  return distinct;
}

void
MeasureInterfaces(const std::vector<Vector> & points, const MeshTopology & topology, MeshQualityReport & report)
{
  std::vector<std::uint32_t> triangles;
  triangles.reserve(topology.boundaryFaces.size());
  for (std::size_t f = 0; f < topology.boundaryFaces.size(); ++f)
  {
    if (topology.boundaryFaces[f].first)
    {
      triangles.push_back(std::uint32_t(f));
    }
  }
  std::vector<double> radiusRatios(triangles.size());
  ParallelFor(triangles.size(), ItemsPerRange, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      const auto & face = topology.boundaryFaces[triangles[i]].points;
      radiusRatios[i] = TriangleRadiusRatio(points[face[0]], points[face[1]], points[face[2]]);
    }
  });
  report.interfaceTriangles = triangles.size();
  report.interfaceRadiusRatio = Summarize(radiusRatios.data(), radiusRatios.data() + radiusRatios.size());
}

/** Tells for each tetrahedron listed which labels and interfaces it touches. */
void
LocatePoorTetrahedra(const MeshTopology &             topology,
                     const std::vector<Tetrahedron> & tetrahedra,
                     const std::vector<int> &         labels,
                     MeshQualityReport &              report)
{
  std::unordered_map<std::size_t, PoorTetrahedron *> listed;
  for (auto & tetrahedron : report.poorest)
  {
    listed[tetrahedron.index] = &tetrahedron;
  }
  if (listed.empty())
  {
    return;
  }
  std::vector<char> isOnInterface(report.points, 0);
  for (const auto & face : topology.boundaryFaces)
  {
    for (const auto p : face.points)
    {
      isOnInterface[p] = 1;
    }
    const auto found = listed.find(face.tetrahedron);
    if (found != listed.end())
    {
      ++found->second->boundaryFaces;
      if (face.neighbor != NoTetrahedron)
      {
        found->second->neighborLabels.push_back(labels[face.neighbor]);
      }
    }
  }
  for (auto & tetrahedron : report.poorest)
  {
    auto & neighbors = tetrahedron.neighborLabels;
    MakeUnique(neighbors);
    for (const auto p : tetrahedra[tetrahedron.index])
    {
      tetrahedron.boundaryCorners += isOnInterface[p];
    }
  }
}

std::size_t
CountUnusedPoints(std::size_t numberOfPoints, const std::vector<Tetrahedron> & tetrahedra)
{
  std::vector<char> used(numberOfPoints, 0);
  for (const auto & tetrahedron : tetrahedra)
  {
    for (const auto p : tetrahedron)
    {
      used[p] = 1;
    }
  }
  return std::count(used.begin(), used.end(), 0);
}

std::size_t
CountDuplicatePoints(const std::vector<Vector> & points, double tolerance)
{
  using Coordinates = std::array<double, 3>;
  const auto rounded = [&](std::size_t p) {
    Coordinates result;
    for (int a = 0; a < 3; ++a)
    {
      // 0 is added because -0 is to become 0
      result[a] = (tolerance > 0.0 ? std::nearbyint(points[p][a] / tolerance) : points[p][a]) + 0.0;
    }
    return result;
  };
  const auto hash = [&](std::size_t p) -> std::array<std::size_t, 1> {
    std::uint64_t mixed = 0;
    for (const double coordinate : rounded(p))
    {
      std::uint64_t bits;
      std::memcpy(&bits, &coordinate, sizeof(bits));
      mixed = (mixed ^ bits) * 0x9e3779b97f4a7c15u;
      mixed ^= mixed >> 32;
    }
    return { { std::size_t(mixed % points.size()) } };
  };
  const Incidence buckets(points.size(), points.size(), hash);
  return ParallelCount(points.size(), ItemsPerRange, [&](std::size_t b) {
    std::vector<Coordinates> bucket;
    for (auto p = buckets.Begin(b); p != buckets.End(b); ++p)
    {
      bucket.push_back(rounded(*p));
    }
    std::sort(bucket.begin(), bucket.end());
    return std::size_t(bucket.end() - std::unique(bucket.begin(), bucket.end()));
  });
}
} // namespace

MeshQualityReport
ComputeMeshQuality(const std::vector<Vector> &      points,
                   const std::vector<Tetrahedron> & tetrahedra,
                   const std::vector<int> &         labels,
                   const MeshQualityOptions &       options)
{
  CheckInput(points, tetrahedra, labels);
  const auto                 distinct = DistinctLabels(labels);
  std::vector<std::uint32_t> regions(labels.size());
  ParallelFor(labels.size(), ItemsPerRange, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
    {
      regions[t] = std::uint32_t(std::lower_bound(distinct.begin(), distinct.end(), labels[t]) - distinct.begin());
    }
  });

  MeshQualityReport report;
  report.points = points.size();
  report.hasBettiNumbers = options.computeBettiNumbers;
  report.labels.resize(distinct.size());
  for (std::size_t region = 0; region < distinct.size(); ++region)
  {
    report.labels[region].label = distinct[region];
  }
  report.unusedPoints = CountUnusedPoints(points.size(), tetrahedra);
  report.duplicatePoints = CountDuplicatePoints(points, options.duplicateTolerance);
  MeasureTetrahedra(points, tetrahedra, regions, options, report);

  const auto topology = ComputeMeshTopology(points, tetrahedra, regions, distinct.size(), options.computeBettiNumbers);
  MeasureInterfaces(points, topology, report);
  LocatePoorTetrahedra(topology, tetrahedra, labels, report);
  report.overusedFaces = topology.overusedFaces;
  for (std::size_t region = 0; region < distinct.size(); ++region)
  {
    auto &       label = report.labels[region];
    const auto & found = topology.regions[region];
    label.components = found.components;
    label.boundaryFaces = found.boundaryFaces;
    label.openEdges = found.openEdges;
    label.nonManifoldEdges = found.nonManifoldEdges;
    label.betti = found.betti;
    report.openEdges += found.openEdges;
    report.nonManifoldEdges += found.nonManifoldEdges;
  }
  return report;
}
} // namespace mmm
