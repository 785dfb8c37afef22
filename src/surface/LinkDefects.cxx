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
#include "surface/LinkDefects.h"

#include "base/MakeUnique.h"
#include "base/Parallel.h"
#include "surface/LinkInspector.h"

#include <algorithm>
#include <numeric>

namespace mmm
{
namespace
{
constexpr std::size_t PointsPerRange = 4096;
} // namespace

LinkDefects
FindLinkDefects(const TetrahedralMesh &      mesh,
                const TetrahedronAdjacency & adjacency,
                Material                     outside,
                const std::vector<PointId> & points)
{
  std::vector<LinkDefects> parts((points.size() + PointsPerRange - 1) / PointsPerRange);
  ParallelFor(points.size(), PointsPerRange, [&](std::size_t begin, std::size_t end) {
    LinkInspector inspector(mesh, adjacency, outside);
    LinkDefects & defects = parts[begin / PointsPerRange];
    for (std::size_t n = begin; n < end; ++n)
    {
      const PointId p = points[n];
      inspector.Inspect(p);
      if (inspector.IsDefect())
      {
        defects.points.push_back(p);
      }
      for (const PointId q : inspector.DefectEdges())
      {
        defects.edges.push_back({ { std::min(p, q), std::max(p, q) } });
      }
    }
  });
  LinkDefects defects;
  for (const auto & part : parts)
  {
    defects.points.insert(defects.points.end(), part.points.begin(), part.points.end());
    defects.edges.insert(defects.edges.end(), part.edges.begin(), part.edges.end());
  }
  MakeUnique(defects.edges);
  return defects;
}

LinkDefects
FindLinkDefects(const TetrahedralMesh & mesh, const TetrahedronAdjacency & adjacency, Material outside)
{
  std::vector<PointId> points(adjacency.numberOfPoints);
  std::iota(points.begin(), points.end(), 0);
  return FindLinkDefects(mesh, adjacency, outside, points);
}
} // namespace mmm
