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
#ifndef Surfaces_h
#define Surfaces_h

#include "run/Input.h"

namespace cli
{
/** Reads the surfaces of the settings, turns them into distances on the grid of the input's labels, and counts voxels.
 * Without labels the input gets a grid around the surfaces. Throws Error where a surface cannot be meshed, and warns of
 * what is doubtful, by the names of the files. */
void
AddSurfaces(const Settings & settings, Input & input);
} // namespace cli

#endif
