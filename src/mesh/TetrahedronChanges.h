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
#ifndef mmmTetrahedronChanges_h
#define mmmTetrahedronChanges_h

#include "mesh/TetrahedralMesh.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace mmm
{
/** \brief Tells what has changed from one mesh to the next one. */
class TetrahedronChanges
{
public:
  /** Takes the next mesh. Gives the tetrahedra that it has and the one before it has not, or with another material, and
   * the other way round. Points may have been added at the end: if others have changed, it gives nothing. */
  std::optional<std::vector<Tetrahedron>>
  Next(const std::vector<Vector> & points, const TetrahedralMesh & mesh);

private:
  /** Sorted corners, and the material. */
  using Key = std::array<std::uint32_t, 5>;

  std::vector<Vector> m_Points;
  std::vector<Key>    m_Keys;
};
} // namespace mmm

#endif
