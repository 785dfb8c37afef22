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
#include "mesh/InterfaceMesh.h"

#include "mesh/TriangleLookup.h"

#include <algorithm>
#include <limits>

namespace mmm
{
namespace
{
/** Whether two triangles with the same corners have the same orientation. */
bool
AreOneTurn(const Triangle & a, const Triangle & b)
{
  const auto first = std::find(b.begin(), b.end(), a[0]) - b.begin();
  return b[(first + 1) % 3] == a[1];
}
} // namespace

InterfaceMesh
ExtractInterfaces(const TetrahedralMesh & mesh, Material outside)
{
  return ExtractInterfaces(mesh, ComputeTetrahedronNeighbours(mesh.tetrahedra), outside);
}

InterfaceMesh
ExtractInterfaces(const TetrahedralMesh & mesh, const TetrahedronNeighbours & neighbours, Material outside)
{
  InterfaceMesh interfaces;
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
  {
    for (int f = 0; f < 4; ++f)
    {
      const auto     other = neighbours[t][f];
      const Material own = mesh.materials[t];
      const Material beyond = other == NoTetrahedron ? outside : mesh.materials[other];
      // each pair once, from the side of the lower material or, at the outside, from the mesh
      if (own == beyond || (other != NoTetrahedron && own > beyond))
      {
        continue;
      }
      Triangle corners = FaceOf(mesh.tetrahedra[t], f);
      if (own > beyond)
      {
        std::swap(corners[1], corners[2]);
      }
      interfaces.triangles.push_back(corners);
      interfaces.sides.push_back({ { std::min(own, beyond), std::max(own, beyond) } });
    }
  }
  return interfaces;
}
std::optional<std::vector<Material>>
LabelByInterfaces(const InterfaceMesh & interfaces, const std::vector<Tetrahedron> & tetrahedra, Material outside)
{
  constexpr Material Unknown = std::numeric_limits<Material>::max();

  // what each face says of its tetrahedron
  const TriangleLookup             lookup(interfaces.triangles);
  std::vector<Material>            materials(tetrahedra.size(), Unknown);
  std::vector<std::array<bool, 4>> closed(tetrahedra.size());
  std::vector<char>                isFace(interfaces.triangles.size(), 0);
  std::vector<std::uint32_t>       stack;
  for (std::uint32_t t = 0; t < tetrahedra.size(); ++t)
  {
    for (int f = 0; f < 4; ++f)
    {
      const Triangle face = FaceOf(tetrahedra[t], f);
      const auto     found = lookup.Find(face);
      closed[t][f] = found != TriangleLookup::None;
      if (closed[t][f])
      {
        isFace[found] = 1;
        // a face points outward, a triangle to its second side
        materials[t] = interfaces.sides[found][AreOneTurn(interfaces.triangles[found], face) ? 0 : 1];
      }
    }
    if (materials[t] != Unknown)
    {
      stack.push_back(t);
    }
  }
  if (std::find(isFace.begin(), isFace.end(), 0) != isFace.end())
  {
    return std::nullopt;
  }

  const auto neighbours = ComputeTetrahedronNeighbours(tetrahedra);
  while (!stack.empty())
  {
    const auto t = stack.back();
    stack.pop_back();
    for (int f = 0; f < 4; ++f)
    {
      const auto other = neighbours[t][f];
      if (!closed[t][f] && other != NoTetrahedron && materials[other] == Unknown)
      {
        materials[other] = materials[t];
        stack.push_back(other);
      }
    }
  }
  std::replace(materials.begin(), materials.end(), Unknown, outside);
  return materials;
}
} // namespace mmm
