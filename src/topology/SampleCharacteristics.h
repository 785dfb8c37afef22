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
#ifndef mmmSampleCharacteristics_h
#define mmmSampleCharacteristics_h

#include "base/Grid.h"
#include "image/MaterialImage.h"

#include <array>
#include <functional>
#include <vector>

namespace mmm
{
/** The Euler characteristic of the simplices that have the first of eight samples as their lowest vertex, and all
 * others among the samples that are the `same`: bit n - 1 stands for sample n. Bit 0 of a sample's number is for the
 * upper one of the first axis and so on: a simplex joins samples whose numbers gain bits. */
int
CountSimplices(unsigned same);

/** Adds the characteristics of the materials of an array of samples, by calls add(material, count). */
void
AddCharacteristicsOfSamples(const Index &                              size,
                            const std::vector<Material> &              samples,
                            const std::function<void(Material, int)> & add);
} // namespace mmm

#endif
