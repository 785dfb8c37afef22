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
#ifndef mmmIndexBox_h
#define mmmIndexBox_h

#include "base/Grid.h"

#include <algorithm>

namespace mmm
{
/** \brief Indices of nodes, samples or cells, those at both ends included. */
struct IndexBox
{
  Index lower;
  Index upper;

  /** From 0 up to but without `size`. */
  static IndexBox
  Of(const Index & size)
  {
    return { { { 0, 0, 0 } }, { { size[0] - 1, size[1] - 1, size[2] - 1 } } };
  }

  /** With a margin, as far as there are indices: from 0 up to but without `size`. */
  IndexBox
  Grown(int margin, const Index & size) const
  {
    IndexBox grown;
    for (int a = 0; a < 3; ++a)
    {
      grown.lower[a] = std::max(0, lower[a] - margin);
      grown.upper[a] = std::min(size[a] - 1, upper[a] + margin);
    }
    return grown;
  }

  Index
  Size() const
  {
    return { { upper[0] - lower[0] + 1, upper[1] - lower[1] + 1, upper[2] - lower[2] + 1 } };
  }

  bool
  Contains(const Index & index) const
  {
    for (int a = 0; a < 3; ++a)
    {
      if (index[a] < lower[a] || index[a] > upper[a])
      {
        return false;
      }
    }
    return true;
  }

  /** Calls visit(index), the first index fastest. */
  template <typename TVisitor>
  void
  Visit(TVisitor && visit) const
  {
    for (int k = lower[2]; k <= upper[2]; ++k)
    {
      for (int j = lower[1]; j <= upper[1]; ++j)
      {
        for (int i = lower[0]; i <= upper[0]; ++i)
        {
          visit(Index{ { i, j, k } });
        }
      }
    }
  }
};
} // namespace mmm

#endif
