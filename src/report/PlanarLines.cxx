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
#include "report/PlanarLines.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>

namespace mmm
{
namespace
{
/** Which edges leave each point. */
class Departures
{
public:
  /** Edges leave their first point, and if they are without direction their second one, too. */
  Departures(const std::vector<PlanarEdge> & edges, bool haveDirection)
    : m_Edges(edges)
    , m_IsUsed(edges.size(), false)
  {
    std::uint32_t most = 0;
    for (const PlanarEdge & edge : edges)
    {
      most = std::max({ most, edge[0], edge[1] });
    }
    m_Begin.assign(edges.empty() ? 1 : std::size_t(most) + 2, 0);
    const auto forEachStart = [&](auto visit) {
      for (std::uint32_t e = 0; e < edges.size(); ++e)
      {
        visit(edges[e][0], e);
        if (!haveDirection)
        {
          visit(edges[e][1], e);
        }
      }
    };
    forEachStart([&](std::uint32_t point, std::uint32_t) { ++m_Begin[point + 1]; });
    for (std::size_t p = 1; p < m_Begin.size(); ++p)
    {
      m_Begin[p] += m_Begin[p - 1];
    }
    m_Next = m_Begin;
    m_Leaving.resize(m_Begin.back());
    forEachStart([&](std::uint32_t point, std::uint32_t e) { m_Leaving[m_Next[point]++] = e; });
    m_Next = m_Begin;
  }

  bool
  IsUsed(std::uint32_t edge) const
  {
    return m_IsUsed[edge];
  }

  std::size_t
  Count(std::uint32_t point) const
  {
    return m_Begin[point + 1] - m_Begin[point];
  }

  std::size_t
  CountPoints() const
  {
    return m_Begin.size() - 1;
  }

  /** Follows edges that are not used yet for as long as there are some. */
  PlanarLine
  Walk(std::uint32_t point)
  {
    PlanarLine line{ point };
    while (true)
    {
      std::size_t & next = m_Next[point];
      while (next < m_Begin[point + 1] && m_IsUsed[m_Leaving[next]])
      {
        ++next;
      }
      if (next == m_Begin[point + 1])
      {
        return line;
      }
      const std::uint32_t edge = m_Leaving[next];
      m_IsUsed[edge] = true;
      point = m_Edges[edge][0] == point ? m_Edges[edge][1] : m_Edges[edge][0];
      line.push_back(point);
    }
  }

private:
  const std::vector<PlanarEdge> & m_Edges;
  std::vector<bool>               m_IsUsed;
  std::vector<std::size_t>        m_Begin;
  std::vector<std::size_t>        m_Next;
  std::vector<std::uint32_t>      m_Leaving;
};

/** A side of a cell, in its direction. */
struct Side
{
  int        label;
  PlanarEdge ends;
  /** 1 if the first end is the lower one, -1 if not. */
  int direction;

  bool
  operator<(const Side & other) const
  {
    return std::tie(label, ends) < std::tie(other.label, other.ends);
  }
};

std::vector<Side>
SidesOf(const std::vector<PlanarCell> & cells)
{
  std::vector<Side> sides;
  sides.reserve(4 * cells.size());
  for (const PlanarCell & cell : cells)
  {
    const std::size_t count = cell.CountCorners();
    for (std::size_t c = 0; c < count; ++c)
    {
      const std::uint32_t from = cell.corners[c];
      const std::uint32_t to = cell.corners[(c + 1) % count];
      sides.push_back({ cell.label, { { std::min(from, to), std::max(from, to) } }, from < to ? 1 : -1 });
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

/** As many edges come to each point as leave it, so that a walk ends where it began. */
std::vector<PlanarLine>
ClosedLines(const std::vector<PlanarEdge> & edges)
{
  std::vector<PlanarLine> lines;
  Departures              departures(edges, true);
  for (std::uint32_t e = 0; e < edges.size(); ++e)
  {
    if (!departures.IsUsed(e))
    {
      lines.push_back(departures.Walk(edges[e][0]));
      lines.back().pop_back();
    }
  }
  return lines;
}
} // namespace

std::map<int, std::vector<PlanarLine>>
OutlinesByLabel(const std::vector<PlanarCell> & cells)
{
  std::map<int, std::vector<PlanarEdge>> edges;
  const std::vector<Side>                sides = SidesOf(cells);
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end)
  {
    const Side & side = sides[begin];
    int          sum = 0;
    for (end = begin; end < sides.size() && !(side < sides[end]); ++end)
    {
      sum += sides[end].direction;
    }
    const PlanarEdge edge = sum > 0 ? side.ends : PlanarEdge{ { side.ends[1], side.ends[0] } };
    edges[side.label].insert(edges[side.label].end(), std::size_t(std::abs(sum)), edge);
  }
  std::map<int, std::vector<PlanarLine>> outlines;
  for (const auto & [label, edgesOfLabel] : edges)
  {
    outlines[label] = ClosedLines(edgesOfLabel);
  }
  return outlines;
}

std::vector<PlanarLine>
TrailsOf(const std::vector<PlanarEdge> & edges)
{
  std::vector<PlanarLine> lines;
  Departures              departures(edges, false);
  // lines have to begin or end at points with an odd number of edges; what is left then is closed
  for (const bool areOdd : { true, false })
  {
    for (std::uint32_t point = 0; point < departures.CountPoints(); ++point)
    {
      if (!areOdd || departures.Count(point) % 2 == 1)
      {
        PlanarLine line = departures.Walk(point);
        while (line.size() > 1)
        {
          lines.push_back(std::move(line));
          line = areOdd ? PlanarLine() : departures.Walk(point);
        }
      }
    }
  }
  return lines;
}
} // namespace mmm
