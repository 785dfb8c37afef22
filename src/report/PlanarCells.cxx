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
#include "report/PlanarCells.h"

#include <algorithm>

namespace mmm
{
double
TwiceArea(const std::vector<PlanarPoint> & points, const PlanarCell & cell)
{
  const std::size_t count = cell.CountCorners();
  double            area = 0.0;
  for (std::size_t c = 0; c < count; ++c)
  {
    const PlanarPoint & a = points[cell.corners[c]];
    const PlanarPoint & b = points[cell.corners[(c + 1) % count]];
    area += a[0] * b[1] - a[1] * b[0];
  }
  return area;
}

std::map<int, double>
AreasByLabel(const PlanarCells & cells)
{
  std::map<int, double> areas;
  for (const PlanarCell & cell : cells.cells)
  {
    areas[cell.label] += 0.5 * TwiceArea(cells.points, cell);
  }
  return areas;
}

std::vector<PlanarEdge>
EdgesOf(const std::vector<PlanarCell> & cells)
{
  std::vector<PlanarEdge> edges;
  edges.reserve(4 * cells.size());
  for (const PlanarCell & cell : cells)
  {
    const std::size_t count = cell.CountCorners();
    for (std::size_t c = 0; c < count; ++c)
    {
      const auto [a, b] = std::minmax(cell.corners[c], cell.corners[(c + 1) % count]);
      edges.push_back({ { a, b } });
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}
} // namespace mmm
