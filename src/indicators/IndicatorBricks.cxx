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
#include "indicators/IndicatorBricks.h"

#include "base/Parallel.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
/** Values this close to that of a brick that is not stored are taken for it. */
constexpr float Tolerance = 1e-5f;
} // namespace

IndicatorBricks::IndicatorBricks(const Grid & grid, const BlockView<const float> & block, float outside, float scale)
  : m_Lower(block.lower)
{
  std::size_t count = 1;
  for (int a = 0; a < 3; ++a)
  {
    m_Upper[a] = block.lower[a] + block.size[a];
    // stencils that touch the block start and end in bricks of the table, those beyond the border included
    m_First[a] = BrickOf(block.lower[a] - Width);
    m_Count[a] = BrickOf(m_Upper[a] + Width) - m_First[a] + 2;
    count *= m_Count[a];
  }
  m_Numbers.assign(count, Outside);
  m_Values.assign(2 * Size, outside);
  std::fill(m_Values.begin() + Size, m_Values.end(), -outside);

  const auto valueAt = [&](int i, int j, int k) {
    const int node[3] = { i, j, k };
    int       local[3];
    for (int a = 0; a < 3; ++a)
    {
      local[a] = std::min(std::max(node[a], 0), grid.size[a] - 1) - block.lower[a];
      if (local[a] < 0 || local[a] >= block.size[a])
      {
        return outside;
      }
    }
    const auto place = (std::size_t(local[2]) * block.size[1] + local[1]) * block.size[0] + local[0];
    return block.values[place] * scale;
  };
  const auto forEachBrick = [&](const auto & body) {
    const auto perLayer = std::size_t(m_Count[0]) * m_Count[1];
    ParallelFor(m_Count[2], 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t brick = begin * perLayer; brick < end * perLayer; ++brick)
      {
        const auto inLayer = int(brick % perLayer);
        body(brick,
             (inLayer % m_Count[0] + m_First[0] - 1) * Edge,
             (inLayer / m_Count[0] + m_First[1] - 1) * Edge,
             (int(brick / perLayer) + m_First[2] - 1) * Edge);
      }
    });
  };

  forEachBrick([&](std::size_t brick, int x, int y, int z) {
    const float first = valueAt(x, y, z);
    const float level = std::abs(first - outside) < Tolerance ? outside : -outside;
    bool        constant = true;
    for (int k = 0; k < Edge && constant; ++k)
    {
      for (int j = 0; j < Edge && constant; ++j)
      {
        for (int i = 0; i < RowLength && constant; ++i)
        {
          constant = std::abs(valueAt(x + i, y + j, z + k) - level) < Tolerance;
        }
      }
    }
    m_Numbers[brick] = !constant ? FirstStored : (level == outside ? Outside : Inside);
  });
  std::uint32_t next = FirstStored;
  for (auto & number : m_Numbers)
  {
    if (number == FirstStored)
    {
      number = next++;
    }
  }
  m_Values.resize(std::size_t(next) * Size);
  forEachBrick([&](std::size_t brick, int x, int y, int z) {
    if (m_Numbers[brick] < FirstStored)
    {
      return;
    }
    float * value = m_Values.data() + std::size_t(m_Numbers[brick]) * Size;
    for (int k = 0; k < Edge; ++k)
    {
      for (int j = 0; j < Edge; ++j)
      {
        for (int i = 0; i < RowLength; ++i)
        {
          *value++ = valueAt(x + i, y + j, z + k);
        }
      }
    }
  });
}

bool
IndicatorBricks::IsOutside(const Index & lower, const Index & upper) const
{
  Index first;
  Index last;
  for (int a = 0; a < 3; ++a)
  {
    first[a] = std::max(BrickOf(lower[a]), m_First[a]);
    last[a] = std::min(BrickOf(upper[a] - 1), m_First[a] + m_Count[a] - 1);
  }
  for (int k = first[2]; k <= last[2]; ++k)
  {
    for (int j = first[1]; j <= last[1]; ++j)
    {
      for (int i = first[0]; i <= last[0]; ++i)
      {
        if (m_Numbers[this->Place(i, j, k)] != Outside)
        {
          return false;
        }
      }
    }
  }
  return true;
}
} // namespace mmm
