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
#ifndef Warnings_h
#define Warnings_h

#include <string>
#include <vector>

namespace cli
{
/** Prints one line on stderr, each text once. */
void
Warn(const std::string & text);

/** Those that were printed, in their order. */
std::vector<std::string>
GetWarnings();

/** Between the two, warnings are kept back. */
void
HoldWarnings();
void
ReleaseWarnings();

/** From now on, warnings of ITK come out by Warn(). */
void
CatchITKWarnings();
} // namespace cli

#endif
