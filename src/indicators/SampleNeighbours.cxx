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
#include "indicators/SampleNeighbours.h"

namespace mmm
{
const std::array<Index, SampleNeighbours::Count> SampleNeighbours::Steps{ { { { 1, 0, 0 } },
                                                                            { { 0, 1, 0 } },
                                                                            { { 1, 1, 0 } },
                                                                            { { 0, 0, 1 } },
                                                                            { { 1, 0, 1 } },
                                                                            { { 0, 1, 1 } },
                                                                            { { 1, 1, 1 } },
                                                                            { { -1, 0, 0 } },
                                                                            { { 0, -1, 0 } },
                                                                            { { -1, -1, 0 } },
                                                                            { { 0, 0, -1 } },
                                                                            { { -1, 0, -1 } },
                                                                            { { 0, -1, -1 } },
                                                                            { { -1, -1, -1 } } } };

SampleNeighbours::SampleNeighbours()
{
  constexpr unsigned NumberOfSets = 1u << Count;
  for (int a = 0; a < Count; ++a)
  {
    for (int b = 0; b < Count; ++b)
    {
      for (int n = 0; n < Count; ++n)
      {
        m_Adjacent[a] |= unsigned(Of(Steps[a], n) == Steps[b]) << b;
      }
    }
  }
  m_IsDisk.resize(NumberOfSets);
  for (unsigned set = 0; set < NumberOfSets; ++set)
  {
    m_IsDisk[set] = this->CountParts(set) == 1 && this->CountParts(NumberOfSets - 1 - set) == 1;
  }
}

int
SampleNeighbours::CountParts(unsigned set) const
{
  int parts = 0;
  for (; set; ++parts)
  {
    unsigned part = set & (~set + 1);
    for (unsigned before = 0; before != part;)
    {
      before = part;
      for (int n = 0; n < Count; ++n)
      {
        part |= before >> n & 1 ? m_Adjacent[n] & set : 0;
      }
    }
    set &= ~part;
  }
  return parts;
}
} // namespace mmm
