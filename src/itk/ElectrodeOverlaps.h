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
#ifndef mmmElectrodeOverlaps_h
#define mmmElectrodeOverlaps_h

#include "itk/ElectrodePlacement.h"

#include <vector>

namespace mmm
{
/** The electrodes, cylinders that are the middle or an end of an earlier one, with the same axis and radius, as parts
 * of that: were they shapes of their own, three materials would meet all over their sides. */
std::vector<Electrode>
WithBodies(std::vector<Electrode> electrodes);

/** Tells in the reports which electrodes hide a part of which earlier ones; contacts are left to their bodies. */
void
ReportCovered(const std::vector<Electrode> & electrodes, PlacedElectrodes & placed);
} // namespace mmm

#endif
