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
#ifndef mmmTetrahedralMesh_h
#define mmmTetrahedralMesh_h

#include "base/Grid.h"
#include "image/MaterialImage.h"
#include "mesh/TetrahedronQuality.h"

#include <array>
#include <cstdint>
#include <vector>

namespace mmm
{
using PointId = std::uint32_t;
using Triangle = std::array<PointId, 3>;

/** The tetrahedron beyond a face on the outside of a mesh. */
constexpr std::uint32_t NoTetrahedron = 0xffffffffu;

/** \brief Tetrahedra, each with its material, over an array of points that is kept elsewhere. */
struct TetrahedralMesh
{
  std::vector<Tetrahedron> tetrahedra;
  std::vector<Material>    materials;
};

/** Drops the tetrahedra of a material; the others keep their order. */
void
DropMaterial(Material material, TetrahedralMesh & mesh);
} // namespace mmm

#endif
