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
#include "mesh/TetrahedralMesh.h"

namespace mmm
{
void
DropMaterial(Material material, TetrahedralMesh & mesh)
{
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
  {
    if (mesh.materials[t] != material)
    {
      mesh.tetrahedra[kept] = mesh.tetrahedra[t];
      mesh.materials[kept++] = mesh.materials[t];
    }
  }
  mesh.tetrahedra.resize(kept);
  mesh.materials.resize(kept);
}
} // namespace mmm
