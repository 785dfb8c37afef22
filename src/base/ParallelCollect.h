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
#ifndef mmmParallelCollect_h
#define mmmParallelCollect_h

#include "base/Parallel.h"

#include <numeric>
#include <vector>

namespace mmm
{
/** How many ranges of at most `grain` ParallelFor() makes of `count`. */
inline std::size_t
NumberOfRanges(std::size_t count, std::size_t grain)
{
  return (count + grain - 1) / grain;
}

/** What visit(n, found) appends to `found` for each n below `count`, in the order of n: see ParallelFor(). */
template <typename T, typename TVisitor>
std::vector<T>
ParallelCollect(std::size_t count, std::size_t grain, const TVisitor & visit)
{
  std::vector<std::vector<T>> parts(NumberOfRanges(count, grain));
  ParallelFor(count, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      visit(n, parts[begin / grain]);
    }
  });
  std::vector<T> all;
  for (const auto & part : parts)
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

/** How often visit(n) counts for the n below `count` in sum: it returns a number, or whether. */
template <typename TVisitor>
std::size_t
ParallelCount(std::size_t count, std::size_t grain, const TVisitor & visit)
{
  std::vector<std::size_t> parts(NumberOfRanges(count, grain), 0);
  ParallelFor(count, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      parts[begin / grain] += visit(n);
    }
  });
  return std::accumulate(parts.begin(), parts.end(), std::size_t{ 0 });
}
} // namespace mmm

#endif
