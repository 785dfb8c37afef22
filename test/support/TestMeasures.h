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
#ifndef mmmTestMeasures_h
#define mmmTestMeasures_h

#include "sizing/LocalFeatureSize.h"
#include "sizing/MedialAxis.h"
#include "sizing/SourcePropagation.h"
#include "support/TestScenes.h"
#include "support/TestShapes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

/** How far indicators, feature sizes and propagated fields are from what they stand for. */
namespace mmmtest
{
/** The solid as material 1 in a cube of voxels of unit size. */
inline mmm::MaterialImage
Digitize(const Solid & solid, int size)
{
  return MakeMaterials(
    { { size, size, size } }, mmm::Vector::Ones(), 2, [&](const mmm::Vector & x) { return solid.Contains(x) ? 1 : 0; });
}

struct SurfaceErrors
{
  /** Root mean square distance between zero set and surface, in voxels. */
  double distance{ 0.0 };
  /** Volume within the zero set over that of the solid, minus one. */
  double volume{ 0.0 };
  /** Root mean square angle between the normals, in degrees. */
  double normal{ 0.0 };
};

/** Compares the zero set of a scene's two indicators with the surface of the solid that material 1 digitizes. */
inline SurfaceErrors
MeasureSurface(const mmm::IndicatorSet & indicators, const Solid & solid, int rays)
{
  const mmm::Cell interface{ 0, 1 };
  const auto      list = solid.Rays(rays);
  SurfaceErrors   errors;
  errors.volume = -1.0;
  for (const auto & ray : list)
  {
    double inside = std::max(0.0, ray.length - 2.0);
    double outside = ray.length + 2.0;
    for (int halving = 0; halving < 20; ++halving)
    {
      const double      middle = 0.5 * (inside + outside);
      const mmm::Vector x = ray.origin + middle * ray.direction;
      (indicators.Value(1, x) > indicators.Value(0, x) ? inside : outside) = middle;
    }
    const double      t = inside / ray.length;
    const mmm::Vector x = ray.origin + inside * ray.direction;
    errors.volume += ray.squareShare * t * t + ray.cubicShare * t * t * t;
    errors.distance += std::pow(solid.Distance(x), 2) / list.size();
    const double cosine = -indicators.Normal(interface, x).dot(solid.Normal(x));
    errors.normal += std::pow(std::acos(std::min(1.0, cosine)), 2) / list.size();
  }
  errors.distance = std::sqrt(errors.distance);
  errors.normal = std::sqrt(errors.normal) * 180.0 / EIGEN_PI;
  return errors;
}

/** Root mean square distance of the curve where three materials meet from the points given; those are on the true one,
 * which is straight in their neighbourhood or nearly so, in the direction given with them. Infinite where the curve is
 * not found. */
inline double
MeasureTripleCurve(const mmm::IndicatorSet &                                indicators,
                   const mmm::Cell &                                        cell,
                   const std::vector<std::pair<mmm::Vector, mmm::Vector>> & pointsAndTangents)
{
  double squares = 0.0;
  for (const auto & entry : pointsAndTangents)
  {
    mmm::Vector x = entry.first;
    if (!indicators.Project(cell, x, 3.0) || !indicators.IsMaximal(cell, x, 0.05))
    {
      return std::numeric_limits<double>::infinity();
    }
    const mmm::Vector away = x - entry.first;
    squares += (away - away.dot(entry.second) * entry.second).squaredNorm();
  }
  return std::sqrt(squares / pointsAndTangents.size());
}

struct FeatureSizeErrors
{
  /** The share of samples within a tenth, or half a voxel if that is more, of what is expected. */
  double within{ 0.0 };
  /** The first and the last hundredth of the ratios to what is expected. */
  double low{ 0.0 };
  double high{ 0.0 };
};

/** Compares the local feature sizes at the interface's samples with what `expected` says for their place. Samples for
 * which it says 0 do not count. */
inline FeatureSizeErrors
MeasureFeatureSizes(const mmm::IndicatorSet & indicators, const std::function<double(const mmm::Vector &)> & expected)
{
  const auto          samples = mmm::CollectInterfaceSamples(indicators, 0);
  const auto          axis = mmm::ComputeMedialAxis(indicators, samples);
  const auto          sizes = mmm::ComputeLocalFeatureSizes(indicators.GetGrid(), samples, axis);
  std::size_t         within = 0;
  std::vector<double> ratios;
  for (std::size_t s = 0; s < samples.size(); ++s)
  {
    const double size = expected(samples[s].position);
    if (size > 0.0)
    {
      within += std::abs(sizes[s] - size) <= std::max(0.5, 0.1 * size);
      ratios.push_back(sizes[s] / size);
    }
  }
  std::sort(ratios.begin(), ratios.end());
  FeatureSizeErrors errors;
  if (!ratios.empty())
  {
    errors.within = double(within) / ratios.size();
    errors.low = ratios[ratios.size() / 100];
    errors.high = ratios[ratios.size() - 1 - ratios.size() / 100];
  }
  return errors;
}

struct PropagationErrors
{
  /** The largest excess over the smallest value + slope * distance, relative to it. */
  double excess{ 0.0 };
  /** The largest slope between two nodes that are at most two steps apart along each axis, over the given one. */
  double slope{ 0.0 };
};

inline PropagationErrors
MeasurePropagation(const mmm::Grid & grid, const std::vector<mmm::Source> & sources, double slope)
{
  const auto        values = mmm::PropagateSources(grid, sources, slope).values;
  PropagationErrors errors;
  for (std::size_t n = 0; n < values.size(); ++n)
  {
    const mmm::Index  at = grid.IndexAt(n);
    const mmm::Vector x = grid.Position(at);
    double            smallest = std::numeric_limits<double>::infinity();
    for (const auto & source : sources)
    {
      smallest = std::min(smallest, source.value + slope * (x - source.position.cast<double>()).norm());
    }
    errors.excess = std::max(errors.excess, values[n] / smallest - 1.0);
    for (int code = 0; code < 125; ++code)
    {
      const mmm::Index other{ { at[0] + code % 5 - 2, at[1] + code / 5 % 5 - 2, at[2] + code / 25 - 2 } };
      if (grid.Contains(other) && other != at)
      {
        const double distance = (grid.Position(other) - x).norm();
        errors.slope = std::max(errors.slope, std::abs(values[grid.Offset(other)] - values[n]) / distance / slope);
      }
    }
  }
  return errors;
}
} // namespace mmmtest

#endif
