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
#ifndef mmmTriangleTree_h
#define mmmTriangleTree_h

#include "base/Grid.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace mmm
{
/** \brief A tree of boxes around triangles, which finds the closest one. Line segments are triangles whose last two
 * corners are the same. */
class TriangleTree
{
public:
  using Corners = std::array<Vector, 3>;
  static constexpr std::uint32_t None = 0xffffffffu;

  struct Nearest
  {
    std::uint32_t triangle{ None };
    Vector        point{ Vector::Zero() };
    double        distance{ 0.0 };
  };

  explicit TriangleTree(std::vector<Corners> triangles);

  /** The closest point of those triangles for which accept(number) holds, if one is closer than `reach`. */
  template <typename TAccept>
  Nearest
  FindNearest(const Vector & x, double reach, const TAccept & accept) const
  {
    return this->FindNearest(x, reach, accept, [](std::uint32_t, const Vector &) { return true; });
  }

  /** The same, of triangles for whose point acceptPoint(number, point) holds, too. It is asked last. */
  template <typename TAccept, typename TAcceptPoint>
  Nearest
  FindNearest(const Vector & x, double reach, const TAccept & accept, const TAcceptPoint & acceptPoint) const;

  struct Node
  {
    Vector lower;
    Vector upper;
    /** Places in GetOrder(); the second child of an inner node, whose first one follows it. */
    std::uint32_t begin;
    std::uint32_t end;
    /** None if the node is a leaf. */
    std::uint32_t second;
  };

  /** Each before its children. */
  const std::vector<Node> &
  GetNodes() const
  {
    return m_Nodes;
  }
  /** The triangles' numbers, those of a node in sequence. */
  const std::vector<std::uint32_t> &
  GetOrder() const
  {
    return m_Order;
  }
  const Corners &
  GetTriangle(std::uint32_t number) const
  {
    return m_Triangles[number];
  }

private:
  static constexpr std::uint32_t LeafSize = 4;

  std::uint32_t
  Build(std::uint32_t begin, std::uint32_t end);
  static Vector
  ClosestPoint(const Corners & triangle, const Vector & x);
  double
  SquaredDistance(std::uint32_t node, const Vector & x) const
  {
    return (x - x.cwiseMax(m_Nodes[node].lower).cwiseMin(m_Nodes[node].upper)).squaredNorm();
  }

  std::vector<Corners>       m_Triangles;
  std::vector<std::uint32_t> m_Order;
  std::vector<Node>          m_Nodes;
};

template <typename TAccept, typename TAcceptPoint>
TriangleTree::Nearest
TriangleTree::FindNearest(const Vector &       x,
                          double               reach,
                          const TAccept &      accept,
                          const TAcceptPoint & acceptPoint) const
{
  Nearest nearest;
  double  best = reach * reach;
  // halving 2^32 triangles leaves at most as many nodes to visit
  std::uint32_t stack[64];
  int           waiting = 0;
  if (!m_Nodes.empty())
  {
    stack[waiting++] = 0;
  }
  while (waiting > 0)
  {
    const std::uint32_t number = stack[--waiting];
    if (this->SquaredDistance(number, x) >= best)
    {
      continue;
    }
    const Node & node = m_Nodes[number];
    if (node.second != None)
    {
      const bool firstIsNearer = this->SquaredDistance(number + 1, x) <= this->SquaredDistance(node.second, x);
      stack[waiting++] = firstIsNearer ? node.second : number + 1;
      stack[waiting++] = firstIsNearer ? number + 1 : node.second;
      continue;
    }
    for (std::uint32_t n = node.begin; n < node.end; ++n)
    {
      const std::uint32_t t = m_Order[n];
      if (!accept(t))
      {
        continue;
      }
      const Vector point = ClosestPoint(m_Triangles[t], x);
      const double distance = (point - x).squaredNorm();
      if (distance < best && acceptPoint(t, point))
      {
        best = distance;
        nearest.triangle = t;
        nearest.point = point;
      }
    }
  }
  nearest.distance = std::sqrt(best);
  return nearest;
}
} // namespace mmm

#endif
