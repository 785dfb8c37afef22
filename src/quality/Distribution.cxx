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
#include "quality/Distribution.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace mmm
{
Distribution
Summarize(double * begin, double * end)
{
  Distribution      result;
  const std::size_t count = end - begin;
  if (count == 0)
  {
    return result;
  }
  double sum = 0.0;
  for (auto value = begin; value != end; ++value)
  {
    sum += *value;
  }
  result.average = sum / double(count);
  const double rank = 0.01 * double(count - 1);
  const auto   below = begin + std::size_t(rank);
  std::nth_element(begin, below, end);
  result.minimum = *std::min_element(begin, below + 1);
  result.firstPercentile = *below;
  if (below + 1 != end)
  {
    result.firstPercentile += (*std::min_element(below + 1, end) - *below) * (rank - std::floor(rank));
  }
  return result;
}
} // namespace mmm
