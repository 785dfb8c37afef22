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
#include "mmmMeshOptimizer.h"

#include "mmmEdgeCollapser.h"
#include "mmmEdgeRemover.h"
#include "mmmMeshOptimizerSmoothing.h"
#include "mmmSideChanger.h"
#include "mmmTriangleLookup.h"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace mmm
{
namespace
{
using Id = OptimizerState::Id;

/** Exterior tetrahedra below this quality are gaps that should not be there. */
const double FlatExterior = QualityOfAngle(2.0);

/** Local changes of the connectivity. Each keeps the space that is filled, the topology of the interfaces, and makes
 * the worst tetrahedron that it touches better. */
class ConnectivityImprover
{
public:
  explicit ConnectivityImprover(OptimizerState & state)
    : m_State(state)
    , m_EdgeRemover(state)
    , m_EdgeCollapser(state)
    , m_SideChanger(state, m_EdgeRemover)
  {}

  /** Works on all tetrahedra below a quality, worst first; those that are not below `poorQuality` get flips within
   * their material only. Returns the number of changes. */
  std::size_t
  Improve(double quality, double poorQuality)
  {
    std::vector<std::pair<double, Id>> bad;
    for (Id t = 0; t < m_State.complex.Size(); ++t)
    {
      if (m_State.complex.IsAlive(t))
      {
        const double q = m_State.Shape(t);
        if (q < (m_State.IsExterior(t) ? FlatExterior : quality))
        {
          bad.push_back({ q, t });
        }
      }
    }
    std::sort(bad.begin(), bad.end());
    std::size_t changes = 0;
    for (const auto & entry : bad)
    {
      const Id t = entry.second;
      // its place may have been taken by another one since
      if (!m_State.complex.IsAlive(t) || !(m_State.Shape(t) < quality))
      {
        continue;
      }
      const bool isPoor = m_State.Shape(t) < poorQuality;
      if (m_State.IsExterior(t))
      {
        // a gap this narrow is none
        changes += m_SideChanger.GiveToOtherSide(t);
      }
      else
      {
        changes += (isPoor && m_SideChanger.GiveToOtherSide(t)) || m_EdgeRemover.RemoveAny(t) ||
                   (isPoor && this->CollapseAny(t));
      }
    }
    return changes;
  }

  /** Works on all triangles of interfaces below a radius ratio, worst first. Returns the number of changes. */
  std::size_t
  ImproveTriangles(double radiusRatio)
  {
    struct Entry
    {
      double radiusRatio;
      Id     tetrahedron;
      int    face;
    };
    std::vector<Entry> bad;
    for (Id t = 0; t < m_State.complex.Size(); ++t)
    {
      for (int f = 0; f < 4 && m_State.complex.IsAlive(t) && !m_State.IsExterior(t); ++f)
      {
        const double r = this->RadiusRatioOfInterface(t, f);
        if (r < radiusRatio)
        {
          bad.push_back({ r, t, f });
        }
      }
    }
    std::sort(bad.begin(), bad.end(), [](const Entry & x, const Entry & y) {
      return std::tie(x.radiusRatio, x.tetrahedron, x.face) < std::tie(y.radiusRatio, y.tetrahedron, y.face);
    });
    std::size_t changes = 0;
    for (const auto & entry : bad)
    {
      if (m_State.complex.IsAlive(entry.tetrahedron) &&
          this->RadiusRatioOfInterface(entry.tetrahedron, entry.face) < radiusRatio)
      {
        changes += this->ImproveTriangle(entry.tetrahedron, entry.face);
      }
    }
    return changes;
  }

private:
  /** The radius ratio of a face on an interface; that of other faces does not count. */
  double
  RadiusRatioOfInterface(Id t, int face) const
  {
    if (!m_State.complex.IsInterface(t, face))
    {
      return 1.0;
    }
    const Triangle corners = FaceOf(m_State.complex.Corners(t), face);
    return TriangleRadiusRatio(m_State.points[corners[0]], m_State.points[corners[1]], m_State.points[corners[2]]);
  }

  bool
  ImproveTriangle(Id t, int face)
  {
    const Triangle corners = FaceOf(m_State.complex.Corners(t), face);
    const double   radiusRatio = this->RadiusRatioOfInterface(t, face) + OptimizerState::LeastGain;
    for (int c = 0; c < 3; ++c)
    {
      const PointId a = corners[c];
      const PointId b = corners[(c + 1) % 3];
      if (m_EdgeRemover.FlipForTriangles(t, a, b) || m_EdgeCollapser.CollapseForTriangles(t, a, b, radiusRatio) ||
          m_EdgeCollapser.CollapseForTriangles(t, b, a, radiusRatio))
      {
        return true;
      }
    }
    return false;
  }

  bool
  CollapseAny(Id t)
  {
    const Tetrahedron corners = m_State.complex.Corners(t);
    return std::any_of(std::begin(TetrahedronEdges), std::end(TetrahedronEdges), [&](const auto & edge) {
      const PointId a = corners[edge[0]];
      const PointId b = corners[edge[1]];
      return m_EdgeCollapser.Collapse(t, a, b) || m_EdgeCollapser.Collapse(t, b, a);
    });
  }

  OptimizerState & m_State;
  EdgeRemover      m_EdgeRemover;
  EdgeCollapser    m_EdgeCollapser;
  SideChanger      m_SideChanger;
};
} // namespace

OptimizationReport
OptimizeMesh(const InterfaceConstraint &    constraint,
             Material                       exterior,
             const OptimizationParameters & parameters,
             std::vector<Vector> &          points,
             TetrahedralComplex &           complex,
             Monitor &                      monitor)
{
  OptimizationReport report;
  const double       flipQuality = QualityOfAngle(parameters.flipAngle);
  const double       poorQuality = QualityOfAngle(parameters.poorAngle);
  OptimizerState     state{ constraint, exterior, parameters, points, complex, report };
  report.moves += PointSmoother(constraint, exterior, parameters, points, complex).SmoothAll();
  monitor.Report(0.1);
  for (int round = 0; round < parameters.rounds; ++round)
  {
    ConnectivityImprover improver(state);
    std::size_t          changes = improver.ImproveTriangles(parameters.poorTriangle);
    changes += improver.Improve(flipQuality, poorQuality);
    complex.Compact();
    PointSmoother smoother(constraint, exterior, parameters, points, complex);
    report.moves += smoother.SmoothWorst(poorQuality, parameters.interfaceTolerance);
    report.moves += smoother.SmoothAll();
    report.moves += smoother.SmoothTriangles(parameters.lowTriangle);
    report.moves += smoother.ReturnToCells();
    report.rounds = round + 1;
    monitor.Report(0.1 + 0.9 * (round + 1) / parameters.rounds);
    if (changes == 0)
    {
      break;
    }
  }
  return report;
}
} // namespace mmm
