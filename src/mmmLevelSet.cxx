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
#include "mmmLevelSet.h"

#include "mmmParallel.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
constexpr std::size_t Grain = 8192;
constexpr int         AveragingRounds = 8;
constexpr int         StepsPerMean = 6;

/** The smallest distance d with sum over axes of (max(d - t_a, 0) / s_a)^2 = 1: Godunov's solution of |grad d| = 1. */
double
SolveEikonal(std::array<double, 3> t, std::array<double, 3> s)
{
  // smallest arrival first
  for (int a = 0; a < 2; ++a)
  {
    for (int b = 0; b < 2 - a; ++b)
    {
      if (t[b] > t[b + 1])
      {
        std::swap(t[b], t[b + 1]);
        std::swap(s[b], s[b + 1]);
      }
    }
  }
  double d = t[0] + s[0];
  double sumW = 0.0;
  double sumT = 0.0;
  double sumTT = 0.0;
  for (int a = 0; a < 3 && t[a] < d; ++a)
  {
    const double w = 1.0 / (s[a] * s[a]);
    sumW += w;
    sumT += w * t[a];
    sumTT += w * t[a] * t[a];
    const double discriminant = sumT * sumT - sumW * (sumTT - 1.0);
    d = discriminant > 0.0 ? (sumT + std::sqrt(discriminant)) / sumW : d;
  }
  return d;
}
} // namespace

LevelSet::LevelSet(const Index & lower, const Index & size, const Vector & spacing, double width)
  : m_Lower(lower)
  , m_Size(size)
  , m_Spacing(spacing)
  , m_Width(width)
  , m_Values(std::size_t(size[0]) * size[1] * size[2], float(-width))
{}

void
LevelSet::SelectBand(double distance)
{
  m_Band.clear();
  std::size_t n = 0;
  for (int k = 0; k < m_Size[2]; ++k)
  {
    for (int j = 0; j < m_Size[1]; ++j)
    {
      const bool rim = k == 0 || j == 0 || k == m_Size[2] - 1 || j == m_Size[1] - 1;
      for (int i = 0; i < m_Size[0]; ++i, ++n)
      {
        if (!rim && i > 0 && i < m_Size[0] - 1 && std::abs(m_Values[n]) < distance)
        {
          m_Band.push_back(std::uint32_t(n));
        }
      }
    }
  }
}

void
LevelSet::Redistance()
{
  const std::array<std::ptrdiff_t, 3> stride{ { 1, m_Size[0], std::ptrdiff_t(m_Size[0]) * m_Size[1] } };
  const std::size_t                   count = m_Band.size();
  std::vector<float>                  distance(count);
  std::vector<char>                   settled(count);

  ParallelFor(count, Grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b)
    {
      const float * v = &m_Values[m_Band[b]];
      double        inverseSquares = 0.0;
      for (int a = 0; a < 3; ++a)
      {
        double nearest = 2.0;
        for (const auto step : { -stride[a], stride[a] })
        {
          if ((v[0] > 0.0f) != (v[step] > 0.0f))
          {
            nearest = std::min(nearest, std::max(1e-3, double(v[0]) / (double(v[0]) - v[step])));
          }
        }
        if (nearest < 1.5)
        {
          inverseSquares += 1.0 / (nearest * nearest * m_Spacing[a] * m_Spacing[a]);
        }
      }
      settled[b] = inverseSquares > 0.0;
      distance[b] = settled[b] ? float(1.0 / std::sqrt(inverseSquares)) : float(m_Width);
    }
  });
  ParallelFor(count, Grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b)
    {
      float & v = m_Values[m_Band[b]];
      v = std::copysign(distance[b], v > 0.0f ? 1.0f : -1.0f);
    }
  });

  // From here on outwards; the band is only a few nodes wide, so few rounds settle it.
  const int rounds = 2 + int(std::ceil(1.5 * m_Width));
  for (int round = 0; round < rounds; ++round)
  {
    ParallelFor(count, Grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b)
      {
        const float * v = &m_Values[m_Band[b]];
        distance[b] = std::abs(v[0]);
        if (settled[b])
        {
          continue;
        }
        std::array<double, 3> t;
        std::array<double, 3> s;
        for (int a = 0; a < 3; ++a)
        {
          t[a] = m_Width;
          s[a] = m_Spacing[a];
          for (const auto step : { -stride[a], stride[a] })
          {
            if ((v[0] > 0.0f) == (v[step] > 0.0f))
            {
              t[a] = std::min(t[a], double(std::abs(v[step])));
            }
          }
        }
        distance[b] = float(std::min(m_Width, SolveEikonal(t, s)));
      }
    });
    ParallelFor(count, Grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b)
      {
        float & v = m_Values[m_Band[b]];
        v = std::copysign(distance[b], v);
      }
    });
  }
}

void
LevelSet::MeanOverBand(const std::vector<float> & speed, Scratch & scratch) const
{
  // Repeated averages over the six neighbours; nodes count the less, the further they are from the zero level.
  const std::array<std::ptrdiff_t, 3> stride{ { 1, m_Size[0], std::ptrdiff_t(m_Size[0]) * m_Size[1] } };
  const std::size_t                   count = m_Band.size();
  std::vector<float> &                weight = scratch.weight;
  std::vector<float> &                mean = scratch.mean;
  std::vector<float> &                next = scratch.bandMean;
  weight.resize(m_Values.size(), 0.0f);
  mean.resize(m_Values.size(), 0.0f);
  next.resize(count);
  ParallelFor(count, Grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b)
    {
      weight[m_Band[b]] = std::max(0.0f, 1.5f - std::abs(m_Values[m_Band[b]]));
      mean[m_Band[b]] = speed[b];
    }
  });
  for (int round = 0; round < AveragingRounds; ++round)
  {
    ParallelFor(count, Grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b)
      {
        const std::size_t n = m_Band[b];
        float             sum = weight[n] * mean[n];
        float             total = weight[n];
        for (int a = 0; a < 3; ++a)
        {
          const std::size_t before = n - stride[a];
          const std::size_t after = n + stride[a];
          sum += weight[before] * mean[before] + weight[after] * mean[after];
          total += weight[before] + weight[after];
        }
        next[b] = total > 0.0f ? sum / total : 0.0f;
      }
    });
    ParallelFor(count, Grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b)
      {
        mean[m_Band[b]] = next[b];
      }
    });
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
  const double         timeStep = 0.45 / (qx + qy + qz);
  const std::size_t    count = m_Band.size();
  std::vector<float>   speed(count);
  Scratch              scratch;
  const std::size_t    ranges = (count + Grain - 1) / Grain;
  std::vector<double>  squares(ranges);

  int step = 0;
  while (step < maximumSteps)
  {
    ParallelFor(count, Grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b)
      {
        const float * v = &m_Values[m_Band[b]];
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
        speed[b] = ((yy + zz) * gx * gx + (xx + zz) * gy * gy + (xx + yy) * gz * gz -
                             2.0f * (gx * gy * xy + gx * gz * xz + gy * gz * yz)) /
                            (squaredNorm + 1e-4f);
      }
    });
    if (step % StepsPerMean == 0)
    {
      this->MeanOverBand(speed, scratch);
    }
    ParallelFor(count, Grain, [&](std::size_t begin, std::size_t end) {
      double sum = 0.0;
      for (std::size_t b = begin; b < end; ++b)
      {
        float &      v = m_Values[m_Band[b]];
        const float  moved = v + float(timeStep) * (speed[b] - scratch.bandMean[b]);
        const float  next = std::min(upper[b], std::max(lower[b], moved));
        const double change = double(next) - v;
        sum += change * change;
        v = next;
      }
      squares[begin / Grain] = sum;
    });
    ++step;
    double sum = 0.0;
    for (const double square : squares)
    {
      sum += square;
    }
    if (std::sqrt(sum / std::max<std::size_t>(count, 1)) < tolerance * timeStep)
    {
      break;
    }
  }
  return step;
}
} // namespace mmm
