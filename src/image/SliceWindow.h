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
#ifndef mmmSliceWindow_h
#define mmmSliceWindow_h

#include "image/SliceDistance.h"

#include <algorithm>

namespace mmm
{
/** \brief A rectangle of a slice's pixels, which has a plane of its own. It is empty at first. */
class SliceWindow
{
public:
  explicit SliceWindow(const SlicePlane & slice)
    : m_Slice(slice)
    , m_Lower(slice.size)
  {}

  /** Grows around a pixel by a margin, as far as the slice goes. */
  void
  Include(std::size_t pixel, int margin)
  {
    const auto at = this->At(pixel);
    for (int a = 0; a < 2; ++a)
    {
      m_Lower[a] = std::min(m_Lower[a], std::max(0, at[a] - margin));
      m_Upper[a] = std::max(m_Upper[a], std::min(m_Slice.size[a] - 1, at[a] + margin));
    }
  }

  SlicePlane
  Plane() const
  {
    return { { { m_Upper[0] - m_Lower[0] + 1, m_Upper[1] - m_Lower[1] + 1 } }, m_Slice.spacing };
  }

  /** The place in the window's plane of a pixel of the slice. */
  std::size_t
  Offset(std::size_t pixel) const
  {
    const auto at = this->At(pixel);
    return std::size_t(at[1] - m_Lower[1]) * std::size_t(m_Upper[0] - m_Lower[0] + 1) + std::size_t(at[0] - m_Lower[0]);
  }

  /** Calls visit(pixel) for the slice's pixels that are in the window, in the order of their places there. */
  template <typename TVisitor>
  void
  Visit(TVisitor && visit) const
  {
    for (int j = m_Lower[1]; j <= m_Upper[1]; ++j)
    {
      for (int i = m_Lower[0]; i <= m_Upper[0]; ++i)
      {
        visit(std::size_t(j) * std::size_t(m_Slice.size[0]) + std::size_t(i));
      }
    }
  }

private:
  std::array<int, 2>
  At(std::size_t pixel) const
  {
    const auto width = std::size_t(m_Slice.size[0]);
    return { { int(pixel % width), int(pixel / width) } };
  }

  SlicePlane         m_Slice;
  std::array<int, 2> m_Lower;
  std::array<int, 2> m_Upper{ { -1, -1 } };
};
} // namespace mmm

#endif
