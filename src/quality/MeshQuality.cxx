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

#include "base/MakeUnique.h"
#include "base/Parallel.h"
#include "base/Points.h"
#include "mesh/Incidence.h"
#include "mesh/MeshTopology.h"
#include "quality/Distribution.h"

#include <cstring>
#include <iomanip>
#include <limits>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <unordered_map>
#include <unordered_set>

namespace mmm
{
namespace
{
constexpr std::size_t ItemsPerRange = 16384;

std::size_t
NumberOfRanges(std::size_t items)
{
  return (items + ItemsPerRange - 1) / ItemsPerRange;
}

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
    if (!(points[p].cwiseAbs().array() < 1e50).all())
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

/** Adds what can be added; the distributions are left alone. */
void
Add(TetrahedronStatistics & sum, const TetrahedronStatistics & part)
{
  sum.count += part.count;
  sum.volume += part.volume;
  sum.largestVolume = std::max(sum.largestVolume, part.largestVolume);
  sum.nonPositive += part.nonPositive;
  sum.largestAngle = std::max(sum.largestAngle, part.largestAngle);
  for (int i = 0; i < 3; ++i)
  {
    sum.below[i] += part.below[i];
    sum.above[i] += part.above[i];
  }
  for (int i = 0; i < TetrahedronStatistics::RadiusRatioBins; ++i)
  {
    sum.radiusRatioHistogram[i] += part.radiusRatioHistogram[i];
  }
  for (int i = 0; i < TetrahedronStatistics::DihedralAngleBins; ++i)
  {
    sum.dihedralAngleHistogram[i] += part.dihedralAngleHistogram[i];
  }
}

/** The last bin has the upper end as well. */
template <std::size_t VBins>
void
Count(std::array<std::size_t, VBins> & histogram, double fraction)
{
  ++histogram[fraction < 1.0 ? std::size_t(fraction * VBins) : VBins - 1];
}

double
Badness(const PoorTetrahedron & tetrahedron)
{
  return std::min(tetrahedron.smallestAngle, 180.0 - tetrahedron.largestAngle);
}

/** Tetrahedra by region: first the ones of region 0, ascending, and so on. */
Incidence
GroupByRegion(const std::vector<std::uint32_t> & regions, std::size_t numberOfRegions)
{
  return Incidence(
    numberOfRegions, regions.size(), [&](std::size_t t) -> std::array<std::uint32_t, 1> { return { { regions[t] } }; });
}

void
MeasureTetrahedra(const std::vector<Vector> &        points,
                  const std::vector<Tetrahedron> &   tetrahedra,
                  const std::vector<std::uint32_t> & regions,
                  const MeshQualityOptions &         options,
                  MeshQualityReport &                report)
{
  struct Part
  {
    std::uint32_t         region;
    TetrahedronStatistics statistics;
  };
  // grouped by region, so that a range meets few of them and their values stay together
  const Incidence                           groups = GroupByRegion(regions, report.labels.size());
  const std::uint32_t * const               order = groups.Begin(0);
  const std::size_t                         count = tetrahedra.size();
  std::vector<double>                       radiusRatios(count);
  std::vector<double>                       smallestAngles(count);
  std::vector<std::vector<Part>>            parts(NumberOfRanges(count));
  std::vector<std::vector<PoorTetrahedron>> poor(NumberOfRanges(count));
  ParallelFor(count, ItemsPerRange, [&](std::size_t begin, std::size_t end) {
    auto & rangeParts = parts[begin / ItemsPerRange];
    auto & rangePoor = poor[begin / ItemsPerRange];
    for (std::size_t i = begin; i < end; ++i)
    {
      const std::uint32_t t = order[i];
      if (rangeParts.empty() || rangeParts.back().region != regions[t])
      {
        rangeParts.push_back({ regions[t], {} });
      }
      auto &         part = rangeParts.back().statistics;
      const Vector & a = points[tetrahedra[t][0]];
      const Vector & b = points[tetrahedra[t][1]];
      const Vector & c = points[tetrahedra[t][2]];
      const Vector & d = points[tetrahedra[t][3]];
      const double   volume = TetrahedronVolume(a, b, c, d);
      const auto     angles = DihedralAngles(a, b, c, d);
      const double   smallest = *std::min_element(angles.begin(), angles.end());
      const double   largest = *std::max_element(angles.begin(), angles.end());
      radiusRatios[i] = TetrahedronRadiusRatio(a, b, c, d);
      smallestAngles[i] = smallest;

      ++part.count;
      part.volume += std::abs(volume);
      part.largestVolume = std::max(part.largestVolume, std::abs(volume));
      part.nonPositive += !(volume > 0.0);
      part.largestAngle = std::max(part.largestAngle, largest);
      for (int k = 0; k < 3; ++k)
      {
        part.below[k] += smallest < 5.0 * (k + 1);
        part.above[k] += largest > 165.0 + 5.0 * k;
      }
      Count(part.radiusRatioHistogram, radiusRatios[i]);
      for (const double angle : angles)
      {
        Count(part.dihedralAngleHistogram, angle / 180.0);
      }
      if (smallest < options.smallestAngle || largest > options.largestAngle)
      {
        PoorTetrahedron tetrahedron;
        tetrahedron.index = t;
        tetrahedron.label = report.labels[regions[t]].label;
        tetrahedron.center = ToPoint(0.25 * (a + b + c + d));
        tetrahedron.smallestAngle = smallest;
        tetrahedron.largestAngle = largest;
        rangePoor.push_back(tetrahedron);
      }
    }
  });

  for (const auto & range : parts)
  {
    for (const auto & part : range)
    {
      Add(report.labels[part.region].tetrahedra, part.statistics);
    }
  }
  ParallelFor(report.labels.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t region = begin; region < end; ++region)
    {
      auto &            statistics = report.labels[region].tetrahedra;
      const std::size_t first = groups.Begin(region) - order;
      const std::size_t last = groups.End(region) - order;
      statistics.radiusRatio = Summarize(radiusRatios.data() + first, radiusRatios.data() + last);
      statistics.smallestAngle = Summarize(smallestAngles.data() + first, smallestAngles.data() + last);
    }
  });
  auto & whole = report.tetrahedra;
  for (const auto & label : report.labels)
  {
    Add(whole, label.tetrahedra);
  }
  whole.radiusRatio = Summarize(radiusRatios.data(), radiusRatios.data() + count);
  whole.smallestAngle = Summarize(smallestAngles.data(), smallestAngles.data() + count);

  for (const auto & range : poor)
  {
    report.poorest.insert(report.poorest.end(), range.begin(), range.end());
  }
  report.poorTetrahedra = report.poorest.size();
  const auto listed = std::min(options.maximumListed, report.poorest.size());
  std::partial_sort(report.poorest.begin(),
                    report.poorest.begin() + listed,
                    report.poorest.end(),
                    [](const PoorTetrahedron & a, const PoorTetrahedron & b) {
                      return Badness(a) != Badness(b) ? Badness(a) < Badness(b) : a.index < b.index;
                    });
  report.poorest.resize(listed);
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
  const Incidence          buckets(points.size(), points.size(), hash);
  std::vector<std::size_t> duplicates(NumberOfRanges(points.size()), 0);
  ParallelFor(points.size(), ItemsPerRange, [&](std::size_t begin, std::size_t end) {
    std::vector<Coordinates> bucket;
    for (std::size_t b = begin; b < end; ++b)
    {
      bucket.clear();
      for (auto p = buckets.Begin(b); p != buckets.End(b); ++p)
      {
        bucket.push_back(rounded(*p));
      }
      std::sort(bucket.begin(), bucket.end());
      duplicates[begin / ItemsPerRange] += bucket.end() - std::unique(bucket.begin(), bucket.end());
    }
  });
  std::size_t count = 0;
  for (const auto range : duplicates)
  {
    count += range;
  }
  return count;
}

void
PrintRow(std::ostream & os, const std::string & name, const TetrahedronStatistics & statistics)
{
  os << std::setw(8) << name << std::setw(10) << statistics.count << std::setw(12) << statistics.volume;
  for (const auto * distribution : { &statistics.radiusRatio, &statistics.smallestAngle })
  {
    os << std::setw(11) << distribution->average << std::setw(11) << distribution->firstPercentile << std::setw(11)
       << distribution->minimum;
  }
  os << std::setw(9) << statistics.largestAngle;
  for (const auto & counts : { statistics.below, statistics.above })
  {
    for (const auto count : counts)
    {
      os << std::setw(8) << count;
    }
  }
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

const char *
ToString(PoorTetrahedron::Place place)
{
  switch (place)
  {
    case PoorTetrahedron::Place::Interior:
      return "interior";
    case PoorTetrahedron::Place::BesideInterface:
      return "beside an interface";
    case PoorTetrahedron::Place::AcrossLayer:
      return "across a thin layer";
    default:
      return "on an interface";
  }
}

std::ostream &
operator<<(std::ostream & os, const MeshQualityReport & report)
{
  const auto flags = os.flags();
  const auto precision = os.precision(4);
  os << std::dec << std::defaultfloat << std::right;
  os << "points: " << report.points << ", unused: " << report.unusedPoints << ", duplicates: " << report.duplicatePoints
     << '\n';
  os << "tetrahedra: " << report.tetrahedra.count << ", not positive: " << report.tetrahedra.nonPositive
     << ", faces with more than two: " << report.overusedFaces << '\n';
  os << "interface triangles: " << report.interfaceTriangles
     << ", radius ratio average: " << report.interfaceRadiusRatio.average
     << ", 1 %: " << report.interfaceRadiusRatio.firstPercentile << ", minimum: " << report.interfaceRadiusRatio.minimum
     << '\n';
  os << "edges of the labels' boundaries, open: " << report.openEdges << ", non-manifold: " << report.nonManifoldEdges
     << '\n';
  os << "   label     count      volume     RR avg     RR 1 %     RR min  angle avg  angle 1 %  angle min"
     << "  max       <5     <10     <15    >165    >170    >175   parts    open  non-mf"
     << (report.hasBettiNumbers ? "  b0 b1 b2\n" : "\n");
  PrintRow(os, "all", report.tetrahedra);
  os << '\n';
  for (const auto & label : report.labels)
  {
    PrintRow(os, std::to_string(label.label), label.tetrahedra);
    os << std::setw(8) << label.components << std::setw(8) << label.openEdges << std::setw(8) << label.nonManifoldEdges;
    if (report.hasBettiNumbers)
    {
      os << "  " << label.betti[0] << ' ' << label.betti[1] << ' ' << label.betti[2];
    }
    os << '\n';
  }
  os.flags(flags);
  os.precision(precision);
  return os;
}
} // namespace mmm
