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
#ifndef Electrodes_h
#define Electrodes_h

#include "options/OptionTable.h"
#include "run/Input.h"

#include <iosfwd>

namespace cli
{
/** Reads the electrodes, their labels and their names. */
void
AddElectrodes(const Settings & settings, Input & input);

/** Takes over what is known of electrodes once there is a mesh: their voxels. Warns of electrodes that cover others. */
void
FinishElectrodes(const MeshFilter & filter, Input & input);

/** A line on the contacts. */
void
PrintElectrodes(std::ostream & os, const std::vector<mmm::ElectrodeReport> & electrodes);
} // namespace cli

#endif
