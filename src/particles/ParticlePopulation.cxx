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

#include "itkMath.h"

namespace mmm
{
namespace
{
using Parameters = RelaxationParameters;

/** Of the others' repulsion. */
double
Energy(const RelaxationState & state, std::size_t p)
{
  double energy = 0.0;
  state.VisitPairs(p, [&](std::uint32_t, const Vector &, double d, double) {
    const double angle = 0.5 * itk::Math::pi * d;
    energy += 1.0 / std::tan(angle) + angle - 0.5 * itk::Math::pi;
  });
  return energy;
}

/** The directions in which a lonely particle looks for room, of unit length: both ways along a curve, around in a
 * surface's tangent plane, or towards the faces and corners of a cube. */
std::vector<Vector>
LookAround(const RelaxationState & state, std::size_t p)
{
  const Vector &      direction = state.directions[p];
  std::vector<Vector> places;
  if (state.dimension == 1)
  {
    places = { direction, -direction };
  }
  else if (state.dimension == 2)
  {
    constexpr int Count = Parameters::SearchDirections;
    const Vector  u = direction.unitOrthogonal();
    const Vector  v = direction.cross(u);
    for (int n = 0; n < Count; ++n)
    {
      const double angle = 2.0 * itk::Math::pi * n / Count;
      places.push_back(std::cos(angle) * u + std::sin(angle) * v);
    }
  }
  else
  {
    for (int a = 0; a < 3; ++a)
    {
      places.push_back(Vector::Unit(a));
      places.push_back(-Vector::Unit(a));
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      places.push_back(Vector(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1).normalized());
    }
  }
  return places;
}

/** The place around a lonely particle that is furthest from its neighbours, not too near to any. */
bool
FindFreePlace(const RelaxationState & state, std::size_t p, Vector & best)
{
  const double h = state.sizes[p];
  double       widest = Parameters::LeastClearance * h;
  bool         found = false;
  for (const Vector & direction : LookAround(state, p))
  {
    Vector x = state.particles.positions[p] + h * direction;
    double clearance = h;
    for (auto n = state.neighbourStart[p]; n < state.neighbourStart[p + 1]; ++n)
    {
      clearance = std::min(clearance, (state.particles.positions[state.neighbours[n]] - x).norm());
    }
    if (clearance > widest && state.Admit(p, x))
    {
      widest = clearance;
      best = x;
      found = true;
    }
  }
  return found;
}
} // namespace

void
AdaptPopulation(RelaxationState & state, RelaxationReport & report)
{
  if (state.dimension == 0)
  {
    return;
  }
  const std::size_t  count = state.particles.Size();
  std::vector<float> energy(count, 0.0f);
  std::vector<char>  kept(count, 1);
  ParallelFor(count, RelaxationState::ParticlesPerRange, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
    {
      energy[p] = state.IsActive(p) ? float(Energy(state, p) / Parameters::IdealEnergies[state.dimension]) : 0.0f;
    }
  });
  std::vector<Vector>        splitPositions;
  std::vector<std::uint32_t> splitCells;
  for (std::size_t p = 0; p < count; ++p)
  {
    if (!state.IsActive(p))
    {
      continue;
    }
    if (energy[p] > Parameters::CrowdedEnergy)
    {
      bool worst = true;
      state.VisitPairs(p, [&](std::uint32_t q, const Vector &, double, double) {
        worst = worst && kept[q] && (energy[q] < energy[p] || (energy[q] == energy[p] && q > p));
      });
      kept[p] = !worst;
      report.removed += worst;
    }
    else if (energy[p] < Parameters::LonelyEnergy)
    {
      bool loneliest = true;
      state.VisitPairs(p, [&](std::uint32_t q, const Vector &, double, double) {
        loneliest = loneliest && (!state.IsActive(q) || energy[q] > energy[p] || (energy[q] == energy[p] && q > p));
      });
      Vector x;
      if (loneliest && FindFreePlace(state, p, x))
      {
        splitPositions.push_back(x);
        splitCells.push_back(state.particles.cells[p]);
      }
    }
  }
  state.particles.Keep(kept);
  state.particles.positions.insert(state.particles.positions.end(), splitPositions.begin(), splitPositions.end());
  state.particles.cells.insert(state.particles.cells.end(), splitCells.begin(), splitCells.end());
  report.added += splitPositions.size();
}
} // namespace mmm
