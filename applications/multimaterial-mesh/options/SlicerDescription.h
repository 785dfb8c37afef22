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
#ifndef SlicerDescription_h
#define SlicerDescription_h

#include <iosfwd>
#include <string>

namespace cli
{
struct Option;

/** \brief How the Slicer Execution Model spells an option: `min_island`. Its parser refuses hyphens. */
std::string
SlicerName(const Option & option);

/** \brief Prints the description of the program that 3D Slicer makes its panel from: the XML of the Slicer Execution
 * Model. */
void
PrintSlicerDescription(std::ostream & os);
} // namespace cli

#endif
