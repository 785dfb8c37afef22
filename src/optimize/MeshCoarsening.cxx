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
#include "optimize/MeshCoarsening.h"

#include "base/ParallelCollect.h"
#include "optimize/CoarseningParameters.h"
#include "optimize/EdgeCollapser.h"
#include "optimize/ShapeQuality.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace mmm
{
namespace
{
using Id = OptimizerState::Id;
using Parameters = CoarseningParameters;

constexpr std::size_t TetrahedraPerRange = 16384;
constexpr std::size_t EdgesPerRange = 256;

struct ShortEdge
{
  double  length; // in units of the size there
  PointId a;
  PointId b;
  Id      tetrahedron; // one that has it

  bool
  operator<(const ShortEdge & other) const
  {
    return std::tie(length, a, b) < std::tie(other.length, other.a, other.b);
  }
};

/** One round after another. */
class Coarsening
{
public:
  Coarsening(OptimizerState & state, const std::function<double(const Vector &)> & size)
    : m_State(state)
    , m_Size(size)
  {}

  /** The root mean cube of the lengths that edges would have in regular tetrahedra of these volumes, in units of the
   * size: how much longer than asked for. */
  double
  RelativeLength() const
  {
    const auto cubes = ParallelCollect<double>(
      m_State.complex.Size(), TetrahedraPerRange, [&](std::size_t t, std::vector<double> & list) {
        if (this->Counts(Id(t)))
        {
          const auto & c = m_State.complex.Corners(Id(t));
          const auto & x = m_State.points;
          const Vector centre = 0.25 * (x[c[0]] + x[c[1]] + x[c[2]] + x[c[3]]);
          list.push_back(TetrahedronVolume(x[c[0]], x[c[1]], x[c[2]], x[c[3]]) / std::pow(m_Size(centre), 3));
        }
      });
    double sum = 0.0;
    for (const double cube : cubes)
    {
      sum += cube;
    }
    return std::cbrt(6.0 * std::sqrt(2.0) * sum / double(std::max<std::size_t>(cubes.size(), 1)));
  }

  /** Pulls edges together that are shorter than this, in units of the size, but no two that touch, until `surplus`
   * tetrahedra are gone. Returns how many are. */
  std::size_t
  CollapseShort(double length, std::size_t surplus)
  {
    const auto                 edges = this->FindShort(length);
    std::vector<ComplexChange> changes(edges.size());
    std::vector<char>          isFound(edges.size(), 0);
    ParallelFor(edges.size(), EdgesPerRange, [&](std::size_t begin, std::size_t end) {
      EdgeCollapser collapser(m_State);
      for (std::size_t n = begin; n < end; ++n)
      {
        isFound[n] = char(this->FindCollapse(edges[n], collapser, changes[n]));
      }
    });
    m_State.complex.ForgetTouched();
    std::size_t gone = 0;
    for (std::size_t n = 0; n < edges.size() && gone < surplus; ++n)
    {
      if (isFound[n] && changes[n].IsUpToDate(m_State.complex))
      {
        gone += this->CountOf(changes[n]);
        m_State.Make(changes[n]);
      }
    }
    m_State.complex.Compact();
    return gone;
  }

private:
  bool
  Counts(Id t) const
  {
    return m_State.complex.IsAlive(t) && !m_State.IsExterior(t);
  }

  std::vector<ShortEdge>
  FindShort(double length) const
  {
    auto edges = ParallelCollect<ShortEdge>(
      m_State.complex.Size(), TetrahedraPerRange, [&](std::size_t t, std::vector<ShortEdge> & list) {
        if (this->Counts(Id(t)))
        {
          const Tetrahedron & corners = m_State.complex.Corners(Id(t));
          for (const auto & edge : TetrahedronEdges)
          {
            const auto [a, b] = std::minmax(corners[edge[0]], corners[edge[1]]);
            const Vector & x = m_State.points[a];
            const Vector & y = m_State.points[b];
            const double   relative = (y - x).norm() / m_Size(0.5 * (x + y));
            if (relative < length)
            {
              list.push_back({ relative, a, b, Id(t) });
            }
          }
        }
      });
    std::stable_sort(edges.begin(), edges.end());
    const auto isSame = [](const ShortEdge & e, const ShortEdge & f) { return e.a == f.a && e.b == f.b; };
    edges.erase(std::unique(edges.begin(), edges.end(), isSame), edges.end());
    return edges;
  }

  bool
  FindCollapse(const ShortEdge & edge, EdgeCollapser & collapser, ComplexChange & change) const
  {
    static const double leastQuality = QualityOfAngle(Parameters::LeastAngle);
    const auto          find = [&](PointId from, PointId to) {
      return collapser.FindForEdge(edge.tetrahedron, from, to, Parameters::LeastTriangle, leastQuality, change);
    };
    return find(edge.a, edge.b) || find(edge.b, edge.a);
  }

  /** The tetrahedra that are fewer after a change, without the exterior's. */
  std::size_t
  CountOf(const ComplexChange & change) const
  {
    const auto before =
      std::count_if(change.old.begin(), change.old.end(), [this](Id t) { return !m_State.IsExterior(t); });
    const auto after = std::count_if(change.fresh.begin(), change.fresh.end(), [this](const auto & element) {
      return element.material != m_State.exterior;
    });
    return std::size_t(before - after);
  }

  OptimizerState &                              m_State;
  const std::function<double(const Vector &)> & m_Size;
};
} // namespace

std::size_t
CountTetrahedra(const TetrahedralComplex & complex, Material exterior)
{
  std::size_t count = 0;
  for (std::size_t t = 0; t < complex.Size(); ++t)
  {
    count += complex.IsAlive(TetrahedralComplex::Id(t)) && complex.MaterialOf(TetrahedralComplex::Id(t)) != exterior;
  }
  return count;
}

void
CoarsenMesh(const InterfaceConstraint &                     constraint,
            Material                                        exterior,
            const OptimizationParameters &                  parameters,
            const std::function<double(const Vector & x)> & size,
            std::size_t                                     wanted,
            std::vector<Vector> &                           points,
            TetrahedralComplex &                            complex,
            OptimizationReport &                            report,
            Monitor &                                       monitor)
{
  std::size_t count = CountTetrahedra(complex, exterior);
  if (count <= wanted)
  {
    return;
  }
  const std::size_t tooMany = count - wanted;
  const double      growth = std::cbrt(double(count) / double(wanted));

  OptimizationParameters coarse = parameters;
  coarse.interfaceTolerance *= std::min(growth, Parameters::LargestTolerance);
  OptimizerState state{ constraint, exterior, coarse, points, complex, report };
  Coarsening     coarsening(state, size);
  const double   target = growth * coarsening.RelativeLength();

  OptimizationParameters oneRound = parameters;
  oneRound.rounds = 1;
  Monitor    silent;
  const auto smooth = [&](const OptimizationParameters & by) {
    const auto done = OptimizeMesh(constraint, exterior, by, points, complex, silent);
    report.flips += done.flips;
    report.interfaceFlips += done.interfaceFlips;
    report.relabelled += done.relabelled;
    report.collapses += done.collapses;
    report.moves += done.moves;
    count = CountTetrahedra(complex, exterior);
  };
  double length = Parameters::ShortEdge * target;
  for (int round = 0; round < Parameters::Rounds && count > wanted; ++round)
  {
    const std::size_t before = count;
    for (int pass = 0; pass < Parameters::Passes && count > wanted; ++pass)
    {
      count -= coarsening.CollapseShort(length, count - wanted);
    }
    smooth(oneRound);
    if (double(before) - double(count) < Parameters::LittleGain * double(before))
    {
      length *= Parameters::Growth;
      if (length > Parameters::LongestEdge * target)
      {
        break;
      }
    }
    monitor.Report(1.0 - double(count > wanted ? count - wanted : 0) / double(tooMany));
  }
  smooth(parameters);
}
} // namespace mmm
