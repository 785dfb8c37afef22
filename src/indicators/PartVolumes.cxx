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
#include "indicators/PartVolumes.h"

#include "indicators/BlockValue.h"
#include "indicators/IndicatorSmoothing.h"
#include "base/Parallel.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
constexpr std::size_t Grain = 1024;
constexpr float       Outside = -float(IndicatorBandWidth);

int
Steps(const Index & offset)
{
  return std::abs(offset[0]) + std::abs(offset[1]) + std::abs(offset[2]);
}

Index
Sum(const Index & a, const Index & b)
{
  return Index{ { a[0] + b[0], a[1] + b[1], a[2] + b[2] } };
}
} // namespace

PartVolumes::PartVolumes(const MaterialImage &             image,
                         const ImageParts &                parts,
                         const std::vector<Block<float>> & indicators)
  : m_Image(image)
  , m_Parts(parts)
  , m_Indicators(indicators)
{
  for (int code = 0; code < NearbyParts::Most; ++code)
  {
    m_Neighbours.push_back({ { code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1 } });
  }
  std::stable_sort(
    m_Neighbours.begin(), m_Neighbours.end(), [](const Index & a, const Index & b) { return Steps(a) < Steps(b); });
  for (int s = 0; s < Samples; ++s)
  {
    // Catmull and Rom's, as everywhere else
    const double x = (s + 0.5) / Samples - 0.5;
    const double t = x - std::floor(x);
    float *      weights = m_Weights[s];
    std::fill_n(weights, Support, 0.0f);
    weights += x < 0.0 ? 0 : 1;
    weights[0] = float(-0.5 * t + t * t - 0.5 * t * t * t);
    weights[1] = float(1.0 - 2.5 * t * t + 1.5 * t * t * t);
    weights[2] = float(0.5 * t + 2.0 * t * t - 1.5 * t * t * t);
    weights[3] = float(-0.5 * t * t + 0.5 * t * t * t);
  }
}

bool
PartVolumes::IsRim(const Index & at) const
{
  const Material own = m_Image.AtNearest(at);
  return std::any_of(m_Neighbours.begin(), m_Neighbours.end(), [&](const Index & offset) {
    return m_Image.AtNearest(Sum(at, offset)) != own;
  });
}

NearbyParts
PartVolumes::FindNearby(const Index & at) const
{
  NearbyParts nearby;
  for (const auto & offset : m_Neighbours)
  {
    const auto       n = m_Image.grid.Offset(m_Image.grid.Clamp(Sum(at, offset)));
    const Material   m = m_Image.materials[n];
    Material * const end = nearby.materials + nearby.count;
    if (std::find(nearby.materials, end, m) == end)
    {
      *end = m;
      nearby.parts[nearby.count++] = m_Parts.numbers[n];
    }
  }
  return nearby;
}

float
PartVolumes::ValueAt(Material m, const Index & at) const
{
  const float * const value = FindValue(m_Indicators[m], at);
  return value ? *value : Outside;
}

float
PartVolumes::Gap(const Index & at) const
{
  // the first one is the voxel's own
  const auto nearby = this->FindNearby(at);
  float      others = Outside;
  for (int c = 1; c < nearby.count; ++c)
  {
    others = std::max(others, this->ValueAt(nearby.materials[c], at));
  }
  return 0.5f * (this->ValueAt(nearby.materials[0], at) - others);
}

/** An indicator at all samples of a voxel. */
void
PartVolumes::Interpolate(Material m, const Index & at, float (&result)[SamplesPerVoxel]) const
{
  const auto & block = m_Indicators[m];
  int          places[3][Support]; // of the nodes in the block, negative outside of it
  for (int a = 0; a < 3; ++a)
  {
    for (int i = 0; i < Support; ++i)
    {
      const int place = std::min(std::max(at[a] + i - Support / 2, 0), m_Image.grid.size[a] - 1) - block.lower[a];
      places[a][i] = place < block.size[a] ? place : -1;
    }
  }
  float alongX[Support][Support][Samples];
  for (int k = 0; k < Support; ++k)
  {
    for (int j = 0; j < Support; ++j)
    {
      const int     y = places[1][j];
      const int     z = places[2][k];
      const bool    isWithin = y >= 0 && z >= 0;
      const float * values = block.values.data();
      values += isWithin ? (std::size_t(z) * block.size[1] + y) * block.size[0] : 0;
      float row[Support];
      for (int i = 0; i < Support; ++i)
      {
        row[i] = isWithin && places[0][i] >= 0 ? values[places[0][i]] : Outside;
      }
      for (int s = 0; s < Samples; ++s)
      {
        const auto & w = m_Weights[s];
        alongX[k][j][s] = w[0] * row[0] + w[1] * row[1] + w[2] * row[2] + w[3] * row[3] + w[4] * row[4];
      }
    }
  }
  float alongY[Support][Samples * Samples];
  for (int k = 0; k < Support; ++k)
  {
    for (int s = 0; s < Samples * Samples; ++s)
    {
      const auto & w = m_Weights[s / Samples];
      const auto & rows = alongX[k];
      const int    x = s % Samples;
      alongY[k][s] = w[0] * rows[0][x] + w[1] * rows[1][x] + w[2] * rows[2][x] + w[3] * rows[3][x] + w[4] * rows[4][x];
    }
  }
  for (int s = 0; s < SamplesPerVoxel; ++s)
  {
    const auto & w = m_Weights[s / (Samples * Samples)];
    const int    yx = s % (Samples * Samples);
    result[s] =
      w[0] * alongY[0][yx] + w[1] * alongY[1][yx] + w[2] * alongY[2][yx] + w[3] * alongY[3][yx] + w[4] * alongY[4][yx];
  }
}

void
PartVolumes::AddVoxel(const Index & at, PartShares & shares) const
{
  const auto nearby = this->FindNearby(at);
  float      largest[SamplesPerVoxel];
  float      second[SamplesPerVoxel];
  int        largestIs[SamplesPerVoxel] = {};
  int        secondIs[SamplesPerVoxel] = {};
  std::fill_n(largest, SamplesPerVoxel, 2.0f * Outside);
  std::fill_n(second, SamplesPerVoxel, 2.0f * Outside);
  for (int c = 0; c < nearby.count; ++c)
  {
    float values[SamplesPerVoxel];
    this->Interpolate(nearby.materials[c], at, values);
    for (int s = 0; s < SamplesPerVoxel; ++s)
    {
      const float value = values[s];
      const bool  isLargest = value > largest[s];
      const bool  isSecond = value > second[s];
      second[s] = isLargest ? largest[s] : (isSecond ? value : second[s]);
      secondIs[s] = isLargest ? largestIs[s] : (isSecond ? c : secondIs[s]);
      largest[s] = isLargest ? value : largest[s];
      largestIs[s] = isLargest ? c : largestIs[s];
    }
  }
  // A sample is a cell of this width, which an interface in the middle of it cuts in halves.
  constexpr double width = 1.0 / Samples;
  double           volumes[NearbyParts::Most] = {};
  int              cuts[NearbyParts::Most][NearbyParts::Most] = {};
  for (int s = 0; s < SamplesPerVoxel; ++s)
  {
    const double share = std::min(1.0, 0.5 + 0.5 * (largest[s] - second[s]) / width);
    volumes[largestIs[s]] += share;
    volumes[secondIs[s]] += 1.0 - share;
    cuts[largestIs[s]][secondIs[s]] += share < 1.0;
  }
  for (int c = 0; c < nearby.count; ++c)
  {
    shares.volumes[nearby.parts[c]] += volumes[c] / SamplesPerVoxel;
    for (int d = 0; d < nearby.count; ++d)
    {
      if (cuts[c][d] > 0)
      {
        const auto pair = std::minmax(nearby.parts[c], nearby.parts[d]);
        shares.areas[pair] += cuts[c][d] / (width * SamplesPerVoxel);
      }
    }
  }
}

PartShares
PartVolumes::Measure(const std::vector<std::size_t> & voxels) const
{
  std::vector<PartShares> ranges((voxels.size() + Grain - 1) / Grain);
  ParallelFor(voxels.size(), Grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
    {
      this->AddVoxel(m_Image.grid.IndexAt(voxels[v]), ranges[begin / Grain]);
    }
  });
  PartShares all;
  for (const auto & range : ranges)
  {
    for (const auto & entry : range.volumes)
    {
      all.volumes[entry.first] += entry.second;
    }
    for (const auto & entry : range.areas)
    {
      all.areas[entry.first] += entry.second;
    }
  }
  return all;
}
} // namespace mmm
