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
#include "electrodes/SkinPatch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mmm
{
namespace
{
/** Between lines. In voxels, as all lengths here. */
constexpr double Step = 0.5;
/** From line to line; a steeper skin falls away. */
constexpr double LongestRise = 2.0;
constexpr double Probe = 0.25;
constexpr int    Halvings = 16;
/** Of a cell's edge, for areas. */
constexpr int Parts = 4;
} // namespace

SkinFrame
MakeSkinFrame(const Skin & skin, const Vector & foot, const Vector & towards)
{
  SkinFrame frame{ foot, {} };
  frame.axes[2] = skin.Normal(foot);
  const auto inPlane = [&](const Vector & way) { return Vector(way - frame.axes[2] * frame.axes[2].dot(way)); };
  Vector     first = inPlane(towards - foot);
  if (first.norm() < 1e-3 * (towards - foot).norm())
  {
    // it goes straight up, so that any direction will do: that along the axis which is the farthest from the normal
    int least = 0;
    frame.axes[2].cwiseAbs().minCoeff(&least);
    first = inPlane(Vector::Unit(least));
  }
  frame.axes[0] = first.normalized();
  frame.axes[1] = frame.axes[2].cross(frame.axes[0]);
  return frame;
}

SkinPatch::SkinPatch(const Skin & skin, const SkinFrame & frame, double halfLength, double halfWidth)
{
  m_Half[0] = int(std::ceil(halfLength / Step)) + 1;
  m_Half[1] = int(std::ceil(halfWidth / Step)) + 1;
  m_Heights.assign(std::size_t(2 * m_Half[0] + 1) * (2 * m_Half[1] + 1), std::numeric_limits<double>::quiet_NaN());
  // from the middle outward, each line from what the one before has found
  At(0, 0) = 0.0;
  for (const int way : { -1, 1 })
  {
    for (int i = 1; i <= m_Half[0]; ++i)
    {
      this->Follow(skin, frame, way * i, 0, this->At(way * (i - 1), 0));
    }
  }
  for (int i = -m_Half[0]; i <= m_Half[0]; ++i)
  {
    for (const int way : { -1, 1 })
    {
      for (int j = 1; j <= m_Half[1]; ++j)
      {
        this->Follow(skin, frame, i, way * j, this->At(i, way * (j - 1)));
      }
    }
  }
}

void
SkinPatch::Follow(const Skin & skin, const SkinFrame & frame, int i, int j, double guess)
{
  if (std::isnan(guess))
  {
    return;
  }
  const auto height = [&](double z) { return skin.Height(frame.ToGrid({ i * Step, j * Step, z })); };
  double     outside = guess;
  while (height(outside) <= 0.0)
  {
    outside += Probe;
    if (outside > guess + LongestRise)
    {
      return;
    }
  }
  double inside = outside - Probe;
  while (height(inside) > 0.0)
  {
    outside = inside;
    inside -= Probe;
    if (inside < guess - LongestRise)
    {
      return;
    }
  }
  for (int n = 0; n < Halvings; ++n)
  {
    const double middle = 0.5 * (inside + outside);
    (height(middle) > 0.0 ? outside : inside) = middle;
  }
  this->At(i, j) = 0.5 * (inside + outside);
}

double
SkinPatch::Height(double u, double v) const
{
  const double at[2] = { std::min(std::max(u / Step, -double(m_Half[0])), double(m_Half[0])),
                         std::min(std::max(v / Step, -double(m_Half[1])), double(m_Half[1])) };
  int          base[2];
  double       t[2];
  for (int a = 0; a < 2; ++a)
  {
    base[a] = std::min(int(std::floor(at[a])), m_Half[a] - 1);
    t[a] = at[a] - base[a];
  }
  return (1.0 - t[1]) * ((1.0 - t[0]) * this->At(base[0], base[1]) + t[0] * this->At(base[0] + 1, base[1])) +
         t[1] * ((1.0 - t[0]) * this->At(base[0], base[1] + 1) + t[0] * this->At(base[0] + 1, base[1] + 1));
}

std::array<double, 2>
SkinPatch::Slope(double u, double v) const
{
  return { { (this->Height(u + Step, v) - this->Height(u - Step, v)) / (2.0 * Step),
             (this->Height(u, v + Step) - this->Height(u, v - Step)) / (2.0 * Step) } };
}

SkinPatch::Extent
SkinPatch::Measure(const std::function<bool(double, double)> & isIn) const
{
  constexpr double part = Step / Parts;
  Extent           extent;
  for (int j = -m_Half[1] * Parts; j < m_Half[1] * Parts; ++j)
  {
    for (int i = -m_Half[0] * Parts; i < m_Half[0] * Parts; ++i)
    {
      const double u = (i + 0.5) * part;
      const double v = (j + 0.5) * part;
      if (isIn(u, v))
      {
        const double height = this->Height(u, v);
        const auto   slope = this->Slope(u, v);
        extent.isComplete = extent.isComplete && !std::isnan(height);
        extent.lowest = std::min(extent.lowest, height);
        extent.highest = std::max(extent.highest, height);
        extent.area += part * part * std::sqrt(1.0 + slope[0] * slope[0] + slope[1] * slope[1]);
        extent.flatArea += part * part;
      }
    }
  }
  return extent;
}
} // namespace mmm
