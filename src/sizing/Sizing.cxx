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
#include "sizing/Sizing.h"

#include "sizing/LocalFeatureSize.h"
#include "sizing/MedialAxis.h"
#include "base/Parallel.h"
#include "sizing/SourcePropagation.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
constexpr std::size_t Grain = 4096;
} // namespace

double
LargestCurvature(const IndicatorSet & indicators, const InterfaceSample & sample)
{
  if (indicators.IsPlane(sample.second))
  {
    return 0.0;
  }
  const Cell      cell{ sample.first, sample.second };
  const Vector    tangents[2] = { sample.normal.unitOrthogonal(), sample.normal.cross(sample.normal.unitOrthogonal()) };
  Eigen::Matrix2d shape;
  for (int j = 0; j < 2; ++j)
  {
    const Vector change = 0.5 * (indicators.Normal(cell, sample.position + tangents[j]) -
                                 indicators.Normal(cell, sample.position - tangents[j]));
    shape(0, j) = tangents[0].dot(change);
    shape(1, j) = tangents[1].dot(change);
  }
  const double mean = 0.5 * (shape(0, 0) + shape(1, 1));
  const double skew = 0.5 * (shape(0, 1) + shape(1, 0));
  const double difference = 0.5 * (shape(0, 0) - shape(1, 1));
  return std::abs(mean) + std::hypot(difference, skew);
}

double
DefaultMaximumSize(const IndicatorSet & indicators, int exterior)
{
  const auto & materials = indicators.NodeMaterials();
  const auto   isMeshed = [=](Material m) { return int(m) != exterior; };
  const double voxels = double(std::count_if(materials.begin(), materials.end(), isMeshed));
  const double volume = voxels * indicators.GetGrid().spacing.prod();
  return std::max(DefaultMaximumParameters::LeastVoxels, std::cbrt(volume) / DefaultMaximumParameters::EdgesAcross);
}

std::vector<float>
ComputeSizing(const IndicatorSet &     indicators,
              int                      exterior,
              const SizingParameters & parameters,
              const SizingControl &    control,
              Monitor &                monitor)
{
  const Grid & grid = indicators.GetGrid();
  const auto   samples = CollectInterfaceSamples(indicators, exterior);
  monitor.Report(0.1);
  const auto axis = ComputeMedialAxis(indicators, samples);
  monitor.Report(0.5);
  const auto featureSizes = ComputeLocalFeatureSizes(grid, samples, axis);
  monitor.Report(0.7);

  SizingParameters bounds = parameters;
  if (std::isnan(bounds.maximumSize))
  {
    // who gives an image of sizes means them
    bounds.maximumSize = control.imageReplaces ? SizingParameters().maximumSize
                                               : std::max(DefaultMaximumSize(indicators, exterior), bounds.minimumSize);
  }
  const SizeRules     rules(indicators, bounds, control);
  std::vector<Source> sources(samples.size());
  ParallelFor(samples.size(), Grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s)
    {
      const double curvature = std::max(1e-6, LargestCurvature(indicators, samples[s]));
      const double size =
        std::min(parameters.epsilon * featureSizes[s], std::sqrt(8.0 * parameters.chordTolerance / curvature));
      sources[s].position = samples[s].position.cast<float>();
      sources[s].value = rules.AtInterface(samples[s], size);
    }
  });
  rules.CompleteSources(sources);
  monitor.Report(0.8);
  std::vector<float> sizing = PropagateSources(grid, sources, parameters.gradientLimit, rules.NodeSizes()).values;
  rules.LimitSizes(sizing);
  monitor.Report(1.0);
  return sizing;
}
} // namespace mmm
