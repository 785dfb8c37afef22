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
#include "base/Parallel.h"
#include "base/Shortened.h"
#include "particles/RelaxationState.h"

#include "itkMath.h"

namespace mmm
{
namespace
{
using Parameters = RelaxationParameters;

class Relaxation
{
public:
  Relaxation(const IndicatorSet &         indicators,
             const SizingField &          sizing,
             int                          dimension,
             const RelaxationParameters & parameters,
             ParticleSet &                particles)
    : m_Parameters(parameters)
    , m_State(indicators, sizing, dimension, particles)
  {}

  RelaxationReport
  Run(Monitor & monitor)
  {
    RelaxationReport report;
    this->UpdateAttributes();
    for (int sweep = 0; sweep < m_Parameters.maximumSweeps; ++sweep)
    {
      const bool populate =
        std::find(std::begin(Parameters::PopulationSweeps), std::end(Parameters::PopulationSweeps), sweep) !=
        std::end(Parameters::PopulationSweeps);
      if (populate)
      {
        m_State.ListNeighbours();
        AdaptPopulation(m_State, report);
        this->UpdateAttributes();
      }
      if (populate || sweep % Parameters::SweepsPerListing == 0)
      {
        m_State.ListNeighbours();
      }
      report.meanMove = this->Sweep();
      report.sweeps = sweep + 1;
      monitor.Report(double(sweep + 1) / m_Parameters.maximumSweeps);
      report.converged = report.meanMove < m_Parameters.tolerance;
      if (report.converged && sweep > *std::prev(std::end(Parameters::PopulationSweeps)))
      {
        break;
      }
    }
    this->Settle(report);
    monitor.Report(1.0);
    return report;
  }

private:
  /** Of what was listed before, nothing holds any more. */
  void
  UpdateAttributes()
  {
    m_State.UpdateAttributes();
    m_LastSteps.assign(m_State.particles.Size(), Vector::Zero());
    m_Dampings.assign(m_State.particles.Size(), Parameters::Damping);
  }

  /** The damped Newton step of one particle in the tangent space of its cell. */
  Vector
  Step(std::size_t p) const
  {
    Vector          force = Vector::Zero();
    Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
    m_State.VisitPairs(p, [&](std::uint32_t, const Vector & offset, double d, double scale) {
      const double angle = 0.5 * itk::Math::pi * d;
      const double cotangent = 1.0 / std::tan(angle);
      const double slope = 0.5 * itk::Math::pi * cotangent * cotangent;
      const double curvature = 0.5 * itk::Math::pi * itk::Math::pi * cotangent * (1.0 + cotangent * cotangent);
      const Vector u = offset / (d * scale);
      force -= slope / scale * u;
      hessian += curvature / (scale * scale) * u * u.transpose();
    });
    const Vector & direction = m_State.directions[p];
    if (m_State.dimension == 1)
    {
      const double stiffness = direction.dot(hessian * direction);
      return stiffness > 0.0 ? Vector(direction * (direction.dot(force) / stiffness)) : Vector::Zero();
    }
    if (m_State.dimension == 2)
    {
      force -= direction * direction.dot(force);
    }
    const double trace = hessian.trace();
    if (!(trace > 0.0))
    {
      return Vector::Zero();
    }
    hessian.diagonal().array() += Parameters::Regularization * trace;
    Vector step = hessian.ldlt().solve(force);
    if (m_State.dimension == 2)
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
    m_Dampings[p] = turnsBack ? Parameters::Shorter * m_Dampings[p]
                              : std::min(Parameters::Damping, Parameters::Longer * m_Dampings[p]);
    m_LastSteps[p] = step;
  }

  /** One step of all active particles, from the same positions. Returns the mean move in units of h. */
  double
  Sweep()
  {
    const std::size_t   count = m_State.particles.Size();
    std::vector<Vector> next(m_State.particles.positions);
    std::vector<Vector> directions(m_State.directions);
    std::vector<double> moves((count + RelaxationState::ParticlesPerRange - 1) / RelaxationState::ParticlesPerRange,
                              0.0);
    std::size_t         active = 0;
    for (std::size_t p = 0; p < count; ++p)
    {
      active += m_State.IsActive(p);
    }
    ParallelFor(count, RelaxationState::ParticlesPerRange, [&](std::size_t begin, std::size_t end) {
      double sum = 0.0;
      for (std::size_t p = begin; p < end; ++p)
      {
        if (!m_State.IsActive(p))
        {
          continue;
        }
        const double h = m_State.sizes[p];
        Vector       step = this->Step(p);
        this->UpdateDamping(p, step);
        step *= m_Dampings[p];
        if (!(step.norm() < Parameters::LargestStep))
        {
          continue;
        }
        Vector x = m_State.particles.positions[p] + Shortened(step, Parameters::LongestRelaxationMove * h);
        Vector direction = m_State.directions[p];
        if (this->Follow(p, x, direction))
        {
          sum += (x - m_State.particles.positions[p]).norm() / h;
          next[p] = x;
          directions[p] = direction;
        }
      }
      moves[begin / RelaxationState::ParticlesPerRange] = sum;
    });
    m_State.particles.positions.swap(next);
    m_State.directions.swap(directions);
    m_State.UpdateSizes();
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
    const Cell & cell = m_State.particles.CellOf(p);
    if (m_State.dimension == 3)
    {
      return m_State.Admit(p, x);
    }
    return m_State.indicators.Approach(cell, x, direction) &&
           (!m_State.isNearJunction[p] || m_State.indicators.IsMaximal(cell, x));
  }

  /** Projects all active particles exactly and drops those that do not lie on their cell. */
  void
  Settle(RelaxationReport & report)
  {
    const std::size_t count = m_State.particles.Size();
    std::vector<char> valid(count, 1);
    ParallelFor(count, RelaxationState::ParticlesPerRange, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p)
      {
        valid[p] = !m_State.IsActive(p) || m_State.Admit(p, m_State.particles.positions[p]);
      }
    });
    report.removed += m_State.particles.Keep(valid);
  }

  const RelaxationParameters & m_Parameters;
  RelaxationState              m_State;
  std::vector<Vector>          m_LastSteps;
  std::vector<float>           m_Dampings;
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
