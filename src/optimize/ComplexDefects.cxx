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
#include "optimize/ComplexDefects.h"

#include "mesh/MeshTopology.h"
#include "mesh/TetrahedronNeighbours.h"

#include <algorithm>

namespace mmm
{
ComplexDefects
FindDefects(const TetrahedralComplex & complex, const std::vector<Vector> & points)
{
  using Id = TetrahedralComplex::Id;
  const auto      mesh = complex.GetMesh();
  const auto      neighbours = ComputeTetrahedronNeighbours(mesh.tetrahedra);
  std::vector<Id> number(complex.Size(), NoTetrahedron);
  for (Id t = 0, count = 0; t < complex.Size(); ++t)
  {
    number[t] = complex.IsAlive(t) ? count++ : NoTetrahedron;
  }
  ComplexDefects defects;
  for (Id t = 0; t < complex.Size(); ++t)
  {
    if (!complex.IsAlive(t))
    {
      continue;
    }
    const auto & c = complex.Corners(t);
    defects.notPositive += !(TetrahedronVolume(points[c[0]], points[c[1]], points[c[2]], points[c[3]]) > 0.0);
    for (int f = 0; f < 4; ++f)
    {
      const Id other = complex.Neighbour(t, f);
      defects.notNeighbours += (other == NoTetrahedron ? other : number[other]) != neighbours[number[t]][f];
    }
  }
  const auto last = std::max_element(mesh.materials.begin(), mesh.materials.end());
  const auto topology = ComputeMeshTopology(points, mesh, last == mesh.materials.end() ? 0 : *last);
  for (const auto & region : topology.regions)
  {
    defects.open += region.openEdges;
  }
  return defects;
}
} // namespace mmm
