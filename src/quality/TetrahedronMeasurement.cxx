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
#include "quality/TetrahedronMeasurement.h"

#include "base/ParallelCollect.h"
#include "base/Points.h"
#include "mesh/Incidence.h"
#include "quality/Distribution.h"

#include <algorithm>

namespace mmm
{
namespace
{
constexpr std::size_t ItemsPerRange = 16384;

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
} // namespace

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
  std::vector<std::vector<Part>>            parts(NumberOfRanges(count, ItemsPerRange));
  std::vector<std::vector<PoorTetrahedron>> poor(NumberOfRanges(count, ItemsPerRange));
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
} // namespace mmm
