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
#include "surface/LostNodes.h"

#include "base/Parallel.h"
#include "mesh/TetrahedronRaster.h"
#include "surface/SurfaceParameters.h"

namespace mmm
{
namespace
{
using Parameters = LostNodeParameters;

enum State : std::uint8_t
{
  FarFromInterfaces,
  Unvisited,
  Right,
  Wrong
};

/** Calls visit(offset) for the six neighbours of a node, or those of them that are within the grid. */
template <typename TVisitor>
void
VisitNeighbours(const Grid & grid, const Index & at, TVisitor && visit)
{
  for (int a = 0; a < 3; ++a)
  {
    for (const int step : { -1, 1 })
    {
      Index other = at;
      other[a] += step;
      if (grid.Contains(other))
      {
        visit(grid.Offset(other));
      }
    }
  }
}

std::vector<std::uint8_t>
MarkInterfaceNodes(const Grid & grid, const std::vector<Material> & materials)
{
  constexpr std::size_t     NodesPerRange = 65536;
  std::vector<std::uint8_t> states(materials.size(), FarFromInterfaces);
  ParallelFor(materials.size(), NodesPerRange, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      VisitNeighbours(grid, grid.IndexAt(n), [&](std::size_t other) {
        states[n] = materials[other] != materials[n] ? std::uint8_t(Unvisited) : states[n];
      });
    }
  });
  return states;
}
} // namespace

LostNodes
FindLostNodes(const IndicatorSet &        indicators,
              const std::vector<Vector> & points,
              const TetrahedralMesh &     mesh,
              Material                    exterior)
{
  const Grid & grid = indicators.GetGrid();
  const auto & materials = indicators.NodeMaterials();
  auto         states = MarkInterfaceNodes(grid, materials);
  // a node is inside of one tetrahedron at most: no two threads write to one place
  ParallelFor(mesh.tetrahedra.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
    {
      // nodes on faces are left out
      VisitIndicesInside(grid.size, CornersInVoxels(grid, points, mesh.tetrahedra[t]), -1e-9, [&](const Index & at) {
        const auto n = grid.Offset(at);
        if (states[n] != FarFromInterfaces)
        {
          states[n] = mesh.materials[t] == materials[n] ? Right : Wrong;
        }
      });
    }
  });
  const auto isLost = [&](std::size_t n) {
    return states[n] == Wrong || (states[n] == Unvisited && materials[n] != exterior);
  };
  std::vector<std::size_t> all(indicators.GetNumberOfMaterials(), 0);
  std::vector<std::size_t> wrong(all.size(), 0);
  for (std::size_t n = 0; n < states.size(); ++n)
  {
    ++all[materials[n]];
    wrong[materials[n]] += isLost(n);
  }
  const auto isPoor = [&](Material m) {
    const double accepted = all[m] <= Parameters::SmallestLabels ? 0.0 : Parameters::AcceptedLoss * double(all[m]);
    return m != exterior && all[m] <= Parameters::SmallLabel && double(wrong[m]) > accepted;
  };
  LostNodes lost;
  for (std::size_t n = 0; n < states.size(); ++n)
  {
    if (!isLost(n))
    {
      continue;
    }
    bool found = false;
    VisitNeighbours(grid, grid.IndexAt(n), [&](std::size_t other) {
      found =
        found || (materials[other] == materials[n] && (states[other] == Right || states[other] == FarFromInterfaces));
    });
    if (!found)
    {
      lost.parts.push_back(n);
    }
    else if (isPoor(materials[n]))
    {
      lost.corners.push_back(n);
    }
  }
  return lost;
}
} // namespace mmm
