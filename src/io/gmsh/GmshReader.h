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
#ifndef mmmGmshReader_h
#define mmmGmshReader_h

#include "io/CellMesh.h"

#include <string_view>

namespace mmm
{
/** Reads a .msh file of version 2.2 or 4.1, text or binary. Throws MeshFileError. Returns whether each cell is in one
 * physical group at most; if not, the first one counts. */
bool
ReadGmsh(std::string_view bytes, CellMesh & mesh);
} // namespace mmm

#endif
