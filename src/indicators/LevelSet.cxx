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
#include "indicators/LevelSet.h"

#include "base/Parallel.h"
#include "indicators/IndicatorParameters.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
using Parameters = SmoothingParameters;

/** How much the nodes near the zero level moved in a step. */
struct Motion
{
  double squares{ 0.0 };
  double nodes{ 0.0 };
};

void
SwapIfLess(float & a, float & b, float & s, float & t)
{
  const bool  swap = b < a;
  const float smaller = swap ? b : a;
  const float larger = swap ? a : b;
  const float first = swap ? t : s;
  const float second = swap ? s : t;
  a = smaller;
  b = larger;
  s = first;
  t = second;
}

/** The smallest distance d with sum over axes of (max(d - t_a, 0) / s_a)^2 = 1: Godunov's solution of |grad d| = 1.
 * Without branches, so that it can be computed for several nodes at once. */
float
SolveEikonal(float t0, float t1, float t2, float s0, float s1, float s2)
{
  SwapIfLess(t0, t1, s0, s1);
  SwapIfLess(t1, t2, s1, s2);
  SwapIfLess(t0, t1, s0, s1);
  const float one = t0 + s0;

  const float w0 = 1.0f / (s0 * s0);
  const float w1 = 1.0f / (s1 * s1);
  float       sumW = w0 + w1;
  float       sumT = w0 * t0 + w1 * t1;
  float       sumTT = w0 * t0 * t0 + w1 * t1 * t1;
  float       discriminant = sumT * sumT - sumW * (sumTT - 1.0f);
  const float two = (sumT + std::sqrt(discriminant > 0.0f ? discriminant : 0.0f)) / sumW;
  const float best = t1 < one ? two : one;

  const float w2 = 1.0f / (s2 * s2);
  sumW += w2;
  sumT += w2 * t2;
  sumTT += w2 * t2 * t2;
  discriminant = sumT * sumT - sumW * (sumTT - 1.0f);
  const float three = (sumT + std::sqrt(discriminant > 0.0f ? discriminant : 0.0f)) / sumW;
  return t2 < best ? three : best;
}

/** The magnitude of a neighbour's value, if it is on the same side of the zero level. */
float
SameSide(float own, float neighbour, float otherwise)
{
  return (own > 0.0f) == (neighbour > 0.0f) ? std::abs(neighbour) : otherwise;
}
} // namespace

LevelSet::LevelSet(const Index & lower, const Index & size, const Vector & spacing, double width)
  : m_Lower(lower)
  , m_Size(size)
  , m_Spacing(spacing)
  , m_Width(width)
  , m_Values(std::size_t(size[0]) * size[1] * size[2] + Lanes, float(-width))
{}

Block<float>
LevelSet::Copy(const Index & lower, const Index & size) const
{
  Block<float> block;
  block.lower = lower;
  block.size = size;
  block.values.reserve(std::size_t(size[0]) * size[1] * size[2]);
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      const auto row = m_Values.begin() + this->Offset(Index{ { lower[0], lower[1] + j, lower[2] + k } });
      block.values.insert(block.values.end(), row, row + size[0]);
    }
  }
  return block;
}

void
LevelSet::SelectBand(double distance)
{
  m_BandDistance = distance;
  m_Band.clear();
  m_Runs.clear();
  std::size_t n = 0;
  for (int k = 0; k < m_Size[2]; ++k)
  {
    for (int j = 0; j < m_Size[1]; ++j)
    {
      const bool    rim = k == 0 || j == 0 || k == m_Size[2] - 1 || j == m_Size[1] - 1;
      std::uint32_t length = 0;
      for (int i = 0; i < m_Size[0]; ++i, ++n)
      {
        if (!rim && i > 0 && i < m_Size[0] - 1 && std::abs(m_Values[n]) < distance)
        {
          m_Band.push_back(std::uint32_t(n));
          ++length;
        }
        else if (length > 0)
        {
          m_Runs.push_back({ std::uint32_t(m_Band.size()) - length, length });
          length = 0;
        }
      }
    }
  }
}

template <typename TBody>
void
LevelSet::ForEachRun(const TBody & body) const
{
  ParallelFor(m_Runs.size(), RunGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r)
    {
      body(m_Runs[r].place, m_Band[m_Runs[r].place], m_Runs[r].length, begin / RunGrain);
    }
  });
}

template <typename TValue>
void
LevelSet::ComputeOverBand(const TValue & valueAt, std::vector<float> & result) const
{
  this->ForEachRun([&](std::size_t place, std::size_t node, std::size_t length, std::size_t) {
    for (std::size_t start = 0; start < length; start += Lanes)
    {
      // all lanes, whether there is a node for each or not
      float lanes[Lanes];
      for (std::size_t lane = 0; lane < Lanes; ++lane)
      {
        lanes[lane] = valueAt(node + start + lane);
      }
      std::copy_n(lanes, std::min(length - start, std::size_t(Lanes)), &result[place + start]);
    }
  });
}

void
LevelSet::Redistance(Before before)
{
  const std::ptrdiff_t  sx = 1;
  const std::ptrdiff_t  sy = m_Size[0];
  const std::ptrdiff_t  sz = sy * m_Size[1];
  const Eigen::Vector3f spacing = m_Spacing.cast<float>();
  const float           width = float(m_Width);
  const float *         values = m_Values.data();
  std::vector<float>    distance(m_Band.size());
  const auto            commit = [&] {
    this->ForEachRun([&](std::size_t place, std::size_t node, std::size_t length, std::size_t) {
      for (std::size_t i = 0; i < length; ++i)
      {
        m_Values[node + i] = std::copysign(distance[place + i], m_Values[node + i] > 0.0f ? 1.0f : -1.0f);
      }
    });
  };

  const auto crossing = [](float own, float before, float after) {
    float nearest = 2.0f;
    for (const float other : { before, after })
    {
      const float fraction = own / (own - other);
      const float atLeast = fraction > 1e-3f ? fraction : 1e-3f;
      nearest = (own > 0.0f) != (other > 0.0f) && atLeast < nearest ? atLeast : nearest;
    }
    return nearest;
  };
  this->ComputeOverBand(
    [&](std::size_t n) {
      const float * v = values + n;
      const float   x = crossing(v[0], v[-sx], v[sx]) * spacing[0];
      const float   y = crossing(v[0], v[-sy], v[sy]) * spacing[1];
      const float   z = crossing(v[0], v[-sz], v[sz]) * spacing[2];
      const float   inverse = (x < 1.5f * spacing[0] ? 1.0f / (x * x) : 0.0f) +
                            (y < 1.5f * spacing[1] ? 1.0f / (y * y) : 0.0f) +
                            (z < 1.5f * spacing[2] ? 1.0f / (z * z) : 0.0f);
      if (!(inverse > 0.0f))
      {
        return width;
      }
      // By the crossings the zero level is a plane, which makes what is convex smaller each time. By the slope it may
      // be curved, but the slope is wrong where two parts of it are close to each other.
      const float straight = 1.0f / std::sqrt(inverse);
      const float gx = (v[sx] - v[-sx]) / (2.0f * spacing[0]);
      const float gy = (v[sy] - v[-sy]) / (2.0f * spacing[1]);
      const float gz = (v[sz] - v[-sz]) / (2.0f * spacing[2]);
      const float slope = std::sqrt(gx * gx + gy * gy + gz * gz);
      const float curved = std::abs(v[0]) / slope;
      const bool  isRegular =
        before == Before::NearDistances && slope > 0.7f && curved < 1.3f * straight && straight < 1.3f * curved;
      return isRegular ? curved : straight;
    },
    distance);
  commit();

  // From here on outwards; the band is only a few nodes wide, so few rounds settle it.
  const int rounds = 2 + int(std::ceil(1.5 * m_BandDistance));
  for (int round = 0; round < rounds; ++round)
  {
    this->ComputeOverBand(
      [&](std::size_t n) {
        const float * v = values + n;
        const float   own = v[0];
        const float   none = 2.0f * width;
        const float   xBefore = SameSide(own, v[-sx], none);
        const float   xAfter = SameSide(own, v[sx], none);
        const float   yBefore = SameSide(own, v[-sy], none);
        const float   yAfter = SameSide(own, v[sy], none);
        const float   zBefore = SameSide(own, v[-sz], none);
        const float   zAfter = SameSide(own, v[sz], none);
        const float   solution = SolveEikonal(std::min({ xBefore, xAfter, width }),
                                            std::min({ yBefore, yAfter, width }),
                                            std::min({ zBefore, zAfter, width }),
                                            spacing[0],
                                            spacing[1],
                                            spacing[2]);
        // nodes beside the zero level know their distance
        const bool beside = std::max({ xBefore, xAfter, yBefore, yAfter, zBefore, zAfter }) == none;
        return beside ? std::abs(own) : std::min(width, solution);
      },
      distance);
    commit();
  }
}

void
LevelSet::MeanOverBand(const std::vector<float> & speed, Scratch & scratch) const
{
  // Repeated averages over the six neighbours; nodes count the less, the further they are from the zero level.
  const std::ptrdiff_t sx = 1;
  const std::ptrdiff_t sy = m_Size[0];
  const std::ptrdiff_t sz = sy * m_Size[1];
  std::vector<float> & weight = scratch.weight;
  std::vector<float> & weighted = scratch.weighted;
  weight.resize(m_Values.size(), 0.0f);
  weighted.resize(m_Values.size(), 0.0f);
  scratch.bandMean = speed;
  this->ForEachRun([&](std::size_t, std::size_t node, std::size_t length, std::size_t) {
    for (std::size_t i = 0; i < length; ++i)
    {
      weight[node + i] = std::max(0.0f, 1.5f - std::abs(m_Values[node + i]));
    }
  });
  for (int round = 0; round < Parameters::AveragingRounds; ++round)
  {
    this->ForEachRun([&](std::size_t place, std::size_t node, std::size_t length, std::size_t) {
      for (std::size_t i = 0; i < length; ++i)
      {
        weighted[node + i] = weight[node + i] * scratch.bandMean[place + i];
      }
    });
    const float * w = weight.data();
    const float * m = weighted.data();
    this->ComputeOverBand(
      [&](std::size_t n) {
        const float total = w[n] + w[n - sx] + w[n + sx] + w[n - sy] + w[n + sy] + w[n - sz] + w[n + sz];
        const float sum = m[n] + m[n - sx] + m[n + sx] + m[n - sy] + m[n + sy] + m[n - sz] + m[n + sz];
        return total > 0.0f ? sum / total : 0.0f;
      },
      scratch.bandMean);
  }
}

int
LevelSet::FlowByMeanCurvature(const std::vector<float> & lower,
                              const std::vector<float> & upper,
                              double                     tolerance,
                              int                        maximumSteps)
{
  const std::ptrdiff_t sx = 1;
  const std::ptrdiff_t sy = m_Size[0];
  const std::ptrdiff_t sz = sy * m_Size[1];
  const Vector         inverse = m_Spacing.cwiseInverse();
  const float          hx = float(0.5 * inverse[0]);
  const float          hy = float(0.5 * inverse[1]);
  const float          hz = float(0.5 * inverse[2]);
  const float          qx = float(inverse[0] * inverse[0]);
  const float          qy = float(inverse[1] * inverse[1]);
  const float          qz = float(inverse[2] * inverse[2]);
  const float          timeStep = 0.45f / (qx + qy + qz);
  const std::size_t    count = m_Band.size();
  const float *        values = m_Values.data();
  std::vector<float>   speed(count);
  std::vector<float>   change(count, 0.0f);
  Scratch              scratch;
  std::vector<Motion>  motions((m_Runs.size() + RunGrain - 1) / RunGrain);
  const double         longest = tolerance * timeStep / (1.0 - Parameters::Momentum);

  int step = 0;
  while (step < maximumSteps)
  {
    this->ComputeOverBand(
      [&](std::size_t n) {
        const float * v = values + n;
        const float   c = v[0];
        const float   gx = (v[sx] - v[-sx]) * hx;
        const float   gy = (v[sy] - v[-sy]) * hy;
        const float   gz = (v[sz] - v[-sz]) * hz;
        const float   xx = (v[sx] + v[-sx] - 2.0f * c) * qx;
        const float   yy = (v[sy] + v[-sy] - 2.0f * c) * qy;
        const float   zz = (v[sz] + v[-sz] - 2.0f * c) * qz;
        const float   xy = (v[sx + sy] + v[-sx - sy] - v[sx - sy] - v[sy - sx]) * hx * hy;
        const float   xz = (v[sx + sz] + v[-sx - sz] - v[sx - sz] - v[sz - sx]) * hx * hz;
        const float   yz = (v[sy + sz] + v[-sy - sz] - v[sy - sz] - v[sz - sy]) * hy * hz;
        const float   squaredNorm = gx * gx + gy * gy + gz * gz;
        return ((yy + zz) * gx * gx + (xx + zz) * gy * gy + (xx + yy) * gz * gz -
                2.0f * (gx * gy * xy + gx * gz * xz + gy * gz * yz)) /
               (squaredNorm + 1e-4f);
      },
      speed);
    if (step % Parameters::StepsPerMean == 0)
    {
      this->MeanOverBand(speed, scratch);
    }
    std::fill(motions.begin(), motions.end(), Motion());
    this->ForEachRun([&](std::size_t place, std::size_t node, std::size_t length, std::size_t range) {
      float sum = 0.0f;
      float nodes = 0.0f;
      for (std::size_t i = 0; i < length; ++i)
      {
        const std::size_t b = place + i;
        const float       v = m_Values[node + i];
        const float       moved = v + timeStep * (speed[b] - scratch.bandMean[b]) + Parameters::Momentum * change[b];
        const float       next = std::min(upper[b], std::max(lower[b], moved));
        change[b] = next - v;
        const bool near = std::abs(v) < Parameters::RestDistance;
        sum += near ? change[b] * change[b] : 0.0f;
        nodes += near ? 1.0f : 0.0f;
        m_Values[node + i] = next;
      }
      motions[range].squares += sum;
      motions[range].nodes += nodes;
    });
    ++step;
    Motion all;
    for (const Motion & motion : motions)
    {
      all.squares += motion.squares;
      all.nodes += motion.nodes;
    }
    if (std::sqrt(all.squares / std::max(all.nodes, 1.0)) < longest)
    {
      break;
    }
  }
  return step;
}
} // namespace mmm
