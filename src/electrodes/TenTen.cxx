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
#include "electrodes/TenTen.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace mmm
{
namespace
{
constexpr int    Steps = 400;
constexpr double Step = 0.5; // voxels
constexpr int    Halvings = 16;
constexpr int    CzRounds = 5;

/** Whether x is outside of the head, or of the image: where that cuts the head, interpolation goes on beyond it. */
bool
IsOutside(const Skin & skin, const Vector & x)
{
  const Grid & grid = skin.GetGrid();
  for (int a = 0; a < 3; ++a)
  {
    if (x[a] < grid.LowerFace(a) || x[a] > grid.UpperFace(a))
    {
      return true;
    }
  }
  return skin.Height(x) > 0.0;
}

/** Where a ray leaves the head for good. */
Vector
Leave(const Skin & skin, const Vector & origin, const Vector & direction)
{
  const Grid & grid = skin.GetGrid();
  const Vector extent = grid.Position(grid.size);
  double       outside = extent.norm();
  double       inside = outside - Step;
  const auto   isOutside = [&](double length) { return IsOutside(skin, origin + length * direction); };
  while (inside > 0.0 && isOutside(inside))
  {
    outside = inside;
    inside -= Step;
  }
  for (int n = 0; n < Halvings; ++n)
  {
    const double middle = 0.5 * (inside + outside);
    (isOutside(middle) ? outside : inside) = middle;
  }
  return origin + inside * direction;
}

/** The arc from nasion to inion through Cz, which is in the middle of it and of that from ear to ear. */
SkinArc
FindSagittal(const Skin &   skin,
             const Vector & nasion,
             const Vector & inion,
             const Vector & left,
             const Vector & right,
             const Vector & up)
{
  const Vector middle = 0.25 * (nasion + inion + left + right);
  Vector       cz = Leave(skin, middle, up.normalized());
  for (int round = 0; round < CzRounds; ++round)
  {
    cz = SkinArc(skin, nasion, cz, inion).At(0.5);
    cz = SkinArc(skin, left, cz, right).At(0.5);
  }
  return { skin, nasion, cz, inion };
}

/** Letters and number of a site, such as "FC" and 3; "Cz" has the number 0, and what is none -1. */
std::pair<std::string, int>
Split(const std::string & site)
{
  const std::string row = site.substr(0, site.size() - std::min<std::size_t>(1, site.size()));
  const char        last = site.empty() ? ' ' : site.back();
  return { row, last == 'z' ? 0 : last >= '1' && last <= '8' ? last - '0' : -1 };
}
} // namespace

SkinArc::SkinArc(const Skin & skin, const Vector & first, const Vector & second, const Vector & last)
{
  // around the middle of the chord, from the first over the second
  const Vector origin = 0.5 * (first + last);
  const Vector start = (first - origin).normalized();
  const Vector over = ((second - origin) - start * start.dot(second - origin)).normalized();
  for (int n = 0; n <= Steps; ++n)
  {
    const double angle = EIGEN_PI * n / Steps;
    m_Points.push_back(Leave(skin, origin, std::cos(angle) * start + std::sin(angle) * over));
    m_Lengths.push_back(n == 0 ? 0.0 : m_Lengths.back() + (m_Points[n] - m_Points[n - 1]).norm());
  }
}

Vector
SkinArc::At(double fraction) const
{
  const double length = fraction * m_Lengths.back();
  const auto   next = std::upper_bound(m_Lengths.begin() + 1, m_Lengths.end() - 1, length) - m_Lengths.begin();
  const double t = (length - m_Lengths[next - 1]) / std::max(m_Lengths[next] - m_Lengths[next - 1], 1e-12);
  return (1.0 - t) * m_Points[next - 1] + t * m_Points[next];
}

TenTen::TenTen(const Skin &   skin,
               const Vector & nasion,
               const Vector & inion,
               const Vector & left,
               const Vector & right,
               const Vector & up)
  : m_Skin(skin)
  , m_Sagittal(FindSagittal(skin, nasion, inion, left, right, up))
  , m_Left(skin, m_Sagittal.At(0.1), SkinArc(skin, left, m_Sagittal.At(0.5), right).At(0.1), m_Sagittal.At(0.9))
  , m_Right(skin, m_Sagittal.At(0.1), SkinArc(skin, left, m_Sagittal.At(0.5), right).At(0.9), m_Sagittal.At(0.9))
{}

std::optional<Vector>
TenTen::Find(const std::string & site) const
{
  // tenths from front to back
  static const std::map<std::string, int> rows = { { "Fp", 1 }, { "AF", 2 }, { "F", 3 },  { "FC", 4 },
                                                   { "FT", 4 }, { "C", 5 },  { "T", 5 },  { "CP", 6 },
                                                   { "TP", 6 }, { "P", 7 },  { "PO", 8 }, { "O", 9 } };
  const auto [letters, number] = Split(site);
  const auto row = rows.find(letters);
  if (row == rows.end() || number < 0)
  {
    return std::nullopt;
  }
  const double tenths = 0.1 * row->second;
  if (number == 0)
  {
    return letters.find('T') == std::string::npos ? std::optional<Vector>(m_Sagittal.At(tenths)) : std::nullopt;
  }
  const bool      isEnd = row->second == 1 || row->second == 9;
  const bool      isTemporal = letters.find('T') != std::string::npos;
  const bool      isMiddleRow = row->second >= 4 && row->second <= 6;
  const bool      isLeft = number % 2 == 1;
  const SkinArc & side = isLeft ? m_Left : m_Right;
  if (isEnd)
  {
    // at tenths of the arcs at the sides, beside the middle
    return number > 2 ? std::nullopt : std::optional<Vector>(side.At(row->second == 1 ? 0.1 : 0.9));
  }
  if (number >= 7 ? isMiddleRow != isTemporal : isTemporal)
  {
    return std::nullopt;
  }
  // 7 5 3 1 z 2 4 6 8
  const int eighths = isLeft ? (7 - number) / 2 : 8 - (8 - number) / 2;
  return SkinArc(m_Skin, m_Left.At(tenths), m_Sagittal.At(tenths), m_Right.At(tenths)).At(0.125 * eighths);
}
} // namespace mmm
