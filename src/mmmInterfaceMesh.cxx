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
#include "mmmInterfaceMesh.h"

#include "mmmTetrahedronNeighbours.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace mmm
{
InterfaceMesh
ExtractInterfaces(const TetrahedralMesh & mesh, Material outside)
{
  const auto    neighbours = ComputeTetrahedronNeighbours(mesh.tetrahedra);
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
      Triangle corners;
      for (int c = 0; c < 3; ++c)
      {
        corners[c] = mesh.tetrahedra[t][TetrahedronFaces[f][c]];
      }
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
std::vector<Material>
LabelByInterfaces(const InterfaceMesh & interfaces, const std::vector<Tetrahedron> & tetrahedra, Material outside)
{
  constexpr Material Unknown = std::numeric_limits<Material>::max();

  // the triangles by their smallest point
  PointId points = 0;
  for (const auto & triangle : interfaces.triangles)
  {
    points = std::max(points, *std::max_element(triangle.begin(), triangle.end()) + 1);
  }
  const auto                 smallest = [](const Triangle & t) { return *std::min_element(t.begin(), t.end()); };
  std::vector<std::uint32_t> start(points + 1, 0);
  for (const auto & triangle : interfaces.triangles)
  {
    ++start[smallest(triangle) + 1];
  }
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<std::uint32_t> bySmallest(interfaces.triangles.size());
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  for (std::uint32_t t = 0; t < interfaces.triangles.size(); ++t)
  {
    bySmallest[next[smallest(interfaces.triangles[t])]++] = t;
  }

  // what each face says of its tetrahedron
  std::vector<Material>            materials(tetrahedra.size(), Unknown);
  std::vector<std::array<bool, 4>> closed(tetrahedra.size());
  std::vector<std::uint32_t>       stack;
  for (std::uint32_t t = 0; t < tetrahedra.size(); ++t)
  {
    for (int f = 0; f < 4; ++f)
    {
      Triangle face;
      for (int c = 0; c < 3; ++c)
      {
        face[c] = tetrahedra[t][TetrahedronFaces[f][c]];
      }
      std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
      closed[t][f] = false;
      if (face[0] >= points)
      {
        continue;
      }
      for (auto n = start[face[0]]; n < start[face[0] + 1]; ++n)
      {
        Triangle triangle = interfaces.triangles[bySmallest[n]];
        std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
        const bool same = triangle[1] == face[1] && triangle[2] == face[2];
        const bool opposite = triangle[1] == face[2] && triangle[2] == face[1];
        if (same || opposite)
        {
          // a face points outward, a triangle to its second side
          closed[t][f] = true;
          materials[t] = interfaces.sides[bySmallest[n]][same ? 0 : 1];
          break;
        }
      }
    }
    if (materials[t] != Unknown)
    {
      stack.push_back(t);
    }
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
