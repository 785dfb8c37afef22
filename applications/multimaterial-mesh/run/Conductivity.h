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
#ifndef Conductivity_h
#define Conductivity_h

#include "run/LabelNames.h"

#include <map>
#include <set>
#include <string>

namespace cli
{
/** \brief The conductivity in S/m of each of the `meshed` labels, from the file of --conductivity.
 *
 * A line has a label or a name and a number; JSON, which begins with a brace, has them as members of an object. A name
 * stands for all labels that have it. Throws Error with file, line and what is wrong: a number that is not above 0, a
 * label that has two, one of the meshed labels that has none. Warns of names that no label has. */
std::map<int, double>
ReadConductivity(const std::string & fileName, const LabelNames & names, const std::set<int> & meshed);
} // namespace cli

#endif
