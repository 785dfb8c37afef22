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
#ifndef mmmSliceBorders_h
#define mmmSliceBorders_h

#include "image/MaterialImage.h"
#include "image/SliceSides.h"

#include <limits>
#include <map>
#include <utility>

namespace mmm
{
/** The borders of pairs of materials in both slices, each only in a window around the pixels that ask for it. */
class SliceBorders
{
public:
  SliceBorders(const SlicePlane & plane, const BothSides<MaterialDistances> & distances)
    : m_Plane(plane)
    , m_Distances(distances)
  {}

  /** Says that a pixel will ask for a pair. */
  void
  Enlarge(Material first, Material second, std::size_t pixel);

  void
  Compute();

  BothSides<double>
  At(Material first, Material second, std::size_t pixel) const
  {
    const Window &    window = m_Windows.at({ first, second });
    const std::size_t at =
      window.Offset(int(pixel % std::size_t(m_Plane.size[0])), int(pixel / std::size_t(m_Plane.size[0])));
    return { { window.distances[0][at], window.distances[1][at] } };
  }

private:
  struct Window
  {
    std::array<int, 2> lower{ { std::numeric_limits<int>::max(), std::numeric_limits<int>::max() } };
    std::array<int, 2> upper{ { -1, -1 } };

    BothSides<std::vector<float>> distances;

    std::size_t
    Offset(int i, int j) const
    {
      return std::size_t(j - lower[1]) * std::size_t(upper[0] - lower[0] + 1) + std::size_t(i - lower[0]);
    }
  };

  std::vector<float>
  SignedDistances(const Window & window, const std::vector<float> & first, const std::vector<float> & second) const;

  const SlicePlane &                              m_Plane;
  const BothSides<MaterialDistances> &            m_Distances;
  std::map<std::pair<Material, Material>, Window> m_Windows;
};
} // namespace mmm

#endif
