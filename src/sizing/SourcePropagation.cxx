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
#include "sizing/SourcePropagation.h"

#include "base/Parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace mmm
{
namespace
{
/** The directions of the sweeps, a bit an axis. Opposite octants follow each other. */
constexpr int Octants[8] = { 0, 7, 2, 5, 4, 3, 6, 1 };
/** Rows of nodes are swept together in tiles of this many along the second and third axis. */
constexpr int TileEdge = 16;

class Propagation
{
public:
  Propagation(const Grid &                grid,
              const std::vector<Source> & sources,
              double                      slope,
              const std::vector<float> &  nodeValues,
              PropagatedField &           field)
    : m_Grid(grid)
    , m_Sources(sources)
    , m_Slope(float(slope))
    , m_NodeValues(nodeValues)
    , m_Field(field)
    , m_Spacing(grid.spacing.cast<float>())
  {
    for (int a = 1; a < 3; ++a)
    {
      m_Tiles[a - 1] = (grid.size[a] + TileEdge - 1) / TileEdge;
    }
  }

  /** A source is handed to the 4 x 4 x 4 nodes around it first: where it is the best one for few nodes, none of the
   * nearest need be among them. */
  void
  PlaceSources()
  {
    if (!m_NodeValues.empty())
    {
      m_Field.values = m_NodeValues;
      for (std::size_t n = 0; n < m_NodeValues.size(); ++n)
      {
        if (std::isfinite(m_NodeValues[n]))
        {
          m_Field.sources[n] = std::uint32_t(m_Sources.size() + n);
        }
      }
    }
    // by planes, which are independent of one another
    const int                  planes = m_Grid.size[2];
    std::vector<std::uint32_t> starts(planes + 4, 0);
    std::vector<std::uint32_t> order(m_Sources.size());
    const auto                 firstPlane = [&](const Source & source) {
      return std::min(std::max(int(std::floor(source.position[2] / m_Spacing[2])) - 1, -3), planes - 1) + 3;
    };
    for (const Source & source : m_Sources)
    {
      ++starts[firstPlane(source) + 1];
    }
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    auto next = starts;
    for (std::uint32_t s = 0; s < m_Sources.size(); ++s)
    {
      order[next[firstPlane(m_Sources[s])]++] = s;
    }
    ParallelFor(planes, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k)
      {
        for (auto place = starts[k]; place < starts[k + 4]; ++place)
        {
          this->PlaceSource(order[place], int(k));
        }
      }
    });
  }

  /** Hands sources on along one octant: `direction` is +1 or -1 for each axis. Nodes take from those behind them, so
   * tiles side by side in a diagonal can be swept at the same time. */
  void
  Sweep(const Index & direction)
  {
    for (int diagonal = 0; diagonal <= m_Tiles[0] + m_Tiles[1] - 2; ++diagonal)
    {
      const int first = std::max(0, diagonal - m_Tiles[1] + 1);
      const int last = std::min(diagonal, m_Tiles[0] - 1);
      ParallelFor(last - first + 1, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t n = begin; n < end; ++n)
        {
          const int tile[2] = { first + int(n), diagonal - first - int(n) };
          this->SweepTile(direction, tile);
        }
      });
    }
  }

private:
  Source
  SourceOf(std::uint32_t number) const
  {
    if (number < m_Sources.size())
    {
      return m_Sources[number];
    }
    const std::size_t node = number - m_Sources.size();
    return { m_Grid.Position(m_Grid.IndexAt(node)).cast<float>(), m_NodeValues[node] };
  }

  void
  PlaceSource(std::uint32_t number, int k)
  {
    const Source & source = m_Sources[number];
    int            base[2];
    for (int a = 0; a < 2; ++a)
    {
      base[a] = int(std::floor(source.position[a] / m_Spacing[a])) - 1;
    }
    for (int j = std::max(base[1], 0); j < std::min(base[1] + 4, m_Grid.size[1]); ++j)
    {
      for (int i = std::max(base[0], 0); i < std::min(base[0] + 4, m_Grid.size[0]); ++i)
      {
        const Eigen::Vector3f x(i * m_Spacing[0], j * m_Spacing[1], k * m_Spacing[2]);
        const float           value = source.value + m_Slope * (x - source.position).norm();
        const auto            node = m_Grid.Offset(i, j, k);
        if (value < m_Field.values[node])
        {
          m_Field.values[node] = value;
          m_Field.sources[node] = number;
        }
      }
    }
  }

  void
  SweepTile(const Index & direction, const int * tile)
  {
    int from[2];
    int past[2];
    for (int a = 0; a < 2; ++a)
    {
      const int size = m_Grid.size[a + 1];
      const int low = (direction[a + 1] > 0 ? tile[a] : m_Tiles[a] - 1 - tile[a]) * TileEdge;
      const int high = std::min(low + TileEdge, size);
      from[a] = direction[a + 1] > 0 ? low : high - 1;
      past[a] = direction[a + 1] > 0 ? high : low - 1;
    }
    for (int k = from[1]; k != past[1]; k += direction[2])
    {
      for (int j = from[0]; j != past[0]; j += direction[1])
      {
        this->SweepRow(direction, j, k);
      }
    }
  }

  void
  SweepRow(const Index & direction, int j, int k)
  {
    const Index &                       size = m_Grid.size;
    const std::array<std::ptrdiff_t, 3> stride{ { 1, size[0], std::ptrdiff_t(size[0]) * size[1] } };
    std::ptrdiff_t                      behind[8];
    int                                 count = 0;
    const auto isFirst = [&](int axis, int at) { return at == (direction[axis] > 0 ? 0 : size[axis] - 1); };
    const int  edge = (isFirst(1, j) ? 2 : 0) | (isFirst(2, k) ? 4 : 0);
    // the neighbours behind in this row's own plane across the first axis come first: they are there for all nodes
    for (const int corner : { 2, 4, 6, 1, 3, 5, 7 })
    {
      if (!(corner & edge))
      {
        behind[count] = 0;
        for (int a = 0; a < 3; ++a)
        {
          behind[count] -= ((corner >> a) & 1) * direction[a] * stride[a];
        }
        ++count;
      }
    }
    const int         countAtStart = count / 2;
    const int         start = direction[0] > 0 ? 0 : size[0] - 1;
    const std::size_t row = m_Grid.Offset(0, j, k);
    Eigen::Vector3f   x(0.0f, j * m_Spacing[1], k * m_Spacing[2]);
    for (int i = start; i >= 0 && i < size[0]; i += direction[0])
    {
      const std::size_t n = row + i;
      x[0] = i * m_Spacing[0];
      float         best = m_Field.values[n];
      std::uint32_t bestSource = m_Field.sources[n];
      std::uint32_t lastSource = bestSource;
      for (int b = 0; b < (i == start ? countAtStart : count); ++b)
      {
        const std::uint32_t number = m_Field.sources[n + behind[b]];
        if (number == bestSource || number == lastSource || number == PropagatedField::NoSource)
        {
          continue;
        }
        lastSource = number;
        const Source source = this->SourceOf(number);
        const float  rest = best - source.value;
        if (rest > 0.0f)
        {
          const float square = (x - source.position).squaredNorm() * m_Slope * m_Slope;
          if (square < rest * rest)
          {
            best = source.value + std::sqrt(square);
            bestSource = number;
          }
        }
      }
      m_Field.values[n] = best;
      m_Field.sources[n] = bestSource;
    }
  }

  const Grid &                m_Grid;
  const std::vector<Source> & m_Sources;
  const float                 m_Slope;
  const std::vector<float> &  m_NodeValues;
  PropagatedField &           m_Field;
  const Eigen::Vector3f       m_Spacing;
  int                         m_Tiles[2];
};
} // namespace

PropagatedField
PropagateSources(const Grid &                grid,
                 const std::vector<Source> & sources,
                 double                      slope,
                 const std::vector<float> &  nodeValues)
{
  PropagatedField field;
  field.values.assign(grid.NumberOfNodes(), std::numeric_limits<float>::infinity());
  field.sources.assign(grid.NumberOfNodes(), PropagatedField::NoSource);
  Propagation propagation(grid, sources, slope, nodeValues, field);
  propagation.PlaceSources();
  for (const int bits : Octants)
  {
    const auto sign = [&](int a) { return (bits >> a) & 1 ? -1 : 1; };
    propagation.Sweep(Index{ { sign(0), sign(1), sign(2) } });
  }
  return field;
}
} // namespace mmm
