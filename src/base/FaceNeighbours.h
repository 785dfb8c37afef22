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
#ifndef mmmFaceNeighbours_h
#define mmmFaceNeighbours_h

#include "base/Grid.h"

namespace mmm
{
/** Calls body(index) for the nodes of a grid across the six faces of one. */
template <typename TBody>
void
ForEachFaceNeighbour(const Grid & grid, const Index & at, const TBody & body)
{
  for (int a = 0; a < 3; ++a)
  {
    for (const int step : { -1, 1 })
    {
      Index beside = at;
      beside[a] += step;
      if (grid.Contains(beside))
      {
        body(beside);
      }
    }
  }
}
} // namespace mmm

#endif
