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
#include "distance/TriangleTree.h"

#include <numeric>

namespace mmm
{
TriangleTree::TriangleTree(std::vector<Corners> triangles)
  : m_Triangles(std::move(triangles))
  , m_Order(m_Triangles.size())
{
  std::iota(m_Order.begin(), m_Order.end(), 0u);
  if (!m_Order.empty())
  {
    this->Build(0, std::uint32_t(m_Order.size()));
  }
}

std::uint32_t
TriangleTree::Build(std::uint32_t begin, std::uint32_t end)
{
  const auto number = std::uint32_t(m_Nodes.size());
  Node       node{ Vector::Constant(1e300), Vector::Constant(-1e300), begin, end, None };
  for (std::uint32_t n = begin; n < end; ++n)
  {
    for (const Vector & corner : m_Triangles[m_Order[n]])
    {
      node.lower = node.lower.cwiseMin(corner);
      node.upper = node.upper.cwiseMax(corner);
    }
  }
  m_Nodes.push_back(node);
  if (end - begin > LeafSize)
  {
    int longest = 0;
    (node.upper - node.lower).maxCoeff(&longest);
    const auto sum = [&](std::uint32_t t) {
      return m_Triangles[t][0][longest] + m_Triangles[t][1][longest] + m_Triangles[t][2][longest];
    };
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(m_Order.begin() + begin,
                     m_Order.begin() + middle,
                     m_Order.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) { return sum(a) != sum(b) ? sum(a) < sum(b) : a < b; });
    this->Build(begin, middle);
    const std::uint32_t second = this->Build(middle, end);
    m_Nodes[number].second = second;
  }
  return number;
}

/** Ericson, Real-Time Collision Detection, section 5.1.5. */
Vector
TriangleTree::ClosestPoint(const Corners & triangle, const Vector & x)
{
  const Vector & a = triangle[0];
  const Vector & b = triangle[1];
  const Vector & c = triangle[2];
  const Vector   ab = b - a;
  const Vector   ac = c - a;
  const double   d1 = ab.dot(x - a);
  const double   d2 = ac.dot(x - a);
  if (d1 <= 0.0 && d2 <= 0.0)
  {
    return a;
  }
  const double d3 = ab.dot(x - b);
  const double d4 = ac.dot(x - b);
  if (d3 >= 0.0 && d4 <= d3)
  {
    return b;
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
  {
    return a + d1 / (d1 - d3) * ab;
  }
  const double d5 = ab.dot(x - c);
  const double d6 = ac.dot(x - c);
  if (d6 >= 0.0 && d5 <= d6)
  {
    return c;
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
  {
    return a + d2 / (d2 - d6) * ac;
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
  {
    return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  }
  return a + (vb * ab + vc * ac) / (va + vb + vc);
}
} // namespace mmm
