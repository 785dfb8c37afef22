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
#ifndef mmmPointBins_h
#define mmmPointBins_h

#include "base/Grid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace mmm
{
/** \brief Points sorted into cubic bins, to find those near a place in constant time.
 *
 * Bins are larger than asked for where there would be too many of them. */
class PointBins
{
public:
  /** `edge` is that of a bin, in units of the smallest voxel spacing. */
  explicit PointBins(const Grid & grid, double edge = 2.0)
    : m_Edge(edge)
  {
    double volume = 1.0;
    for (int a = 0; a < 3; ++a)
    {
      volume *= grid.UpperFace(a) - grid.LowerFace(a);
    }
    // as many as grid nodes, and some for small grids
    m_Edge = std::max(edge, std::cbrt(volume / (double(grid.NumberOfNodes()) + 1e5)));
    for (int a = 0; a < 3; ++a)
    {
      m_Origin[a] = grid.LowerFace(a);
      m_Bins[a] = std::max(1, int(std::ceil((grid.UpperFace(a) - m_Origin[a]) / m_Edge)));
    }
  }

  void
  Assign(const std::vector<Vector> & points)
  {
    m_Start.assign(std::size_t(m_Bins[0]) * m_Bins[1] * m_Bins[2] + 1, 0);
    m_Points.resize(points.size());
    std::vector<std::uint32_t> bins(points.size());
    for (std::size_t p = 0; p < points.size(); ++p)
    {
      bins[p] = std::uint32_t(this->BinAt(points[p]));
      ++m_Start[bins[p] + 1];
    }
    for (std::size_t b = 1; b < m_Start.size(); ++b)
    {
      m_Start[b] += m_Start[b - 1];
    }
    std::vector<std::uint32_t> next(m_Start.begin(), m_Start.end() - 1);
    for (std::size_t p = 0; p < points.size(); ++p)
    {
      m_Points[next[bins[p]]++] = std::uint32_t(p);
    }
  }

  /** Calls visit(point) for every point of the bins that a ball touches, in an order that depends on the points only.
   */
  template <typename TVisitor>
  void
  Visit(const Vector & centre, double radius, TVisitor && visit) const
  {
    this->VisitRows(centre, radius, [&](std::size_t first, std::size_t last) {
      for (auto p = m_Start[first]; p < m_Start[last + 1]; ++p)
      {
        visit(m_Points[p]);
      }
    });
  }

  /** Calls visit(bin) for every bin that a ball touches. */
  template <typename TVisitor>
  void
  VisitBins(const Vector & centre, double radius, TVisitor && visit) const
  {
    this->VisitRows(centre, radius, [&](std::size_t first, std::size_t last) {
      for (std::size_t bin = first; bin <= last; ++bin)
      {
        visit(bin);
      }
    });
  }

  std::size_t
  BinAt(const Vector & x) const
  {
    return (std::size_t(this->Coordinate(x[2], 2)) * m_Bins[1] + this->Coordinate(x[1], 1)) * m_Bins[0] +
           this->Coordinate(x[0], 0);
  }
  std::size_t
  NumberOfBins() const
  {
    return std::size_t(m_Bins[0]) * m_Bins[1] * m_Bins[2];
  }

private:
  /** Calls visit(first, last) for each row of bins along x that a ball touches. */
  template <typename TVisitor>
  void
  VisitRows(const Vector & centre, double radius, TVisitor && visit) const
  {
    int low[3];
    int high[3];
    for (int a = 0; a < 3; ++a)
    {
      low[a] = this->Coordinate(centre[a] - radius, a);
      high[a] = this->Coordinate(centre[a] + radius, a);
    }
    for (int k = low[2]; k <= high[2]; ++k)
    {
      for (int j = low[1]; j <= high[1]; ++j)
      {
        const std::size_t row = (std::size_t(k) * m_Bins[1] + j) * m_Bins[0];
        visit(row + low[0], row + high[0]);
      }
    }
  }
  int
  Coordinate(double x, int axis) const
  {
    const double bin = std::floor((x - m_Origin[axis]) / m_Edge);
    return int(std::min(std::max(bin, 0.0), m_Bins[axis] - 1.0));
  }

  double                     m_Edge;
  Vector                     m_Origin;
  Index                      m_Bins;
  std::vector<std::uint32_t> m_Start;
  std::vector<std::uint32_t> m_Points;
};
} // namespace mmm

#endif
