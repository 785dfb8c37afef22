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
#ifndef mmmParticles_h
#define mmmParticles_h

#include "MultiMaterialMeshingReports.h"
#include "indicators/IndicatorSet.h"
#include "base/Monitor.h"
#include "particles/ParticleParameters.h"
#include "particles/SeedCubes.h"
#include "sizing/SizingField.h"

#include <cstdint>
#include <vector>

namespace mmm
{
/** \brief Particles: points, each on its cell. */
struct ParticleSet
{
  std::vector<Vector>        positions;
  std::vector<std::uint32_t> cells;
  /** The cells that particles lie on; `cells` holds numbers into this table. A single material is a 3-cell. */
  std::vector<Cell> cellTable;

  std::size_t
  Size() const
  {
    return positions.size();
  }
  const Cell &
  CellOf(std::size_t particle) const
  {
    return cellTable[cells[particle]];
  }
  /** Drops the particles that are not marked; those beyond the end of `marks` stay. Returns how many are gone. */
  std::size_t
  Keep(const std::vector<char> & marks)
  {
    std::size_t kept = 0;
    for (std::size_t p = 0; p < this->Size(); ++p)
    {
      if (p >= marks.size() || marks[p])
      {
        positions[kept] = positions[p];
        cells[kept++] = cells[p];
      }
    }
    const std::size_t gone = this->Size() - kept;
    positions.resize(kept);
    cells.resize(kept);
    return gone;
  }
};

/** \brief Starts particles on all 0-, 1- and 2-cells.
 *
 * Every dual cube of the grid whose corners disagree starts one particle for each pair, triple and quadruple of its
 * materials, by projection; it stays where those materials are the largest. Then Poisson-disk thinning in units of h,
 * lower cells first, in an order drawn by `seed`. Those that are left are sorted in space, see SpatialOrder().
 * `exterior` (or -1) and the planes bound no interface between themselves. */
ParticleSet
SeedParticles(const IndicatorSet & indicators, const SizingField & sizing, int exterior, std::uint64_t seed);

/** Adds particles like these from the cubes around some places, where those that are there are not dense enough for h.
 * Returns how many. */
std::size_t
SeedParticlesAround(const SeedCubes &          cubes,
                    const std::vector<Index> & places,
                    const SizingField &        sizing,
                    int                        exterior,
                    std::uint64_t              seed,
                    ParticleSet &              particles);

/** \brief Moves the particles of the cells of dimension `dimension` apart until their spacing follows h.
 *
 * Each minimizes the energy of Meyer et al. (2007), E(d) = cot(pi d / 2) + pi d / 2 - pi / 2 for d < 1, where d is the
 * distance in units of sqrt(3) h, by damped Newton steps in its cell's tangent space, each followed by a projection.
 * Particles of lower cells rest and repel. Only particles of the same cell and, on a 2-cell, of the same sheet, and
 * those of lower cells in its rim, see each other. Between sweeps crowded particles leave and lonely ones split. */
RelaxationReport
RelaxParticles(const IndicatorSet &         indicators,
               const SizingField &          sizing,
               int                          dimension,
               const RelaxationParameters & parameters,
               ParticleSet &                particles,
               Monitor &                    monitor);
} // namespace mmm

#endif
