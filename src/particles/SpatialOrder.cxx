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
#include "particles/SpatialOrder.h"
#include "base/Parallel.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace mmm
{
namespace
{
constexpr std::size_t Grain = 4096;
/** Three coordinates of so many bits make a key. */
constexpr int    Bits = 21;
constexpr double Largest = (1 << Bits) - 1;

/** Moves each of the lowest 21 bits to three times its place. */
std::uint64_t
Spread(std::uint64_t x)
{
  x = (x | (x << 32)) & 0x001f00000000ffffULL;
  x = (x | (x << 16)) & 0x001f0000ff0000ffULL;
  x = (x | (x << 8)) & 0x100f00f00f00f00fULL;
  x = (x | (x << 4)) & 0x10c30c30c30c30c3ULL;
  x = (x | (x << 2)) & 0x1249249249249249ULL;
  return x;
}
} // namespace

std::vector<PointId>
SpatialOrder(const std::vector<Vector> & points, std::size_t first)
{
  if (first >= points.size())
  {
    return {};
  }
  Vector lower = points[first];
  Vector upper = points[first];
  for (std::size_t p = first; p < points.size(); ++p)
  {
    lower = lower.cwiseMin(points[p]);
    upper = upper.cwiseMax(points[p]);
  }
  const double extent = (upper - lower).maxCoeff();
  const double scale = extent > 0.0 ? Largest / extent : 0.0;

  std::vector<std::pair<std::uint64_t, PointId>> keys(points.size() - first);
  ParallelFor(keys.size(), Grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      std::uint64_t key = 0;
      for (int a = 0; a < 3; ++a)
      {
        // what is no number comes first
        const double place = (points[first + n][a] - lower[a]) * scale;
        key |= Spread(place > 0.0 ? std::uint64_t(std::min(place, Largest)) : 0) << a;
      }
      keys[n] = { key, PointId(first + n) };
    }
  });
  std::sort(keys.begin(), keys.end());
  std::vector<PointId> order(keys.size());
  std::transform(keys.begin(), keys.end(), order.begin(), [](const auto & key) { return key.second; });
  return order;
}

void
SortInSpace(ParticleSet & particles, std::size_t first)
{
  const auto                 order = SpatialOrder(particles.positions, first);
  std::vector<Vector>        positions;
  std::vector<std::uint32_t> cells;
  positions.reserve(order.size());
  cells.reserve(order.size());
  for (const PointId p : order)
  {
    positions.push_back(particles.positions[p]);
    cells.push_back(particles.cells[p]);
  }
  std::copy(positions.begin(), positions.end(), particles.positions.begin() + first);
  std::copy(cells.begin(), cells.end(), particles.cells.begin() + first);
}
} // namespace mmm
