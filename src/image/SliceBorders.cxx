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
#include "image/SliceBorders.h"

#include <algorithm>

namespace mmm
{
namespace
{
/** Pixels around a window in which the borders of two materials are looked for. */
constexpr int WindowMargin = 8;
} // namespace

void
SliceBorders::Enlarge(Material first, Material second, std::size_t pixel)
{
  Window &  window = m_Windows[{ first, second }];
  const int at[] = { int(pixel % std::size_t(m_Plane.size[0])), int(pixel / std::size_t(m_Plane.size[0])) };
  for (int a = 0; a < 2; ++a)
  {
    window.lower[a] = std::min(window.lower[a], std::max(0, at[a] - WindowMargin));
    window.upper[a] = std::max(window.upper[a], std::min(m_Plane.size[a] - 1, at[a] + WindowMargin));
  }
}

void
SliceBorders::Compute()
{
  for (auto & [pair, window] : m_Windows)
  {
    for (int side = 0; side < SliceSides; ++side)
    {
      window.distances[side] =
        this->SignedDistances(window, m_Distances[side][pair.first], m_Distances[side][pair.second]);
    }
  }
}

/** Of a window's pixels from the border between what is nearer to the first material and what is nearer to the
 * second. Where a window is all of one kind, the border is at least its margin away. */
std::vector<float>
SliceBorders::SignedDistances(const Window &             window,
                              const std::vector<float> & first,
                              const std::vector<float> & second) const
{
  SlicePlane plane = m_Plane;
  for (int a = 0; a < 2; ++a)
  {
    plane.size[a] = window.upper[a] - window.lower[a] + 1;
  }
  std::vector<char> nearerFirst(plane.NumberOfPixels());
  std::vector<char> nearerSecond(plane.NumberOfPixels());
  for (int j = window.lower[1]; j <= window.upper[1]; ++j)
  {
    for (int i = window.lower[0]; i <= window.upper[0]; ++i)
    {
      const std::size_t n = std::size_t(j) * std::size_t(m_Plane.size[0]) + std::size_t(i);
      nearerFirst[window.Offset(i, j)] = first[n] < second[n];
      nearerSecond[window.Offset(i, j)] = second[n] < first[n];
    }
  }
  // the border is half a pixel before the first centre beyond it
  const float        far = float(WindowMargin * std::max(plane.spacing[0], plane.spacing[1]));
  const float        half = float(0.5 * std::min(plane.spacing[0], plane.spacing[1]));
  const auto         toFirst = DistancesToSet(plane, nearerFirst);
  const auto         toSecond = DistancesToSet(plane, nearerSecond);
  std::vector<float> distances(plane.NumberOfPixels());
  for (std::size_t n = 0; n < distances.size(); ++n)
  {
    distances[n] = nearerFirst[n]    ? std::min(toSecond[n], far + half) - half
                   : nearerSecond[n] ? half - std::min(toFirst[n], far + half)
                                     : 0.0F;
  }
  return distances;
}
} // namespace mmm
