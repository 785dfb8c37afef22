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
#include "distance/TriangleSurface.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace mmm
{
namespace
{
using Triangle = TriangleSurface::Triangle;

/** A side of a triangle: its ends, the lower one first, and whether the triangle passes them in this order. */
struct Side
{
  std::uint32_t first;
  std::uint32_t last;
  std::uint32_t triangle;
  bool          isForward;
};

void
JoinPoints(TriangleSurface & surface)
{
  std::vector<std::uint32_t> order(surface.points.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto isBefore = [&](std::uint32_t a, std::uint32_t b) {
    const Vector & p = surface.points[a];
    const Vector & q = surface.points[b];
    return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
  };
  std::stable_sort(order.begin(), order.end(), isBefore);
  std::vector<std::uint32_t> first(order.size());
  for (std::size_t n = 0; n < order.size(); ++n)
  {
    first[order[n]] = n > 0 && !isBefore(order[n - 1], order[n]) ? first[order[n - 1]] : order[n];
  }
  for (Triangle & triangle : surface.triangles)
  {
    for (std::uint32_t & corner : triangle)
    {
      corner = first[corner];
    }
  }
  const auto isFlat = [](const Triangle & t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; };
  surface.triangles.erase(std::remove_if(surface.triangles.begin(), surface.triangles.end(), isFlat),
                          surface.triangles.end());
}

/** Those of the same edge follow each other. */
std::vector<Side>
SidesOf(const std::vector<Triangle> & triangles)
{
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const std::uint32_t a = triangles[t][k];
      const std::uint32_t b = triangles[t][(k + 1) % 3];
      sides.push_back({ std::min(a, b), std::max(a, b), t, a < b });
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side & a, const Side & b) {
    return std::tie(a.first, a.last, a.triangle) < std::tie(b.first, b.last, b.triangle);
  });
  return sides;
}

/** Calls visit(first, end) for the sides of each edge. */
template <typename TVisitor>
void
ForEachEdge(const std::vector<Side> & sides, const TVisitor & visit)
{
  for (auto first = sides.begin(); first != sides.end();)
  {
    const auto end = std::find_if(
      first, sides.end(), [&](const Side & side) { return side.first != first->first || side.last != first->last; });
    visit(first, end);
    first = end;
  }
}

/** Turns triangles, each connected part as most of it is. */
class Orienter
{
public:
  Orienter(std::vector<Triangle> & triangles, const std::vector<Side> & sides)
    : m_Triangles(triangles)
    , m_Neighbours(triangles.size())
    , m_State(triangles.size(), State::Unseen)
  {
    ForEachEdge(sides, [this](auto first, auto end) {
      if (end - first == 2)
      {
        const bool agree = first[0].isForward != first[1].isForward;
        m_Neighbours[first[0].triangle].push_back({ first[1].triangle, agree });
        m_Neighbours[first[1].triangle].push_back({ first[0].triangle, agree });
      }
    });
  }

  std::size_t
  Run()
  {
    std::size_t turned = 0;
    for (std::uint32_t t = 0; t < m_Triangles.size(); ++t)
    {
      turned += m_State[t] == State::Unseen ? this->OrientPartOf(t) : 0;
    }
    return turned;
  }

private:
  enum class State : unsigned char
  {
    Unseen,
    Kept,
    Turned
  };

  std::size_t
  OrientPartOf(std::uint32_t start)
  {
    std::vector<std::uint32_t> part{ start };
    m_State[start] = State::Kept;
    for (std::size_t n = 0; n < part.size(); ++n)
    {
      for (const auto & [neighbour, agrees] : m_Neighbours[part[n]])
      {
        if (m_State[neighbour] == State::Unseen)
        {
          m_State[neighbour] = (m_State[part[n]] == State::Kept) == agrees ? State::Kept : State::Turned;
          part.push_back(neighbour);
        }
      }
    }
    const auto isTurned = [this](std::uint32_t t) { return m_State[t] == State::Turned; };
    const auto count = std::size_t(std::count_if(part.begin(), part.end(), isTurned));
    const bool areMostTurned = 2 * count > part.size();
    for (const std::uint32_t t : part)
    {
      if (isTurned(t) != areMostTurned)
      {
        std::swap(m_Triangles[t][1], m_Triangles[t][2]);
      }
    }
    return areMostTurned ? part.size() - count : count;
  }

  std::vector<Triangle> &                                  m_Triangles;
  std::vector<std::vector<std::pair<std::uint32_t, bool>>> m_Neighbours;
  std::vector<State>                                       m_State;
};
} // namespace

SurfaceDefects
RepairSurface(TriangleSurface & surface)
{
  JoinPoints(surface);
  const auto     sides = SidesOf(surface.triangles);
  SurfaceDefects defects;
  ForEachEdge(sides, [&](auto first, auto end) {
    if (end - first == 1)
    {
      if (defects.boundaryEdges == 0)
      {
        defects.boundaryPlace = 0.5 * (surface.points[first->first] + surface.points[first->last]);
      }
      ++defects.boundaryEdges;
    }
    defects.branchingEdges += end - first > 2;
  });
  defects.turnedTriangles = Orienter(surface.triangles, sides).Run();
  return defects;
}
} // namespace mmm
