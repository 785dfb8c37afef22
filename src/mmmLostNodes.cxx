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
#include "mmmLostNodes.h"

#include "mmmParallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mmm
{
namespace
{
/** Labels of no more voxels are small: a few lost ones count, and it costs little to sample all of it more finely. */
constexpr std::size_t SmallLabel = 5000;
/** The share of its voxels that a small label may lose; the smallest ones may lose none. */
constexpr double      AcceptedLoss = 0.06;
constexpr std::size_t SmallestLabels = 500;

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
  std::vector<std::uint8_t> states(materials.size(), FarFromInterfaces);
  ParallelFor(grid.size[2], 1, [&](std::size_t begin, std::size_t end) {
    for (int k = int(begin); k < int(end); ++k)
    {
      for (int j = 0; j < grid.size[1]; ++j)
      {
        for (int i = 0; i < grid.size[0]; ++i)
        {
          const Index at{ { i, j, k } };
          const auto  n = grid.Offset(at);
          VisitNeighbours(grid, at, [&](std::size_t other) {
            if (materials[other] != materials[n])
            {
              states[n] = Unvisited;
            }
          });
        }
      }
    }
  });
  return states;
}

/** Calls visit(offset) for the nodes inside of a tetrahedron, not for those on its faces. */
template <typename TVisitor>
void
VisitNodesInside(const Grid & grid, const Vector (&corners)[4], TVisitor && visit)
{
  constexpr double Margin = 1e-9;
  Vector           normals[4];
  double           offsets[4];
  int              low[3];
  int              high[3];
  for (int f = 0; f < 4; ++f)
  {
    const Vector & a = corners[TetrahedronFaces[f][0]];
    normals[f] = (corners[TetrahedronFaces[f][1]] - a).cross(corners[TetrahedronFaces[f][2]] - a).normalized();
    offsets[f] = normals[f].dot(a) - Margin;
  }
  for (int a = 0; a < 3; ++a)
  {
    const auto coordinates = { corners[0][a], corners[1][a], corners[2][a], corners[3][a] };
    low[a] = std::max(0, int(std::ceil(std::min(coordinates) / grid.spacing[a])));
    high[a] = std::min(grid.size[a] - 1, int(std::floor(std::max(coordinates) / grid.spacing[a])));
  }
  for (int k = low[2]; k <= high[2]; ++k)
  {
    for (int j = low[1]; j <= high[1]; ++j)
    {
      double first = low[0] * grid.spacing[0];
      double last = high[0] * grid.spacing[0];
      for (int f = 0; f < 4; ++f)
      {
        const double rest = offsets[f] - normals[f][1] * j * grid.spacing[1] - normals[f][2] * k * grid.spacing[2];
        if (normals[f][0] > 0.0)
        {
          last = std::min(last, rest / normals[f][0]);
        }
        else if (normals[f][0] < 0.0)
        {
          first = std::max(first, rest / normals[f][0]);
        }
        else if (!(rest >= 0.0))
        {
          last = -std::numeric_limits<double>::infinity();
        }
      }
      // both bounds lie within the bounding box now, or there is nothing between them
      if (!(first <= last))
      {
        continue;
      }
      const int end = int(std::floor(last / grid.spacing[0]));
      for (int i = int(std::ceil(first / grid.spacing[0])); i <= end; ++i)
      {
        visit(grid.Offset(i, j, k));
      }
    }
  }
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
      const auto & c = mesh.tetrahedra[t];
      const Vector corners[4] = { points[c[0]], points[c[1]], points[c[2]], points[c[3]] };
      VisitNodesInside(grid, corners, [&](std::size_t n) {
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
    const double accepted = all[m] <= SmallestLabels ? 0.0 : AcceptedLoss * double(all[m]);
    return m != exterior && all[m] <= SmallLabel && double(wrong[m]) > accepted;
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
