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
#include "particles/ParticleMerging.h"

#include "particles/CellNumbers.h"
#include "base/PointBins.h"

#include <algorithm>
#include <numeric>

namespace mmm
{
namespace
{
using Parameters = MergingParameters;

/** Moves particles that were joined onto the cell of all their materials, unless that brings them close to others.
 * Where that is a curve that does not exist there, they stay on the cell that they had. `bins` and `cells` have
 * positions and cells from before. */
void
MoveOntoCells(const IndicatorSet &               indicators,
              const PointBins &                  bins,
              const std::vector<std::uint32_t> & cells,
              const std::vector<char> &          kept,
              ParticleSet &                      particles)
{
  auto & positions = particles.positions;
  for (std::uint32_t p = 0; p < positions.size(); ++p)
  {
    if (particles.cells[p] == cells[p])
    {
      continue;
    }
    const Cell & joint = particles.CellOf(p);
    Vector       x = positions[p];
    if (!indicators.Project(joint, x, Parameters::JunctionDistance))
    {
      particles.cells[p] = joint.Dimension() > 0 ? cells[p] : particles.cells[p];
      continue;
    }
    bool isFree = indicators.IsMaximal(joint, x);
    if (isFree)
    {
      bins.Visit(x, Parameters::JunctionDistance + Parameters::LayerDistance, [&](std::uint32_t q) {
        isFree = isFree && (q == p || !kept[q] || (positions[q] - x).norm() > Parameters::LayerDistance);
      });
    }
    positions[p] = isFree ? x : positions[p];
  }
}
} // namespace

std::size_t
MergeCloseParticles(const IndicatorSet & indicators, const SizingField & sizing, ParticleSet & particles)
{
  const std::size_t          count = particles.Size();
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return particles.CellOf(a).count > particles.CellOf(b).count;
  });
  CellNumbers       numbers(particles.cellTable);
  PointBins         bins(indicators.GetGrid());
  std::vector<char> kept(count, 0);
  const auto        cells = particles.cells;
  bins.Assign(particles.positions);
  for (const auto p : order)
  {
    const Vector & x = particles.positions[p];
    const double   h = sizing(x);
    const double   reach = std::max(Parameters::SheetDistance * h, Parameters::JunctionDistance);
    std::uint32_t  nearest = p;
    double         least = reach * reach;
    bins.Visit(x, reach, [&](std::uint32_t q) {
      const double square = (particles.positions[q] - x).squaredNorm();
      if (!kept[q] || square > least || (square == least && q > nearest))
      {
        return;
      }
      const Cell & own = particles.CellOf(p);
      const Cell & other = particles.CellOf(q);
      double       limit = own.Dimension() == 2 ? Parameters::LayerDistance : Parameters::JunctionDistance;
      if (other.Includes(own) && (other != own || own.Dimension() != 2 ||
                                  indicators.Normal(own, x).dot(indicators.Normal(own, particles.positions[q])) > 0.0))
      {
        limit = Parameters::SheetDistance * h;
      }
      if (square < limit * limit)
      {
        least = square;
        nearest = q;
      }
    });
    kept[p] = 1;
    if (nearest != p)
    {
      Cell joint = particles.CellOf(nearest);
      if (joint.Join(particles.CellOf(p)))
      {
        particles.cells[nearest] = numbers(joint);
        kept[p] = 0;
      }
    }
  }
  MoveOntoCells(indicators, bins, cells, kept, particles);
  return particles.Keep(kept);
}
} // namespace mmm
