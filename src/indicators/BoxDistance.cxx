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
#include "indicators/BoxDistance.h"

#include "base/Parallel.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
/** One pass of the separable transform: the smallest squared distance to the opposite kind when the offset along `axis`
 * is free as well. `squares` holds what the passes before found (0: not in this material's kind table). */
void
SweepAxis(int                        axis,
          double                     spacing,
          double                     width,
          const Index &              size,
          const std::vector<char> &  inside,
          const std::vector<float> & source,
          std::vector<float> &       target)
{
  const std::array<std::ptrdiff_t, 3> stride{ { 1, size[0], std::ptrdiff_t(size[0]) * size[1] } };
  const float                         limit = float(width * width);
  const int                           reach = int(std::ceil(width / spacing + 0.5));
  std::vector<float>                  offsetSquares(reach + 1, 0.0f);
  for (int d = 1; d <= reach; ++d)
  {
    offsetSquares[d] = float(std::pow((d - 0.5) * spacing, 2));
  }
  ParallelFor(size[2], 1, [&](std::size_t begin, std::size_t end) {
    for (int k = int(begin); k < int(end); ++k)
    {
      for (int j = 0; j < size[1]; ++j)
      {
        for (int i = 0; i < size[0]; ++i)
        {
          const std::size_t n = i * stride[0] + j * stride[1] + k * stride[2];
          const int         at = axis == 0 ? i : (axis == 1 ? j : k);
          const char        kind = inside[n];
          float             best = source[n];
          for (int d = 1; d <= reach && offsetSquares[d] < best; ++d)
          {
            if (at - d >= 0)
            {
              const std::size_t m = n - d * stride[axis];
              best = std::min(best, offsetSquares[d] + (inside[m] == kind ? source[m] : 0.0f));
            }
            if (at + d < size[axis])
            {
              const std::size_t m = n + d * stride[axis];
              best = std::min(best, offsetSquares[d] + (inside[m] == kind ? source[m] : 0.0f));
            }
          }
          target[n] = std::min(best, limit);
        }
      }
    }
  });
}
} // namespace

void
ComputeBoxDistance(const MaterialImage & image, Material material, LevelSet & levelSet)
{
  const Index          lower = levelSet.GetLower();
  const Index          size = levelSet.GetSize();
  const double         width = levelSet.GetWidth();
  std::vector<float> & values = levelSet.Values();
  std::vector<char>    inside(values.size());
  ParallelFor(size[2], 1, [&](std::size_t begin, std::size_t end) {
    for (int k = int(begin); k < int(end); ++k)
    {
      for (int j = 0; j < size[1]; ++j)
      {
        std::size_t n = (std::size_t(k) * size[1] + j) * size[0];
        for (int i = 0; i < size[0]; ++i, ++n)
        {
          inside[n] = image.AtNearest(Index{ { lower[0] + i, lower[1] + j, lower[2] + k } }) == material;
        }
      }
    }
  });

  std::vector<float> squares(values.size(), float(width * width));
  const Vector       spacing = image.grid.spacing;
  SweepAxis(0, spacing[0], width, size, inside, squares, values);
  SweepAxis(1, spacing[1], width, size, inside, values, squares);
  SweepAxis(2, spacing[2], width, size, inside, squares, values);
  ParallelFor(values.size(), 1 << 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      values[n] = (inside[n] ? 1.0f : -1.0f) * std::sqrt(values[n]);
    }
  });
}
} // namespace mmm
