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
#include "surface/CellUpdate.h"

#include "particles/CellNumbers.h"
#include "surface/LinkInspector.h"
#include "surface/SurfaceParameters.h"
#include "base/Parallel.h"

#include <algorithm>

namespace mmm
{
namespace
{
constexpr std::size_t ParticlesPerRange = 4096;

/** The cell of some materials, or the particle's own one where that is not near. */
Cell
CellOfMaterials(const IndicatorSet & indicators, const std::vector<Material> & materials, const Cell & own, Vector x)
{
  const auto isPlane = [&](Material m) { return indicators.IsPlane(m); };
  if (materials.size() < 2 || materials.size() > 4 || std::any_of(materials.begin(), materials.end(), isPlane) ||
      std::any_of(own.begin(), own.end(), isPlane))
  {
    return own;
  }
  Cell cell;
  for (const Material m : materials)
  {
    cell.Join(Cell{ m });
  }
  return cell != own && indicators.ProjectWhereMaximal(cell, x, MendingParameters::CellReach) ? cell : own;
}
} // namespace

void
UpdateCells(const IndicatorSet &         indicators,
            const TetrahedralMesh &      mesh,
            const TetrahedronAdjacency & adjacency,
            Material                     outside,
            ParticleSet &                particles)
{
  std::vector<Cell> cells(particles.Size());
  ParallelFor(cells.size(), ParticlesPerRange, [&](std::size_t begin, std::size_t end) {
    LinkInspector inspector(mesh, adjacency, outside);
    for (std::size_t p = begin; p < end; ++p)
    {
      inspector.Inspect(PointId(p));
      cells[p] = CellOfMaterials(indicators, inspector.Materials(), particles.CellOf(p), particles.positions[p]);
    }
  });
  CellNumbers numbers(particles.cellTable);
  for (std::size_t p = 0; p < cells.size(); ++p)
  {
    if (cells[p] != particles.CellOf(p))
    {
      particles.cells[p] = numbers(cells[p]);
    }
  }
}
} // namespace mmm
