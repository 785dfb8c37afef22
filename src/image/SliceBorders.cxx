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
  m_Borders.insert({ { first, second }, Border{ SliceWindow(m_Plane), {} } })
    .first->second.window.Include(pixel, WindowMargin);
}

void
SliceBorders::Compute()
{
  for (auto & [pair, border] : m_Borders)
  {
    for (int side = 0; side < SliceSides; ++side)
    {
      border.distances[side] =
        this->SignedDistances(border.window, m_Distances[side][pair.first], m_Distances[side][pair.second]);
    }
  }
}

std::vector<float>
SliceBorders::SignedDistances(const SliceWindow &        window,
                              const std::vector<float> & first,
                              const std::vector<float> & second) const
{
  const SlicePlane  plane = window.Plane();
  std::vector<char> nearerFirst;
  std::vector<char> nearerSecond;
  window.Visit([&](std::size_t pixel) {
    nearerFirst.push_back(first[pixel] < second[pixel]);
    nearerSecond.push_back(second[pixel] < first[pixel]);
  });
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
