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
#ifndef mmmBlockCellFinder_h
#define mmmBlockCellFinder_h

#include "mmmBlockComplex.h"

#include <algorithm>
#include <array>
#include <vector>

namespace mmm
{
/** \brief Finds the cells that simplices meet, in units of blocks.
 *
 * A cell that a part of a simplex meets is one that the simplex meets, rounding or not. */
class BlockCellFinder
{
public:
  explicit BlockCellFinder(const BlockComplex & blocks)
    : m_Blocks(blocks)
  {}

  std::vector<Vector> &
  Corners()
  {
    return m_Bodies[0];
  }
  /** Calls visit(cell) for the cells that the convex hull of the corners meets. */
  template <typename TVisitor>
  void
  Visit(const TVisitor & visit)
  {
    Index cell;
    this->VisitFrom(0, m_Bodies[0], cell, visit);
  }

private:
  template <typename TVisitor>
  void
  VisitFrom(int axis, const std::vector<Vector> & body, Index & cell, const TVisitor & visit)
  {
    double lower = body[0][axis];
    double upper = lower;
    for (const Vector & x : body)
    {
      lower = std::min(lower, x[axis]);
      upper = std::max(upper, x[axis]);
    }
    int first;
    int last;
    m_Blocks.CellsOf(axis, lower, upper, first, last);
    for (int c = first; c <= last; ++c)
    {
      const double begin = c & 1 ? 0.5 * (c + 1) : c == 0 ? lower : 0.5 * c;
      const double end = c & 1 ? begin : c / 2 + 1 == m_Blocks.Blocks().size[axis] ? upper : 0.5 * c + 1.0;
      if (end < lower || begin > upper)
      {
        continue;
      }
      cell[axis] = c;
      if (axis == 2)
      {
        visit(cell);
      }
      else if (begin <= lower && end >= upper)
      {
        this->VisitFrom(axis + 1, body, cell, visit);
      }
      else
      {
        Clip(body, axis, begin, end, m_Bodies[axis + 1]);
        this->VisitFrom(axis + 1, m_Bodies[axis + 1], cell, visit);
      }
    }
  }

  /** Points whose hull is the part of a hull between two planes. The same for a part of the points gives a part of
   * these. */
  static void
  Clip(const std::vector<Vector> & body, int axis, double begin, double end, std::vector<Vector> & part)
  {
    part.clear();
    for (const Vector & x : body)
    {
      if (x[axis] >= begin && x[axis] <= end)
      {
        part.push_back(x);
      }
    }
    for (const Vector & a : body)
    {
      for (const Vector & b : body)
      {
        if (a[axis] < begin && b[axis] > begin)
        {
          part.push_back(Cut(a, b, axis, begin));
        }
        if (begin != end && a[axis] < end && b[axis] > end)
        {
          part.push_back(Cut(a, b, axis, end));
        }
      }
    }
  }

  static Vector
  Cut(const Vector & a, const Vector & b, int axis, double at)
  {
    Vector x = a + (at - a[axis]) / (b[axis] - a[axis]) * (b - a);
    x[axis] = at;
    return x;
  }

  const BlockComplex & m_Blocks;
  /** What is left after each axis. */
  std::array<std::vector<Vector>, 3> m_Bodies;
};
} // namespace mmm

#endif
