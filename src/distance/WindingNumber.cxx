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
#include "distance/WindingNumber.h"

#include "base/Parallel.h"

#include <cmath>

namespace mmm
{
namespace
{
/** A node further away than this, in its radii, is a dipole. */
constexpr double FarInRadii = 3.0;

/** Van Oosterom and Strackee 1983. */
double
SolidAngle(const TriangleTree::Corners & triangle, const Vector & x)
{
  const Vector a = triangle[0] - x;
  const Vector b = triangle[1] - x;
  const Vector c = triangle[2] - x;
  const double la = a.norm();
  const double lb = b.norm();
  const double lc = c.norm();
  const double volume = a.dot(b.cross(c));
  return 2.0 * std::atan2(volume, la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}
} // namespace

WindingNumber::WindingNumber(const TriangleTree & tree)
  : m_Tree(tree)
  , m_Dipoles(tree.GetNodes().size())
{
  constexpr std::size_t grain = 256;
  ParallelFor(m_Dipoles.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      m_Dipoles[n] = this->MakeDipole(m_Tree.GetNodes()[n]);
    }
  });
}

WindingNumber::Dipole
WindingNumber::MakeDipole(const TriangleTree::Node & node) const
{
  Dipole dipole;
  double total = 0.0;
  for (std::uint32_t n = node.begin; n < node.end; ++n)
  {
    const auto & t = m_Tree.GetTriangle(m_Tree.GetOrder()[n]);
    const Vector area = 0.5 * (t[1] - t[0]).cross(t[2] - t[0]);
    const double size = area.norm();
    dipole.area += area;
    dipole.middle += size / 3.0 * (t[0] + t[1] + t[2]);
    total += size;
  }
  dipole.middle = total > 0.0 ? Vector(dipole.middle / total) : Vector(0.5 * (node.lower + node.upper));
  for (std::uint32_t n = node.begin; n < node.end; ++n)
  {
    for (const Vector & corner : m_Tree.GetTriangle(m_Tree.GetOrder()[n]))
    {
      dipole.radius = std::max(dipole.radius, (corner - dipole.middle).norm());
    }
  }
  return dipole;
}

double
WindingNumber::At(const Vector & x) const
{
  double angle = 0.0;
  // as in TriangleTree::FindNearest()
  std::uint32_t stack[64];
  int           waiting = 0;
  if (!m_Dipoles.empty())
  {
    stack[waiting++] = 0;
  }
  while (waiting > 0)
  {
    const std::uint32_t number = stack[--waiting];
    const Dipole &      dipole = m_Dipoles[number];
    const Vector        away = dipole.middle - x;
    const double        distance = away.norm();
    if (distance > FarInRadii * dipole.radius)
    {
      angle += dipole.area.dot(away) / (distance * distance * distance);
      continue;
    }
    const TriangleTree::Node & node = m_Tree.GetNodes()[number];
    if (node.second != TriangleTree::None)
    {
      stack[waiting++] = node.second;
      stack[waiting++] = number + 1;
      continue;
    }
    for (std::uint32_t n = node.begin; n < node.end; ++n)
    {
      angle += SolidAngle(m_Tree.GetTriangle(m_Tree.GetOrder()[n]), x);
    }
  }
  return angle / (4.0 * EIGEN_PI);
}
} // namespace mmm
