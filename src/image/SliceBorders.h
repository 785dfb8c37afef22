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
#include "image/SliceWindow.h"

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
    const Border &    border = m_Borders.at({ first, second });
    const std::size_t at = border.window.Offset(pixel);
    return { { border.distances[0][at], border.distances[1][at] } };
  }

private:
  struct Border
  {
    SliceWindow                   window;
    BothSides<std::vector<float>> distances;
  };

  /** Of a window's pixels from the border between what is nearer to the first material and what is nearer to the
   * second. Where a window is all of one kind, the border is at least its margin away. */
  std::vector<float>
  SignedDistances(const SliceWindow &        window,
                  const std::vector<float> & first,
                  const std::vector<float> & second) const;

  const SlicePlane &                              m_Plane;
  const BothSides<MaterialDistances> &            m_Distances;
  std::map<std::pair<Material, Material>, Border> m_Borders;
};
} // namespace mmm

#endif
