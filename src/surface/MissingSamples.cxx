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
#include "surface/MissingSamples.h"

#include "base/MakeUnique.h"
#include "base/ParallelCollect.h"
#include "base/PointBins.h"
#include "particles/CellNumbers.h"
#include "surface/SampleFinder.h"
#include "surface/SurfaceParameters.h"

#include <algorithm>
#include <limits>

namespace mmm
{
namespace
{
using Parameters = MissingSampleParameters;

constexpr std::size_t TetrahedraPerRange = 4096;
constexpr std::size_t PartsPerRange = 64;

/** Makes a particle one of a cell that it all but touches. Returns whether it was none yet, and that cell is there: of
 * many materials, which meet in one point, some tell where that is. */
bool
MoveOnto(const IndicatorSet & indicators,
         const Cell &         cell,
         std::uint32_t        p,
         CellNumbers &        numbers,
         ParticleSet &        particles)
{
  if (cell == particles.CellOf(p))
  {
    return false;
  }
  constexpr int Most = 4;
  Cell          some = cell;
  while (some.count > Most)
  {
    std::copy(some.begin() + 1, some.end(), some.begin()); // the planes are the last
    --some.count;
  }
  Vector     x = particles.positions[p];
  const bool isThere = indicators.Project(some, x, 2.0 * Parameters::SameDistance) &&
                       indicators.IsMaximal(cell, x);
  if (!isThere && cell.Dimension() > 0)
  {
    return false;
  }
  particles.positions[p] = isThere ? x : particles.positions[p];
  particles.cells[p] = numbers(cell);
  return true;
}

/** The particle's cell, and the materials that it all but touches. */
Cell
CompleteCell(const IndicatorSet & indicators, const Cell & own, const Vector & x)
{
  double least = std::numeric_limits<double>::infinity();
  for (const Material m : own)
  {
    least = indicators.IsPlane(m) ? least : std::min(least, indicators.Value(m, x));
  }
  Cell       cell = own;
  const auto nearby = indicators.Candidates(x);
  std::for_each(nearby.first, nearby.second, [&](Material m) {
    if (!own.Has(m) && indicators.Value(m, x) > least - Parameters::SameDistance)
    {
      cell.Join(Cell{ m });
    }
  });
  return cell;
}

/** Completes the cells of the corners of parts. Returns how many were not complete. */
std::size_t
CompleteCells(const IndicatorSet & indicators, const std::vector<TetrahedronPart> & parts, ParticleSet & particles)
{
  std::vector<PointId> points;
  for (const TetrahedronPart & part : parts)
  {
    points.insert(points.end(), part.begin(), part.end());
  }
  MakeUnique(points);
  CellNumbers numbers(particles.cellTable);
  return std::size_t(std::count_if(points.begin(), points.end(), [&](PointId p) {
    const Cell cell = CompleteCell(indicators, particles.CellOf(p), particles.positions[p]);
    return MoveOnto(indicators, cell, p, numbers, particles);
  }));
}

/** Whether a tetrahedron has a face of an interface. */
bool
IsAtInterface(std::uint32_t                 t,
              const TetrahedralMesh &       mesh,
              const TetrahedronNeighbours & neighbours,
              Material                      exterior)
{
  return std::any_of(neighbours[t].begin(), neighbours[t].end(), [&](std::uint32_t other) {
    return mesh.materials[t] != (other == NoTetrahedron ? exterior : mesh.materials[other]);
  });
}
} // namespace

MissingSamples
FindMissingSamples(const IndicatorSet &          indicators,
                   const TetrahedralMesh &       mesh,
                   const TetrahedronNeighbours & neighbours,
                   Material                      exterior,
                   ParticleSet &                 particles)
{
  const SampleFinder finder(indicators, particles);
  auto               parts = ParallelCollect<TetrahedronPart>(
    mesh.tetrahedra.size(), TetrahedraPerRange, [&](std::size_t t, std::vector<TetrahedronPart> & found) {
      if (IsAtInterface(std::uint32_t(t), mesh, neighbours, exterior))
      {
        finder.ListParts(mesh.tetrahedra[t], found);
      }
    });
  MakeUnique(parts);
  MissingSamples missing;
  missing.completedCells = CompleteCells(indicators, parts, particles);
  missing.samples =
    ParallelCollect<MissingSample>(parts.size(), PartsPerRange, [&](std::size_t n, std::vector<MissingSample> & found) {
      MissingSample sample;
      if (!finder.HaveCommonMaterial(parts[n]) && finder.FindSample(parts[n], sample))
      {
        found.push_back(sample);
      }
    });
  return missing;
}

std::size_t
AddMissingSamples(const IndicatorSet &               indicators,
                  const SizingField &                sizing,
                  const std::vector<MissingSample> & samples,
                  ParticleSet &                      particles)
{
  if (samples.empty())
  {
    return 0;
  }
  CellNumbers                             numbers(particles.cellTable);
  PointBins                               binning(indicators.GetGrid());
  std::vector<std::vector<std::uint32_t>> bins(binning.NumberOfBins());
  for (std::size_t p = 0; p < particles.Size(); ++p)
  {
    bins[binning.BinAt(particles.positions[p])].push_back(std::uint32_t(p));
  }
  std::vector<char>          kept(particles.Size(), 1);
  std::vector<std::uint32_t> crowded;
  std::size_t                changes = 0;
  for (const MissingSample & sample : samples)
  {
    const double reach = std::max(Parameters::CrowdedDistance * sizing(sample.position), Parameters::SameDistance);
    auto         nearest = std::uint32_t(particles.Size());
    double       least = Parameters::SameDistance;
    crowded.clear();
    binning.VisitBins(sample.position, reach, [&](std::size_t bin) {
      for (const auto p : bins[bin])
      {
        const double distance = (particles.positions[p] - sample.position).norm();
        const Cell & cell = particles.CellOf(p);
        if (kept[p] && distance < least)
        {
          least = distance;
          nearest = p;
        }
        if (kept[p] && distance < reach && cell.Dimension() == 2 && cell != sample.cell && sample.cell.Includes(cell))
        {
          crowded.push_back(p);
        }
      }
    });
    if (nearest == particles.Size())
    {
      bins[binning.BinAt(sample.position)].push_back(nearest);
      particles.positions.push_back(sample.position);
      particles.cells.push_back(numbers(sample.cell));
      kept.push_back(1);
    }
    else
    {
      Cell joint = particles.CellOf(nearest);
      if (!joint.Join(sample.cell) || !MoveOnto(indicators, joint, nearest, numbers, particles))
      {
        continue;
      }
    }
    for (const auto p : crowded)
    {
      kept[p] = p == nearest;
    }
    ++changes;
  }
  particles.Keep(kept);
  return changes;
}
} // namespace mmm
