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
#ifndef mmmSliceDistance_h
#define mmmSliceDistance_h

#include <array>
#include <cstddef>
#include <vector>

namespace mmm
{
/** The pixels of a slice, the first axis fastest, and their spacing. */
struct SlicePlane
{
  std::array<int, 2>    size{ { 0, 0 } };
  std::array<double, 2> spacing{ { 1.0, 1.0 } };

  std::size_t
  NumberOfPixels() const
  {
    return std::size_t(size[0]) * std::size_t(size[1]);
  }
};

/** Of each pixel's centre from the nearest centre of a pixel that is in the set, which is not empty. Exact: lower
 * envelopes of parabolas, Felzenszwalb and Huttenlocher 2012, Distance transforms of sampled functions. */
std::vector<float>
DistancesToSet(const SlicePlane & plane, const std::vector<char> & isIn);
} // namespace mmm

#endif
