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
#ifndef mmmRelaxationState_h
#define mmmRelaxationState_h

#include "base/PointBins.h"
#include "particles/Particles.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
/** \brief The particles that relaxation moves, with their sizes, directions and neighbours.
 *
 * Active are those of the cells of one dimension; they move. */
class RelaxationState
{
public:
  static constexpr std::size_t ParticlesPerRange = 1024;

  RelaxationState(const IndicatorSet & indicators, const SizingField & sizing, int dimension, ParticleSet & particles);

  bool
  IsActive(std::size_t p) const
  {
    return particles.CellOf(p).Dimension() == dimension;
  }

  void
  UpdateSizes();
  /** The sizes at all particles, and the normals or tangents of those that move. */
  void
  UpdateAttributes();
  void
  ListNeighbours();

  /** Projects a particle on its cell; false where it would leave it. */
  bool
  Admit(std::size_t p, Vector & x) const;

  /** Calls visit(neighbour, offset to it, scaled distance d < 1, scale) for all neighbours in reach. */
  template <typename TVisitor>
  void
  VisitPairs(std::size_t p, TVisitor && visit) const
  {
    using Parameters = RelaxationParameters;
    const Vector & x = particles.positions[p];
    for (auto n = neighbourStart[p]; n < neighbourStart[p + 1]; ++n)
    {
      const auto   q = neighbours[n];
      const Vector offset = particles.positions[q] - x;
      const double scale = Parameters::Supports[dimension] * 0.5 * (double(sizes[p]) + sizes[q]);
      const double square = offset.squaredNorm() / (scale * scale);
      if (square < 1.0)
      {
        visit(q, offset, std::max(std::sqrt(square), Parameters::LeastDistance), scale);
      }
    }
  }

  const IndicatorSet & indicators;
  const SizingField &  sizing;
  const int            dimension;
  ParticleSet &        particles;
  std::vector<float>   sizes;
  /** Normals of particles on surfaces, tangents of those on curves. */
  std::vector<Vector> directions;
  /** Whether a neighbour is of another cell. */
  std::vector<char>          isNearJunction;
  std::vector<std::uint32_t> neighbourStart;
  std::vector<std::uint32_t> neighbours;

private:
  Vector
  DirectionOf(std::size_t p) const;
  /** Whether particle q repels particle p, which moves. */
  bool
  Repels(std::size_t q, std::size_t p) const;

  PointBins m_Bins;
};

/** \brief Removes the particle of highest energy of each crowded neighbourhood, and splits the lonely ones where there
 * is room. The neighbours have to be listed before, and again after. */
void
AdaptPopulation(RelaxationState & state, RelaxationReport & report);
} // namespace mmm

#endif
