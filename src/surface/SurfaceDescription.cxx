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
#include "surface/SurfaceDescription.h"

#include "base/Points.h"
#include "mesh/Renumber.h"

#include <algorithm>

namespace mmm
{
std::vector<MeshingPlace>
FindInconsistentTriangles(const IndicatorSet &  indicators,
                          const ParticleSet &   particles,
                          const InterfaceMesh & interfaces,
                          Material              exterior)
{
  const auto lies = [&](PointId corner, Material side) {
    const Cell & cell = particles.CellOf(corner);
    return cell.Has(side) || (side == exterior &&
                              std::any_of(cell.begin(), cell.end(), [&](Material m) { return indicators.IsPlane(m); }));
  };
  const auto &              x = particles.positions;
  std::vector<MeshingPlace> places;
  for (std::size_t t = 0; t < interfaces.triangles.size(); ++t)
  {
    const auto & sides = interfaces.sides[t];
    const auto & corners = interfaces.triangles[t];
    if (!std::all_of(corners.begin(), corners.end(), [&](PointId corner) {
          return lies(corner, sides[0]) && lies(corner, sides[1]);
        }))
    {
      places.push_back({ ToPoint((x[corners[0]] + x[corners[1]] + x[corners[2]]) / 3.0), { sides[0], sides[1] } });
    }
  }
  return places;
}

LinkReport
DescribeLinks(const LinkRepairReport & repair, const ParticleSet & particles)
{
  LinkReport report;
  report.edges = repair.found.edges.size();
  report.points = repair.found.points.size();
  report.relabelled = repair.relabelled;
  const auto add = [&](const Vector & x, PointId p) {
    const Cell & cell = particles.CellOf(p);
    report.left.push_back({ ToPoint(x), std::vector<int>(cell.begin(), cell.end()) });
  };
  for (const PointId p : repair.left.points)
  {
    add(particles.positions[p], p);
  }
  for (const auto & edge : repair.left.edges)
  {
    add(0.5 * (particles.positions[edge[0]] + particles.positions[edge[1]]), edge[0]);
  }
  return report;
}

std::size_t
DropUnusedParticles(ParticleSet & particles, InterfaceMesh & interfaces)
{
  std::vector<char> isUsed(particles.Size(), 0);
  for (const auto & triangle : interfaces.triangles)
  {
    for (const auto corner : triangle)
    {
      isUsed[corner] = 1;
    }
  }
  std::vector<PointId> numbers(particles.Size());
  PointId              kept = 0;
  for (std::size_t p = 0; p < numbers.size(); ++p)
  {
    numbers[p] = kept;
    kept += isUsed[p];
  }
  Renumber(numbers, interfaces.triangles);
  return particles.Keep(isUsed);
}
} // namespace mmm
