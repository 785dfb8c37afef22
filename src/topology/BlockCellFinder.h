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

#include "topology/BlockComplex.h"

#include <algorithm>
#include <limits>
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
    return m_Corners;
  }
  /** Calls visit(cell) for the cells that the convex hull of the corners meets. It leaves out rows of cells, the first
   * index from `first` to `last`, for which wantsRow(first, last, j, k) is false. */
  template <typename TWantsRow, typename TVisitor>
  void
  Visit(const TWantsRow & wantsRow, const TVisitor & visit)
  {
    const Interval along = IntervalOf(0, m_Corners);
    int            first;
    int            last;
    m_Blocks.CellsOf(0, along.lower, along.upper, first, last);
    this->VisitSlabs(2, m_Corners, [&](int k, double begin, double end) {
      m_Slab.clear();
      VisitPart(m_Corners, 2, begin, end, [this](const Vector & x) { m_Slab.push_back(x); });
      this->VisitSlabs(1, m_Slab, [&](int j, double beginOfRod, double endOfRod) {
        if (wantsRow(first, last, j, k))
        {
          Interval rod;
          VisitPart(m_Slab, 1, beginOfRod, endOfRod, [&](const Vector & x) { rod.Add(x[0]); });
          this->VisitCells(0, rod, [&](int i, double, double) { visit(Index{ { i, j, k } }); });
        }
      });
    });
  }

private:
  struct Interval
  {
    double lower{ std::numeric_limits<double>::max() };
    double upper{ std::numeric_limits<double>::lowest() };

    void
    Add(double x)
    {
      lower = std::min(lower, x);
      upper = std::max(upper, x);
    }
  };

  static Interval
  IntervalOf(int axis, const std::vector<Vector> & body)
  {
    Interval interval;
    for (const Vector & x : body)
    {
      interval.Add(x[axis]);
    }
    return interval;
  }

  /** Calls visit(c, begin, end) for the cells along an axis that a body meets, and where they begin and end. */
  template <typename TVisitor>
  void
  VisitSlabs(int axis, const std::vector<Vector> & body, const TVisitor & visit) const
  {
    this->VisitCells(axis, IntervalOf(axis, body), visit);
  }

  template <typename TVisitor>
  void
  VisitCells(int axis, const Interval & interval, const TVisitor & visit) const
  {
    int first;
    int last;
    m_Blocks.CellsOf(axis, interval.lower, interval.upper, first, last);
    for (int c = first; c <= last; ++c)
    {
      const double begin = c & 1 ? 0.5 * (c + 1) : c == 0 ? interval.lower : 0.5 * c;
      const double end = c & 1 ? begin : c / 2 + 1 == m_Blocks.Blocks().size[axis] ? interval.upper : 0.5 * c + 1.0;
      if (end >= interval.lower && begin <= interval.upper)
      {
        visit(c, begin, end);
      }
    }
  }

  /** Calls visit(x) for points whose hull is the part of a hull between two planes. The same for a part of the points
   * gives a part of these. */
  template <typename TVisitor>
  static void
  VisitPart(const std::vector<Vector> & body, int axis, double begin, double end, const TVisitor & visit)
  {
    for (const Vector & a : body)
    {
      if (a[axis] < begin)
      {
        for (const Vector & b : body)
        {
          if (b[axis] > begin)
          {
            visit(Cut(a, b, axis, begin));
          }
        }
      }
      else if (a[axis] <= end)
      {
        visit(a);
      }
      else if (begin != end)
      {
        for (const Vector & b : body)
        {
          if (b[axis] < end)
          {
            visit(Cut(b, a, axis, end));
          }
        }
      }
    }
  }

  /** Where an edge from below a plane to above it is on the plane. */
  static Vector
  Cut(const Vector & a, const Vector & b, int axis, double at)
  {
    Vector x = a + (at - a[axis]) / (b[axis] - a[axis]) * (b - a);
    x[axis] = at;
    return x;
  }

  const BlockComplex & m_Blocks;
  std::vector<Vector>  m_Corners;
  /** What is of them between two planes. */
  std::vector<Vector> m_Slab;
};
} // namespace mmm

#endif
