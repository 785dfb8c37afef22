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
#ifndef mmmKeyedRuns_h
#define mmmKeyedRuns_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mmm
{
/** A key of two numbers and what belongs to it; sorted, equal keys are neighbours. */
struct Keyed
{
  std::uint64_t key;
  std::uint32_t value;

  bool
  operator<(const Keyed & other) const
  {
    return key != other.key ? key < other.key : value < other.value;
  }
};

inline std::uint64_t
Key(std::uint32_t high, std::uint32_t low)
{
  return std::uint64_t(high) << 32 | low;
}

/** Calls body(begin, end) for each run of equal keys. */
template <typename TBody>
void
ForEachRun(const std::vector<Keyed> & sorted, const TBody & body)
{
  for (std::size_t begin = 0; begin < sorted.size();)
  {
    std::size_t end = begin + 1;
    while (end < sorted.size() && sorted[end].key == sorted[begin].key)
    {
      ++end;
    }
    body(begin, end);
    begin = end;
  }
}
} // namespace mmm

#endif
