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
#ifndef mmmGmshWriter4_h
#define mmmGmshWriter4_h

#include "io/CellMesh.h"
#include "io/FileComposer.h"

#include <cstddef>
#include <vector>

namespace mmm
{
/** The entities, nodes and elements of version 4.1. Each group is an entity. Returns the cells in the file's order.
 *
 * Elements have the cells' numbers, so that a reader can restore their order, or are numbered as they come. */
std::vector<std::size_t>
WriteGmshSections4(FileComposer & file, const CellMesh & mesh, bool isNumberedInOrder);
} // namespace mmm

#endif
