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
namespace
{
/** A sum for each set of the seven upper samples. */
class SimplexCounts
{
public:
  SimplexCounts()
  {
    for (unsigned same = 0; same < m_Counts.size(); ++same)
    {
      m_Counts[same] = Sum([same](int n) { return (same >> (n - 1) & 1) != 0; });
    }
  }
  int
  operator[](unsigned same) const
  {
    return m_Counts[same];
  }

private:
  template <typename TIsSame>
  static int
  Sum(const TIsSame & isSame)
  {
    int sum = 1;
    for (int a = 1; a < 8; ++a)
    {
      if (isSame(a))
      {
        --sum;
        for (int b = a + 1; b < 8; ++b)
        {
          if (isSame(b) && (a & b) == a)
          {
            ++sum;
            sum -= b != 7 && isSame(7);
          }
        }
      }
    }
    return sum;
  }

  std::array<int, 128> m_Counts{};
};
} // namespace

int
CountSimplices(unsigned same)
{
  static const SimplexCounts counts;
  return counts[same];
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
    const Material own = samples[grid.Offset(at)];
    unsigned       same = 0;
    for (int n = 1; n < 8; ++n)
    {
      const Index other{ { at[0] + (n & 1), at[1] + (n >> 1 & 1), at[2] + (n >> 2) } };
      same |= unsigned(grid.Contains(other) && samples[grid.Offset(other)] == own) << (n - 1);
    }
    const int count = CountSimplices(same);
    if (count != 0)
    {
      add(own, count);
    }
  });
}
} // namespace mmm
