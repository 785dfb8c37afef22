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
#include "indicators/FunctionIndicators.h"

#include "indicators/BoxDistance.h"
#include "base/Parallel.h"

#include "itkMacro.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mmm
{
namespace
{
constexpr std::size_t Grain = 65536;
using Parameters = FunctionParameters;
} // namespace

std::vector<float>
ComputeRemainder(const std::vector<const float *> & maps, std::size_t numberOfVoxels)
{
  std::vector<float> sum(numberOfVoxels, 0.0f);
  std::vector<float> largest(numberOfVoxels, std::numeric_limits<float>::lowest());
  float              lowest = std::numeric_limits<float>::max();
  for (const float * const map : maps)
  {
    for (std::size_t v = 0; v < numberOfVoxels; ++v)
    {
      sum[v] += map[v];
      largest[v] = std::max(largest[v], map[v]);
      lowest = std::min(lowest, map[v]);
    }
  }
  if (lowest < -Parameters::Overshoot)
  {
    std::transform(largest.begin(), largest.end(), largest.begin(), [](float value) { return -value; });
    return largest;
  }
  const float highest = *std::max_element(largest.begin(), largest.end());
  if (highest > 1.0f + Parameters::Overshoot)
  {
    itkGenericExceptionMacro("The values of the indicator images range from "
                             << lowest << " to " << highest
                             << ". Without an image of the exterior, they have to be probabilities from 0 to 1, or "
                                "functions that are positive inside and negative outside.");
  }
  std::transform(sum.begin(), sum.end(), sum.begin(), [](float value) { return 1.0f - value; });
  return sum;
}

FunctionIndicators::FunctionIndicators(const MaterialImage & image, std::vector<std::vector<const float *>> functions)
  : m_Image(image)
  , m_Functions(std::move(functions))
  , m_Largest(image.materials.size())
  , m_Second(image.materials.size())
{
  ParallelFor(m_Largest.size(), Grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
    {
      const Material own = m_Image.materials[v];
      float          largest = this->Value(own, v);
      float          second = std::numeric_limits<float>::lowest();
      for (std::size_t m = 0; m < m_Functions.size(); ++m)
      {
        if (m != own)
        {
          second = std::max(second, this->Value(Material(m), v));
        }
      }
      // where the image says otherwise, they change places
      m_Largest[v] = std::max(largest, second);
      m_Second[v] = std::min(largest, second);
    }
  });
}

float
FunctionIndicators::Value(Material material, std::size_t voxel) const
{
  float value = std::numeric_limits<float>::lowest();
  for (const float * const function : m_Functions[material])
  {
    value = std::max(value, function[voxel]);
  }
  return value;
}

float
FunctionIndicators::Lead(std::size_t voxel, Material other) const
{
  return std::max(m_Largest[voxel] - std::min(this->Value(other, voxel), m_Second[voxel]), Parameters::LeastLead);
}

float
FunctionIndicators::DistanceToNeighbours(Material material, const Index & at) const
{
  const Grid &   grid = m_Image.grid;
  const auto     voxel = this->VoxelAt(at);
  const Material own = m_Image.materials[voxel];
  double         inverseSquares = 0.0;
  const auto     isAtThinPart = [&] {
    bool found = IsThin(m_Image, at);
    for (int a = 0; a < 3; ++a)
    {
      for (const int step : { -1, 1 })
      {
        Index beside = at;
        beside[a] += step;
        found = found || (m_Image.materials[this->VoxelAt(beside)] != own && IsThin(m_Image, beside));
      }
    }
    return found;
  };
  for (int a = 0; a < 3; ++a)
  {
    double nearest = 2.0;
    for (const int step : { -1, 1 })
    {
      Index beside = at;
      beside[a] += step;
      const auto     neighbour = this->VoxelAt(beside);
      const Material other = m_Image.materials[neighbour];
      if ((own == material) != (other == material))
      {
        const double lead = this->Lead(voxel, other);
        nearest = std::min(nearest, std::max(Parameters::ShortestWay, lead / (lead + this->Lead(neighbour, own))));
      }
    }
    if (nearest <= 1.0)
    {
      inverseSquares += 1.0 / std::pow(nearest * grid.spacing[a], 2);
    }
  }
  if (inverseSquares == 0.0)
  {
    return 0.0f;
  }
  const float distance = float(1.0 / std::sqrt(inverseSquares));
  return distance < SmoothingParameters::ThinCentreMargin && isAtThinPart() ? SmoothingParameters::ThinCentreMargin
                                                                            : distance;
}

std::size_t
FunctionIndicators::VoxelAt(const Index & at) const
{
  return m_Image.grid.Offset(m_Image.grid.Clamp(at));
}

Block<float>
FunctionIndicators::Compute(Material material, const MaterialBox & box) const
{
  const Grid & grid = m_Image.grid;
  const auto   covered = ComputeIndicatorBox(grid, box);
  Index        lower;
  Index        size;
  for (int a = 0; a < 3; ++a)
  {
    lower[a] = covered.lower[a] - Parameters::BorderContinuation;
    size[a] = covered.size[a] + 2 * Parameters::BorderContinuation;
  }
  LevelSet levelSet(lower, size, grid.spacing, IndicatorBandWidth);
  ComputeBoxDistance(m_Image, material, levelSet);
  levelSet.SelectBand(IndicatorBandWidth);
  const auto & band = levelSet.Band();
  // Redistance() takes the zero level from the values beside it. In a layer of one voxel these are those of both its
  // sides, so its result is for what is further away.
  const auto moveToInterface = [&] {
    ParallelFor(band.size(), Grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b)
      {
        float &     value = levelSet.Values()[band[b]];
        const float distance = this->DistanceToNeighbours(material, levelSet.IndexAt(band[b]));
        value = distance > 0.0f ? std::copysign(distance, value) : value;
      }
    });
  };
  moveToInterface();
  levelSet.Redistance(LevelSet::Before::AnyFunction);
  moveToInterface();

  return levelSet.Copy(covered.lower, covered.size);
}
} // namespace mmm
