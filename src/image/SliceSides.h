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
#ifndef mmmSliceSides_h
#define mmmSliceSides_h

#include "image/SliceDistance.h"

#include <array>
#include <vector>

namespace mmm
{
constexpr int SliceSides = 2;

/** Of the lower and the upper slice of a gap. */
template <typename T>
using BothSides = std::array<T, SliceSides>;

/** For each material that a slice has, the distances of all pixels from it; empty for the others. */
using MaterialDistances = std::vector<std::vector<float>>;
} // namespace mmm

#endif
