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
#ifndef mmmIndicatorBricks_h
#define mmmIndicatorBricks_h

#include "base/Grid.h"

#include <cstdint>

namespace mmm
{
/** \brief The indicator of one material, stored where it varies.
 *
 * The grid is divided into bricks. Those in which the indicator is everywhere `outside`, or everywhere -`outside`, are
 * not stored but stand for that value. Beyond the border of the grid, values are those of the nearest node. A brick's
 * rows reach into the next brick, so that Width successive values from any of its nodes on lie side by side. */
class IndicatorBricks
{
public:
  static constexpr int Edge = 8;
  static constexpr int Width = 4;
  static constexpr int RowLength = Edge + Width - 1;

  /** The values times `scale` on a block of the grid; elsewhere the indicator is `outside`. */
  IndicatorBricks(const Grid & grid, const BlockView<const float> & block, float outside, float scale = 1.0f);

  /** The brick that a node lies in, along an axis, and its place there. Nodes may lie up to Edge beyond the grid. */
  static int
  BrickOf(int node)
  {
    return int(unsigned(node + Edge) / Edge);
  }
  static int
  PlaceOf(int node)
  {
    return int(unsigned(node + Edge) % Edge);
  }

  /** Whether the indicator is `outside` in a brick and all the next ones along the axes. */
  bool
  IsOutside(const Index & brick) const
  {
    for (int a = 0; a < 3; ++a)
    {
      if (brick[a] < m_First[a] || brick[a] - m_First[a] >= m_Count[a] - 1)
      {
        return true;
      }
    }
    return false;
  }

  /** The values of a brick, for bricks that are not IsOutside(), and the next ones along the second and third axis. */
  const float *
  Values(int i, int j, int k) const
  {
    return m_Values.data() + std::size_t(m_Numbers[this->Place(i, j, k)]) * Size;
  }
  /** The place of a row among a brick's values. */
  static constexpr int
  RowPlace(int j, int k)
  {
    return (k * Edge + j) * RowLength;
  }

  /** The value at a node of the grid. */
  float
  At(const Index & node) const
  {
    const Index brick{ { BrickOf(node[0]), BrickOf(node[1]), BrickOf(node[2]) } };
    if (this->IsOutside(brick))
    {
      return m_Values[0];
    }
    return this->Values(brick[0], brick[1], brick[2])[RowPlace(PlaceOf(node[1]), PlaceOf(node[2])) + PlaceOf(node[0])];
  }

  /** The nodes, from `lower` up to but without `upper`, beyond which the indicator is `outside`. */
  const Index &
  GetLower() const
  {
    return m_Lower;
  }
  const Index &
  GetUpper() const
  {
    return m_Upper;
  }

  /** Whether the indicator is `outside` at all nodes from `lower` up to but without `upper`, as far as bricks tell. */
  bool
  IsOutside(const Index & lower, const Index & upper) const;

  /** How many bricks have values of their own. */
  std::size_t
  GetNumberOfStoredBricks() const
  {
    return m_Values.size() / Size - FirstStored;
  }

private:
  static constexpr int Size = Edge * Edge * RowLength;
  enum Number : std::uint32_t
  {
    Outside,
    Inside,
    FirstStored
  };

  std::size_t
  Place(int i, int j, int k) const
  {
    return (std::size_t(k - m_First[2]) * m_Count[1] + (j - m_First[1])) * m_Count[0] + (i - m_First[0]);
  }

  Index                      m_Lower;
  Index                      m_Upper;
  Index                      m_First;
  Index                      m_Count;
  std::vector<std::uint32_t> m_Numbers; // per brick, its place among the stored ones
  std::vector<float>         m_Values;
};
} // namespace mmm

#endif
