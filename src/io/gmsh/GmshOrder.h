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
#ifndef mmmGmshOrder_h
#define mmmGmshOrder_h

#include "io/CellMesh.h"

#include <cstddef>

namespace mmm
{
/** The place among a cell's corners of the k-th that Gmsh wants. Of a ten-node tetrahedron, it has the mid-node of the
 * edge 2-3 before that of 1-3. */
inline std::size_t
CornerOfGmsh(const CellShape & shape, std::size_t k)
{
  constexpr int         tenNodeTetrahedron = 11;
  constexpr std::size_t last = 9;
  return shape.gmshType == tenNodeTetrahedron && k + 1 >= last ? last + (last - 1) - k : k;
}
} // namespace mmm

#endif
