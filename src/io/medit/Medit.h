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
#ifndef mmmMedit_h
#define mmmMedit_h

#include "io/CellMesh.h"

#include <string>
#include <string_view>

namespace mmm
{
/** Reads a .mesh file: references of cells are tags. Throws MeshFileError. */
void
ReadMedit(std::string_view bytes, CellMesh & mesh);

/** Writes a .mesh file. What the name of a group tells beyond its tag is in comments, which ReadMedit() reads. Throws
 * an exception and leaves no file if it cannot. */
void
WriteMedit(const std::string & fileName, const CellMesh & mesh);

/** What such a comment begins with. The dimension, the tag and the name follow. */
constexpr const char * meditGroupComment = "# group";
} // namespace mmm

#endif
