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
#ifndef mmmGmshElementData_h
#define mmmGmshElementData_h

#include "io/CellArrays.h"
#include "io/FileComposer.h"

#include <cstddef>
#include <vector>

namespace mmm
{
/** Writes a section $ElementData for each of the arrays, which have numbers for each of the cells.
 *
 * `order`: the cells as the file lists and numbers them. Gmsh goes by the numbers; meshio wants them to be in order. */
void
WriteGmshElementData(FileComposer & file, const CellArrays & arrays, const std::vector<std::size_t> & order);

/** From LPS to RAS, and back: vectors and tensors. */
void
TurnLPSAndRAS(CellArrays & arrays, std::size_t numberOfCells);
} // namespace mmm

#endif
