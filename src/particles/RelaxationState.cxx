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
#include "particles/RelaxationState.h"

#include "base/Parallel.h"

namespace mmm
{
namespace
{
using Parameters = RelaxationParameters;
} // namespace

RelaxationState::RelaxationState(const IndicatorSet & indicatorSet,
                                 const SizingField &  sizingField,
                                 int                  cellDimension,
                                 ParticleSet &        particleSet)
  : indicators(indicatorSet)
  , sizing(sizingField)
  , dimension(cellDimension)
  , particles(particleSet)
  , m_Bins(indicatorSet.GetGrid())
{}

void
RelaxationState::UpdateSizes()
{
  const std::size_t count = particles.Size();
  sizes.resize(count);
  ParallelFor(count, ParticlesPerRange, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
    {
      sizes[p] = float(sizing(particles.positions[p]));
    }
  });
}

void
RelaxationState::UpdateAttributes()
{
  this->UpdateSizes();
  const std::size_t count = particles.Size();
  directions.assign(count, Vector::Zero());
  ParallelFor(count, ParticlesPerRange, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
    {
      directions[p] = this->IsActive(p) ? this->DirectionOf(p) : Vector::Zero();
    }
  });
}

void
RelaxationState::ListNeighbours()
{
  const std::size_t count = particles.Size();
  const std::size_t ranges = (count + ParticlesPerRange - 1) / ParticlesPerRange;
  m_Bins.Assign(particles.positions);
  std::vector<std::vector<std::uint32_t>> parts(ranges);
  neighbourStart.assign(count + 1, 0);
  isNearJunction.assign(count, 0);
  ParallelFor(count, ParticlesPerRange, [&](std::size_t begin, std::size_t end) {
    auto & part = parts[begin / ParticlesPerRange];
    for (std::size_t p = begin; p < end; ++p)
    {
      const std::size_t before = part.size();
      if (this->IsActive(p))
      {
        const double   reach = Parameters::ListingMargin * Parameters::Supports[dimension] * sizes[p];
        const Vector & x = particles.positions[p];
        m_Bins.Visit(x, reach, [&](std::uint32_t q) {
          if (q != p && (particles.positions[q] - x).squaredNorm() < reach * reach && this->Repels(q, p))
          {
            part.push_back(q);
            isNearJunction[p] |= particles.cells[q] != particles.cells[p];
          }
        });
      }
      neighbourStart[p + 1] = std::uint32_t(part.size() - before);
    }
  });
  for (std::size_t p = 0; p < count; ++p)
  {
    neighbourStart[p + 1] += neighbourStart[p];
  }
  neighbours.clear();
  neighbours.reserve(neighbourStart.back());
  for (const auto & part : parts)
  {
    neighbours.insert(neighbours.end(), part.begin(), part.end());
  }
}

bool
RelaxationState::Admit(std::size_t p, Vector & x) const
{
  const Cell & cell = particles.CellOf(p);
  if (dimension == 3)
  {
    return indicators.MaterialAt(x) == cell.materials[0];
  }
  return indicators.ProjectWhereMaximal(cell, x, Parameters::Reach * sizes[p]);
}

Vector
RelaxationState::DirectionOf(std::size_t p) const
{
  const Cell &   cell = particles.CellOf(p);
  const Vector & x = particles.positions[p];
  return dimension == 2   ? indicators.Normal(cell, x)
         : dimension == 1 ? indicators.Tangent(cell, x)
                          : Vector(Vector::Zero());
}

bool
RelaxationState::Repels(std::size_t q, std::size_t p) const
{
  if (particles.cells[q] == particles.cells[p])
  {
    return dimension != 2 || directions[q].dot(directions[p]) > 0.0;
  }
  const Cell & other = particles.CellOf(q);
  const Cell & own = particles.CellOf(p);
  return other.count > own.count && other.Includes(own);
}
} // namespace mmm
