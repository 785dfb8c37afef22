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
#include "topology/SampleCharacteristics.h"

#include "base/IndexBox.h"

#include <algorithm>

namespace mmm
{
int
CountSimplices(const std::array<bool, 8> & same)
{
  int sum = 1;
  for (int a = 1; a < 8; ++a)
  {
    if (same[a])
    {
      --sum;
      for (int b = a + 1; b < 8; ++b)
      {
        if (same[b] && (a & b) == a)
        {
          ++sum;
          sum -= b != 7 && same[7];
        }
      }
    }
  }
  return sum;
}

void
AddCharacteristicsOfSamples(const Index &                              size,
                            const std::vector<Material> &              samples,
                            const std::function<void(Material, int)> & add)
{
  if (std::all_of(samples.begin(), samples.end(), [&](Material m) { return m == samples[0]; }))
  {
    add(samples[0], 1);
    return;
  }
  const Grid grid{ size };
  IndexBox::Of(size).Visit([&](const Index & at) {
    const Material      own = samples[grid.Offset(at)];
    std::array<bool, 8> same;
    for (int n = 0; n < 8; ++n)
    {
      const Index other{ { at[0] + (n & 1), at[1] + (n >> 1 & 1), at[2] + (n >> 2) } };
      same[n] = grid.Contains(other) && samples[grid.Offset(other)] == own;
    }
    const int count = CountSimplices(same);
    if (count != 0)
    {
      add(own, count);
    }
  });
}
} // namespace mmm
