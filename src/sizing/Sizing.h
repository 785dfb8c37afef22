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
#ifndef mmmSizing_h
#define mmmSizing_h

#include "indicators/IndicatorSet.h"
#include "sizing/InterfaceSamples.h"
#include "base/Monitor.h"
#include "sizing/SizingControl.h"
#include "sizing/SizingParameters.h"

namespace mmm
{
/** \brief The largest edge length where none is given: a part of the cube root of the volume of what is meshed, but
 * several voxels at least. */
double
DefaultMaximumSize(const IndicatorSet & indicators, int exterior);

/** \brief The sizing field h: the edge length that is asked for, at every grid node.
 *
 * At the interfaces h0 = min(epsilon * local feature size, sqrt(8 * chordTolerance / largest curvature)), within
 * [minimumSize, maximumSize]. The local feature size is the distance to the medial axes of all materials. In between
 * h(x) = min over y of h0(y) + gradientLimit * |x - y|, the largest field below h0 whose gradient is limited.
 *
 * `control` is what users add. `exterior` is the material that is not meshed, or -1. */
std::vector<float>
ComputeSizing(const IndicatorSet &     indicators,
              int                      exterior,
              const SizingParameters & parameters,
              const SizingControl &    control,
              Monitor &                monitor);

/** The largest magnitude of the interface's principal curvatures at a sample. */
double
LargestCurvature(const IndicatorSet & indicators, const InterfaceSample & sample);
} // namespace mmm

#endif
