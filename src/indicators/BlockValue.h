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
#ifndef mmmBlockValue_h
#define mmmBlockValue_h

#include "base/Grid.h"

namespace mmm
{
/** The value of a block at a node of the grid, or null where the node is beyond the block. */
template <typename TBlock>
auto
FindValue(TBlock & block, const Index & node) -> decltype(block.values.data())
{
  Index at;
  for (int a = 0; a < 3; ++a)
  {
    at[a] = node[a] - block.lower[a];
    if (at[a] < 0 || at[a] >= block.size[a])
    {
      return nullptr;
    }
  }
  return block.values.data() + (std::size_t(at[2]) * block.size[1] + at[1]) * block.size[0] + at[0];
}
} // namespace mmm

#endif
