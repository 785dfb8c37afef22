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
#ifndef mmmCellArrays_h
#define mmmCellArrays_h

#include "io/MeshFileError.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace mmm
{
/** Numbers of all cells, one cell after the other, by name: further ones than the labels. */
using CellArrays = std::map<std::string, std::vector<double>>;

/** How many numbers a cell has: 1, 3 (a vector) or 9 (a tensor, row by row). Throws MeshFileError if it is another. */
inline std::size_t
ComponentsOf(const CellArrays::value_type & array, std::size_t numberOfCells)
{
  const std::size_t components = numberOfCells == 0 ? 1 : array.second.size() / numberOfCells;
  if (array.second.size() != components * numberOfCells || (components != 1 && components != 3 && components != 9))
  {
    throw MeshFileError("its cell data '" + array.first + "' are " + std::to_string(array.second.size()) +
                        " numbers for " + std::to_string(numberOfCells) + " cells; a cell has 1, 3 or 9");
  }
  return components;
}
} // namespace mmm

#endif
