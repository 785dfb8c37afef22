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
#include "surface/Sampling.h"

#include "base/MakeUnique.h"
#include "base/Parallel.h"
#include "surface/SurfaceParameters.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace mmm
{
namespace
{
constexpr std::size_t Grain = 1024;
constexpr double      Reach = ResidualParameters::Reach;

/** The value that this share of the others is below; reorders them. There has to be one. */
float
Quantile(std::vector<float> & values, double share)
{
  const auto place = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

std::vector<std::pair<PointId, PointId>>
EdgesOf(const std::vector<Triangle> & triangles)
{
  std::vector<std::pair<PointId, PointId>> edges;
  edges.reserve(3 * triangles.size());
  for (const auto & triangle : triangles)
  {
    for (int c = 0; c < 3; ++c)
    {
      edges.push_back(std::minmax(triangle[c], triangle[(c + 1) % 3]));
    }
  }
  MakeUnique(edges);
  return edges;
}

ResidualReport
MeasureResidual(const IndicatorSet & indicators, const ParticleSet & particles, int dimension)
{
  std::vector<float> distances;
  std::vector<float> all(particles.Size(), -1.0f);
  ParallelFor(all.size(), Grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
    {
      if (particles.CellOf(p).Dimension() == dimension)
      {
        Vector     x = particles.positions[p];
        const bool found = indicators.Project(particles.CellOf(p), x, Reach);
        all[p] = found ? float((x - particles.positions[p]).norm()) : float(Reach);
      }
    }
  });
  std::copy_if(all.begin(), all.end(), std::back_inserter(distances), [](float distance) { return distance >= 0.0f; });
  ResidualReport report;
  if (!distances.empty())
  {
    report.maximum = *std::max_element(distances.begin(), distances.end());
    report.percentile99 = Quantile(distances, 0.99);
    const auto hasLeft = [](float distance) { return distance > ResidualReport::Largest; };
    report.leftShare = double(std::count_if(distances.begin(), distances.end(), hasLeft)) / double(distances.size());
  }
  return report;
}
} // namespace

SamplingReport
MeasureSampling(const SizingField & sizing, const InterfaceMesh & interfaces, const std::vector<Vector> & points)
{
  SamplingReport     report;
  const auto         edges = EdgesOf(interfaces.triangles);
  std::vector<float> spacings(edges.size());
  ParallelFor(edges.size(), Grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e)
    {
      const Vector & a = points[edges[e].first];
      const Vector & b = points[edges[e].second];
      spacings[e] = float((b - a).norm() / sizing(0.5 * (a + b)));
    }
  });
  if (!spacings.empty())
  {
    const auto isNear = [](float spacing) {
      return spacing >= SamplingReport::LeastNear && spacing <= SamplingReport::MostNear;
    };
    report.nearShare = double(std::count_if(spacings.begin(), spacings.end(), isNear)) / double(spacings.size());
    report.medianSpacing = Quantile(spacings, 0.5);
    report.percentile1Spacing = Quantile(spacings, 0.01);
    report.percentile99Spacing = Quantile(spacings, 0.99);
  }
  return report;
}

ResidualReports
MeasureResiduals(const IndicatorSet & indicators, const ParticleSet & particles)
{
  ResidualReports reports;
  for (int dimension = 1; dimension <= 2; ++dimension)
  {
    reports[dimension] = MeasureResidual(indicators, particles, dimension);
  }
  return reports;
}
} // namespace mmm
