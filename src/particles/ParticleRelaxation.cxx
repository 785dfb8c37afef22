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
#include "base/Hash.h"
#include "base/Parallel.h"
#include "particles/Particles.h"
#include "base/PointBins.h"

#include "itkMath.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
constexpr std::size_t Grain = 1024;
/** The energy vanishes at this distance, in units of h: on a surface the second ring of a hexagonal packing, in space
 * beyond the second shell of a close packing. By dimension. */
constexpr double Supports[] = { 1.0, 1.7320508, 1.7320508, 1.5 };
/** The energy of a particle with two, six or twelve neighbours at distance h. */
constexpr double IdealEnergies[] = { 0.0, 0.24, 0.72, 0.64 };
/** What counts as crowded and as lonely against it. */
constexpr double CrowdedEnergy = 1.6;
constexpr double LonelyEnergy = 0.65;
/** Neighbours are listed a little beyond the support of a particle's own h: there is room to move, and for neighbours
 * with a larger h. */
constexpr double ListingMargin = 1.2;
constexpr int    SweepsPerListing = 4;
constexpr float  Damping = 0.7f;
/** Factors on it where a particle turns back, and where it does not. */
constexpr float  Shorter = 0.3f;
constexpr float  Longer = 1.1f;
constexpr double LongestMove = 0.25;
/** Sweeps after which the population is adapted. */
constexpr int PopulationSweeps[] = { 3, 6, 9 };

class Relaxation
{
public:
  Relaxation(const IndicatorSet &         indicators,
             const SizingField &          sizing,
             int                          dimension,
             const RelaxationParameters & parameters,
             ParticleSet &                particles)
    : m_Indicators(indicators)
    , m_Sizing(sizing)
    , m_Dimension(dimension)
    , m_Parameters(parameters)
    , m_Particles(particles)
    , m_Bins(indicators.GetGrid(), 2.0)
  {}

  RelaxationReport
  Run(Monitor & monitor)
  {
    RelaxationReport report;
    this->UpdateAttributes();
    for (int sweep = 0; sweep < m_Parameters.maximumSweeps; ++sweep)
    {
      const bool populate =
        std::find(std::begin(PopulationSweeps), std::end(PopulationSweeps), sweep) != std::end(PopulationSweeps);
      if (populate)
      {
        this->ListNeighbours();
        this->AdaptPopulation(report);
        this->UpdateAttributes();
      }
      if (populate || sweep % SweepsPerListing == 0)
      {
        this->ListNeighbours();
      }
      report.meanMove = this->Sweep();
      report.sweeps = sweep + 1;
      monitor.Report(double(sweep + 1) / m_Parameters.maximumSweeps);
      report.converged = report.meanMove < m_Parameters.tolerance;
      if (report.converged && sweep > *std::prev(std::end(PopulationSweeps)))
      {
        break;
      }
    }
    this->Settle(report);
    monitor.Report(1.0);
    return report;
  }

private:
  bool
  IsActive(std::size_t p) const
  {
    return m_Particles.CellOf(p).Dimension() == m_Dimension;
  }

  void
  UpdateSizes()
  {
    const std::size_t count = m_Particles.Size();
    m_Sizes.resize(count);
    ParallelFor(count, Grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p)
      {
        m_Sizes[p] = float(m_Sizing(m_Particles.positions[p]));
      }
    });
  }

  /** The sizes at all particles, and the normals or tangents of those that move. */
  void
  UpdateAttributes()
  {
    this->UpdateSizes();
    const std::size_t count = m_Particles.Size();
    m_Directions.assign(count, Vector::Zero());
    m_LastSteps.assign(count, Vector::Zero());
    m_Dampings.assign(count, Damping);
    ParallelFor(count, Grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p)
      {
        m_Directions[p] = this->IsActive(p) ? this->Direction(p, m_Particles.positions[p]) : Vector::Zero();
      }
    });
  }

  /** The normal of a particle on a surface, the tangent of one on a curve. */
  Vector
  Direction(std::size_t p, const Vector & x) const
  {
    const Cell & cell = m_Particles.CellOf(p);
    return m_Dimension == 2 ? m_Indicators.Normal(cell, x)
                            : (m_Dimension == 1 ? m_Indicators.Tangent(cell, x) : Vector::Zero());
  }

  /** Whether particle q repels particle p, which moves. */
  bool
  Repels(std::size_t q, std::size_t p) const
  {
    if (m_Particles.cells[q] == m_Particles.cells[p])
    {
      return m_Dimension != 2 || m_Directions[q].dot(m_Directions[p]) > 0.0;
    }
    const Cell & other = m_Particles.CellOf(q);
    const Cell & own = m_Particles.CellOf(p);
    return other.count > own.count && other.Includes(own);
  }

  void
  ListNeighbours()
  {
    const std::size_t count = m_Particles.Size();
    const std::size_t ranges = (count + Grain - 1) / Grain;
    m_Bins.Assign(m_Particles.positions);
    std::vector<std::vector<std::uint32_t>> parts(ranges);
    m_NeighbourStart.assign(count + 1, 0);
    m_NearJunction.assign(count, 0);
    ParallelFor(count, Grain, [&](std::size_t begin, std::size_t end) {
      auto & part = parts[begin / Grain];
      for (std::size_t p = begin; p < end; ++p)
      {
        const std::size_t before = part.size();
        if (this->IsActive(p))
        {
          const double   reach = ListingMargin * Supports[m_Dimension] * m_Sizes[p];
          const Vector & x = m_Particles.positions[p];
          m_Bins.Visit(x, reach, [&](std::uint32_t q) {
            if (q != p && (m_Particles.positions[q] - x).squaredNorm() < reach * reach && this->Repels(q, p))
            {
              part.push_back(q);
              m_NearJunction[p] |= m_Particles.cells[q] != m_Particles.cells[p];
            }
          });
        }
        m_NeighbourStart[p + 1] = std::uint32_t(part.size() - before);
      }
    });
    for (std::size_t p = 0; p < count; ++p)
    {
      m_NeighbourStart[p + 1] += m_NeighbourStart[p];
    }
    m_Neighbours.clear();
    m_Neighbours.reserve(m_NeighbourStart.back());
    for (const auto & part : parts)
    {
      m_Neighbours.insert(m_Neighbours.end(), part.begin(), part.end());
    }
  }

  /** Calls visit(offset to the neighbour, scaled distance d < 1) for all neighbours in reach. */
  template <typename TVisitor>
  void
  VisitPairs(std::size_t p, TVisitor && visit) const
  {
    const Vector & x = m_Particles.positions[p];
    for (auto n = m_NeighbourStart[p]; n < m_NeighbourStart[p + 1]; ++n)
    {
      const auto   q = m_Neighbours[n];
      const Vector offset = m_Particles.positions[q] - x;
      const double scale = Supports[m_Dimension] * 0.5 * (double(m_Sizes[p]) + m_Sizes[q]);
      const double square = offset.squaredNorm() / (scale * scale);
      if (square < 1.0)
      {
        visit(q, offset, std::max(std::sqrt(square), 0.05), scale);
      }
    }
  }

  /** The damped Newton step of one particle in the tangent space of its cell. */
  Vector
  Step(std::size_t p) const
  {
    Vector          force = Vector::Zero();
    Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
    this->VisitPairs(p, [&](std::uint32_t, const Vector & offset, double d, double scale) {
      const double angle = 0.5 * itk::Math::pi * d;
      const double cotangent = 1.0 / std::tan(angle);
      const double slope = 0.5 * itk::Math::pi * cotangent * cotangent;
      const double curvature = 0.5 * itk::Math::pi * itk::Math::pi * cotangent * (1.0 + cotangent * cotangent);
      const Vector u = offset / (d * scale);
      force -= slope / scale * u;
      hessian += curvature / (scale * scale) * u * u.transpose();
    });
    const Vector & direction = m_Directions[p];
    if (m_Dimension == 1)
    {
      const double stiffness = direction.dot(hessian * direction);
      return stiffness > 0.0 ? Vector(direction * (direction.dot(force) / stiffness)) : Vector::Zero();
    }
    if (m_Dimension == 2)
    {
      force -= direction * direction.dot(force);
    }
    const double trace = hessian.trace();
    if (!(trace > 0.0))
    {
      return Vector::Zero();
    }
    hessian.diagonal().array() += 0.05 * trace;
    Vector step = hessian.ldlt().solve(force);
    if (m_Dimension == 2)
    {
      step -= direction * direction.dot(step);
    }
    return step;
  }

  /** A particle that turns back takes shorter steps: where a sheet is bent within h, neighbours come in sight and leave
   * it, and it would never rest. */
  void
  UpdateDamping(std::size_t p, const Vector & step)
  {
    const bool turnsBack = step.dot(m_LastSteps[p]) < 0.0;
    m_Dampings[p] = turnsBack ? Shorter * m_Dampings[p] : std::min(Damping, Longer * m_Dampings[p]);
    m_LastSteps[p] = step;
  }

  /** One step of all active particles, from the same positions. Returns the mean move in units of h. */
  double
  Sweep()
  {
    const std::size_t   count = m_Particles.Size();
    std::vector<Vector> next(m_Particles.positions);
    std::vector<Vector> directions(m_Directions);
    std::vector<double> moves((count + Grain - 1) / Grain, 0.0);
    std::size_t         active = 0;
    for (std::size_t p = 0; p < count; ++p)
    {
      active += this->IsActive(p);
    }
    ParallelFor(count, Grain, [&](std::size_t begin, std::size_t end) {
      double sum = 0.0;
      for (std::size_t p = begin; p < end; ++p)
      {
        if (!this->IsActive(p))
        {
          continue;
        }
        const double h = m_Sizes[p];
        Vector       step = this->Step(p);
        this->UpdateDamping(p, step);
        step *= m_Dampings[p];
        const double length = step.norm();
        if (!(length < 1e3))
        {
          continue;
        }
        if (length > LongestMove * h)
        {
          step *= LongestMove * h / length;
        }
        Vector x = m_Particles.positions[p] + step;
        Vector direction = m_Directions[p];
        if (this->Follow(p, x, direction))
        {
          sum += (x - m_Particles.positions[p]).norm() / h;
          next[p] = x;
          directions[p] = direction;
        }
      }
      moves[begin / Grain] = sum;
    });
    m_Particles.positions.swap(next);
    m_Directions.swap(directions);
    this->UpdateSizes();
    double sum = 0.0;
    for (const double move : moves)
    {
      sum += move;
    }
    return active ? sum / active : 0.0;
  }

  /** Brings a particle that moved a little back to its cell, to first order. Others' maximality can end the cell only
   * beside a junction, whose particles are then among the neighbours. */
  bool
  Follow(std::size_t p, Vector & x, Vector & direction) const
  {
    const Cell & cell = m_Particles.CellOf(p);
    if (m_Dimension == 3)
    {
      return this->Admit(p, x);
    }
    return m_Indicators.Approach(cell, x, direction) &&
           (!m_NearJunction[p] || m_Indicators.IsMaximal(cell, x, IndicatorSet::MaximalityTolerance));
  }

  /** Projects a moved particle on its cell; false where it would leave it. */
  bool
  Admit(std::size_t p, Vector & x) const
  {
    const Cell & cell = m_Particles.CellOf(p);
    if (m_Dimension == 3)
    {
      return m_Indicators.MaterialAt(x) == cell.materials[0];
    }
    return m_Indicators.ProjectWhereMaximal(cell, x, 0.5 * m_Sizes[p]);
  }

  double
  Energy(std::size_t p) const
  {
    double energy = 0.0;
    this->VisitPairs(p, [&](std::uint32_t, const Vector &, double d, double) {
      const double angle = 0.5 * itk::Math::pi * d;
      energy += 1.0 / std::tan(angle) + angle - 0.5 * itk::Math::pi;
    });
    return energy;
  }

  /** Removes the particle of highest energy of each crowded neighbourhood; splits the lonely ones. */
  void
  AdaptPopulation(RelaxationReport & report)
  {
    if (m_Dimension == 0)
    {
      return;
    }
    const std::size_t  count = m_Particles.Size();
    std::vector<float> energy(count, 0.0f);
    std::vector<char>  kept(count, 1);
    ParallelFor(count, Grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p)
      {
        energy[p] = this->IsActive(p) ? float(this->Energy(p) / IdealEnergies[m_Dimension]) : 0.0f;
      }
    });
    std::vector<Vector>        splitPositions;
    std::vector<std::uint32_t> splitCells;
    for (std::size_t p = 0; p < count; ++p)
    {
      if (!this->IsActive(p))
      {
        continue;
      }
      if (energy[p] > CrowdedEnergy)
      {
        bool worst = true;
        this->VisitPairs(p, [&](std::uint32_t q, const Vector &, double, double) {
          worst = worst && kept[q] && (energy[q] < energy[p] || (energy[q] == energy[p] && q > p));
        });
        kept[p] = !worst;
        report.removed += worst;
      }
      else if (energy[p] < LonelyEnergy)
      {
        bool loneliest = true;
        this->VisitPairs(p, [&](std::uint32_t q, const Vector &, double, double) {
          loneliest = loneliest && (!this->IsActive(q) || energy[q] > energy[p] || (energy[q] == energy[p] && q > p));
        });
        Vector x;
        if (loneliest && this->FindFreePlace(p, x))
        {
          splitPositions.push_back(x);
          splitCells.push_back(m_Particles.cells[p]);
        }
      }
    }
    m_Particles.Keep(kept);
    m_Particles.positions.insert(m_Particles.positions.end(), splitPositions.begin(), splitPositions.end());
    m_Particles.cells.insert(m_Particles.cells.end(), splitCells.begin(), splitCells.end());
    report.added += splitPositions.size();
  }

  /** The directions in which a lonely particle looks for room, of unit length: both ways along a curve, around in a
   * surface's tangent plane, or towards the faces and corners of a cube. */
  std::vector<Vector>
  LookAround(std::size_t p) const
  {
    const Vector &      direction = m_Directions[p];
    std::vector<Vector> places;
    if (m_Dimension == 1)
    {
      places = { direction, -direction };
    }
    else if (m_Dimension == 2)
    {
      constexpr int Count = 12;
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

  /** The place around a lonely particle that is furthest from its neighbours, at least 0.7 h from each. */
  bool
  FindFreePlace(std::size_t p, Vector & best) const
  {
    const double h = m_Sizes[p];
    double       widest = 0.7 * h;
    bool         found = false;
    for (const Vector & direction : this->LookAround(p))
    {
      Vector x = m_Particles.positions[p] + h * direction;
      double clearance = h;
      for (auto n = m_NeighbourStart[p]; n < m_NeighbourStart[p + 1]; ++n)
      {
        clearance = std::min(clearance, (m_Particles.positions[m_Neighbours[n]] - x).norm());
      }
      if (clearance > widest && this->Admit(p, x))
      {
        widest = clearance;
        best = x;
        found = true;
      }
    }
    return found;
  }

  /** Projects all active particles exactly and drops those that do not lie on their cell. */
  void
  Settle(RelaxationReport & report)
  {
    const std::size_t count = m_Particles.Size();
    std::vector<char> valid(count, 1);
    ParallelFor(count, Grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p)
      {
        valid[p] = !this->IsActive(p) || this->Admit(p, m_Particles.positions[p]);
      }
    });
    report.removed += m_Particles.Keep(valid);
  }

  const IndicatorSet &         m_Indicators;
  const SizingField &          m_Sizing;
  const int                    m_Dimension;
  const RelaxationParameters & m_Parameters;
  ParticleSet &                m_Particles;
  PointBins                    m_Bins;
  std::vector<float>           m_Sizes;
  std::vector<Vector>          m_Directions;
  std::vector<Vector>          m_LastSteps;
  std::vector<float>           m_Dampings;
  std::vector<char>            m_NearJunction;
  std::vector<std::uint32_t>   m_NeighbourStart;
  std::vector<std::uint32_t>   m_Neighbours;
};
} // namespace

RelaxationReport
RelaxParticles(const IndicatorSet &         indicators,
               const SizingField &          sizing,
               int                          dimension,
               const RelaxationParameters & parameters,
               ParticleSet &                particles,
               Monitor &                    monitor)
{
  return Relaxation(indicators, sizing, dimension, parameters, particles).Run(monitor);
}
} // namespace mmm
