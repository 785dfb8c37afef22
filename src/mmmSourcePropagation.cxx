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
#include "mmmSourcePropagation.h"

#include "mmmParallel.h"

#include <cmath>
#include <limits>

namespace mmm
{
namespace
{
/** The directions of the sweeps, a bit an axis. Opposite octants follow each other within each half. */
constexpr int Octants[2][4] = { { 0, 7, 2, 5 }, { 4, 3, 6, 1 } };

/** A source is handed to the nodes around it first. */
void
PlaceSources(const Grid & grid, const std::vector<Source> & sources, float slope, PropagatedField & field)
{
  for (std::uint32_t s = 0; s < sources.size(); ++s)
  {
    const Source & source = sources[s];
    int            base[3];
    for (int a = 0; a < 3; ++a)
    {
      base[a] = int(std::floor(source.position[a] / grid.spacing[a]));
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      const Index at{ { base[0] + (corner & 1), base[1] + ((corner >> 1) & 1), base[2] + (corner >> 2) } };
      if (!grid.Contains(at))
      {
        continue;
      }
      const float value =
        source.value + slope * (grid.Position(at).cast<float>() - source.position).norm();
      const auto n = grid.Offset(at);
      if (value < field.values[n])
      {
        field.values[n] = value;
        field.sources[n] = s;
      }
    }
  }
}

/** Hands sources on along one octant: `direction` is +1 or -1 for each axis. */
void
SweepOctant(const Grid &                grid,
            const std::vector<Source> & sources,
            float                       slope,
            const Index &               direction,
            PropagatedField &           field)
{
  const std::array<std::ptrdiff_t, 3> stride{ { 1, grid.size[0], std::ptrdiff_t(grid.size[0]) * grid.size[1] } };
  const Eigen::Vector3f               spacing = grid.spacing.cast<float>();
  std::ptrdiff_t                      behind[8];
  for (int corner = 1; corner < 8; ++corner)
  {
    behind[corner] = 0;
    for (int a = 0; a < 3; ++a)
    {
      behind[corner] -= ((corner >> a) & 1) * direction[a] * stride[a];
    }
  }
  const auto first = [&](int a) { return direction[a] > 0 ? 0 : grid.size[a] - 1; };
  const auto past = [&](int a) { return direction[a] > 0 ? grid.size[a] : -1; };
  for (int k = first(2); k != past(2); k += direction[2])
  {
    for (int j = first(1); j != past(1); j += direction[1])
    {
      const int edge = (j == first(1) ? 2 : 0) | (k == first(2) ? 4 : 0);
      for (int i = first(0); i != past(0); i += direction[0])
      {
        const int             missing = edge | (i == first(0) ? 1 : 0);
        const std::size_t     n = grid.Offset(i, j, k);
        const Eigen::Vector3f x(i * spacing[0], j * spacing[1], k * spacing[2]);
        float                 best = field.values[n];
        std::uint32_t         bestSource = field.sources[n];
        for (int corner = 1; corner < 8; ++corner)
        {
          if (corner & missing)
          {
            continue;
          }
          const std::uint32_t source = field.sources[n + behind[corner]];
          if (source == bestSource || source == PropagatedField::NoSource)
          {
            continue;
          }
          const float rest = best - sources[source].value;
          if (rest > 0.0f)
          {
            const float square = (x - sources[source].position).squaredNorm() * slope * slope;
            if (square < rest * rest)
            {
              best = sources[source].value + std::sqrt(square);
              bestSource = source;
            }
          }
        }
        field.values[n] = best;
        field.sources[n] = bestSource;
      }
    }
  }
}
} // namespace

PropagatedField
PropagateSources(const Grid & grid, const std::vector<Source> & sources, double slope)
{
  const std::size_t count = grid.NumberOfNodes();
  PropagatedField   start;
  start.values.assign(count, std::numeric_limits<float>::infinity());
  start.sources.assign(count, PropagatedField::NoSource);
  PlaceSources(grid, sources, float(slope), start);

  // Octants are independent of one another: two halves run side by side and the smaller value wins.
  PropagatedField other = start;
  ParallelFor(2, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t half = begin; half < end; ++half)
    {
      PropagatedField & field = half == 0 ? start : other;
      for (const int bits : Octants[half])
      {
        const auto sign = [&](int a) { return (bits >> a) & 1 ? -1 : 1; };
        SweepOctant(grid, sources, float(slope), Index{ { sign(0), sign(1), sign(2) } }, field);
      }
    }
  });
  ParallelFor(count, 1 << 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      if (other.values[n] < start.values[n])
      {
        start.values[n] = other.values[n];
        start.sources[n] = other.sources[n];
      }
    }
  });
  return start;
}
} // namespace mmm
