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
#ifndef mmmLocalFeatureSize_h
#define mmmLocalFeatureSize_h

#include "sizing/InterfaceSamples.h"

namespace mmm
{
/** \brief The local feature size at each interface sample: its distance to the nearest point of the medial axes.
 *
 * It is infinite where there is no axis at all. */
std::vector<float>
ComputeLocalFeatureSizes(const Grid &                         grid,
                         const std::vector<InterfaceSample> & samples,
                         const std::vector<Vector> &          axis);
} // namespace mmm

#endif
