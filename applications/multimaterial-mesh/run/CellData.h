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
#ifndef CellData_h
#define CellData_h

#include "run/Outcome.h"

namespace cli
{
/** Samples the images of --cell-data on the tetrahedra, and gives these the conductivities of their labels. Warns of
 * tetrahedra outside of an image. */
void
MakeCellData(Outcome & outcome);
} // namespace cli

#endif
