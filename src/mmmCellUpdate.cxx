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
#include "mmmCellUpdate.h"

#include "mmmCellNumbers.h"
#include "mmmLinkInspector.h"
#include "mmmParallelCollect.h"
#include "mmmTetrahedronQuality.h"

#include <algorithm>

namespace mmm
{
namespace
{
constexpr std::size_t ParticlesPerRange = 4096;
/** How far a cell may be from a particle, in units of the smallest voxel spacing. */
constexpr double Reach = 0.5;

/** Another cell for a particle, and where on it. */
struct CellChange
{
  PointId particle;
  Cell    cell;
  Vector  position;
};

/** Whether some materials have a cell near a particle other than its own one. */
bool
FindOtherCell(const IndicatorSet &          indicators,
              const std::vector<Material> & materials,
              const Cell &                  own,
              CellChange &                  change)
{
  const auto isPlane = [&](Material m) { return indicators.IsPlane(m); };
  if (materials.size() < 2 || materials.size() > 4 || std::any_of(materials.begin(), materials.end(), isPlane) ||
      std::any_of(own.begin(), own.end(), isPlane))
  {
    return false;
  }
  for (const Material m : materials)
  {
    change.cell.Join(Cell{ m });
  }
  return change.cell != own && indicators.ProjectWhereMaximal(change.cell, change.position, Reach);
}

/** Moves a particle, unless that turns a tetrahedron inside out. */
bool
Move(const TetrahedralMesh & mesh,
     const Incidence &       stars,
     PointId                 p,
     const Vector &          to,
     std::vector<Vector> &   positions)
{
  const Vector from = positions[p];
  positions[p] = to;
  const bool isValid = std::all_of(stars.Begin(p), stars.End(p), [&](std::uint32_t t) {
    const auto & c = mesh.tetrahedra[t];
    return TetrahedronVolume(positions[c[0]], positions[c[1]], positions[c[2]], positions[c[3]]) > 0.0;
  });
  if (!isValid)
  {
    positions[p] = from;
  }
  return isValid;
}
} // namespace

std::size_t
UpdateCells(const IndicatorSet &         indicators,
            const TetrahedralMesh &      mesh,
            const TetrahedronAdjacency & adjacency,
            Material                     outside,
            ParticleSet &                particles)
{
  const auto changes = ParallelCollect<CellChange>(
    particles.Size(), ParticlesPerRange, [&](std::size_t p, std::vector<CellChange> & found) {
      LinkInspector inspector(mesh, adjacency, outside);
      inspector.Inspect(PointId(p));
      CellChange change{ PointId(p), Cell(), particles.positions[p] };
      if (FindOtherCell(indicators, inspector.Materials(), particles.CellOf(p), change))
      {
        found.push_back(change);
      }
    });
  CellNumbers numbers(particles.cellTable);
  std::size_t changed = 0;
  for (const CellChange & change : changes)
  {
    if (Move(mesh, adjacency.stars, change.particle, change.position, particles.positions))
    {
      particles.cells[change.particle] = numbers(change.cell);
      ++changed;
    }
  }
  return changed;
}
} // namespace mmm
