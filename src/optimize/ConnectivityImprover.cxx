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
#include "optimize/ConnectivityImprover.h"

#include "optimize/EdgeCollapser.h"
#include "optimize/EdgeRemover.h"
#include "base/ParallelCollect.h"
#include "optimize/ShapeQuality.h"
#include "optimize/SideChanger.h"
#include "mesh/TriangleLookup.h"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace mmm
{
namespace
{
using Id = OptimizerState::Id;

/** Exterior tetrahedra below this quality are gaps that should not be there. */
const double FlatExterior = QualityOfAngle(OptimizationParameters::GapAngle);

/** Looks for what makes one tetrahedron, or one triangle, better. */
class Finder
{
public:
  explicit Finder(const OptimizerState & state)
    : m_State(state)
    , m_EdgeRemover(state)
    , m_EdgeCollapser(state)
  {}

  /** A poor one may lose a corner. */
  bool
  ForTetrahedron(Id t, bool isPoor, ComplexChange & change)
  {
    return m_EdgeRemover.FindAny(t, change) || (isPoor && m_EdgeCollapser.FindAny(t, change));
  }

  bool
  ForTriangle(Id t, int face, ComplexChange & change)
  {
    const Triangle corners = FaceOf(m_State.complex.Corners(t), face);
    const double   radiusRatio = this->RadiusRatioOfInterface(t, face) + OptimizationParameters::LeastGain;
    for (int c = 0; c < 3; ++c)
    {
      if (m_EdgeRemover.FindForTriangles(t, corners[c], corners[(c + 1) % 3], change))
      {
        return true;
      }
    }
    return m_EdgeCollapser.FindForTriangles(t, { corners.begin(), corners.end() }, radiusRatio, WorstQuality, change);
  }

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

private:
  const OptimizerState & m_State;
  EdgeRemover            m_EdgeRemover;
  EdgeCollapser          m_EdgeCollapser;
};

/** A tetrahedron, or one of its faces on an interface, that is to get better. */
struct Candidate
{
  double quality;
  Id     tetrahedron;
  int    face;

  /** Worst first. */
  bool
  operator<(const Candidate & other) const
  {
    return std::tie(quality, tetrahedron, face) < std::tie(other.quality, other.tetrahedron, other.face);
  }
};

/** Looks for changes side by side, and makes them in order. Where another one has touched the surroundings in the
 * meantime, they are looked for again. */
class ConnectivityImprover
{
public:
  explicit ConnectivityImprover(OptimizerState & state)
    : m_State(state)
    , m_Finder(state)
    , m_SideChanger(state)
  {
    m_State.complex.ForgetTouched();
  }

  std::size_t
  ImproveTetrahedra(double quality, double poorQuality)
  {
    const auto isWanted = [&](Id t) { return m_State.Shape(t) < (m_State.IsExterior(t) ? FlatExterior : quality); };
    const auto candidates = this->Collect([&](Id t, std::vector<Candidate> & list) {
      if (isWanted(t))
      {
        list.push_back({ m_State.Shape(t), t, 0 });
      }
    });
    const auto isPoor = [&](const Candidate & c) { return m_State.Shape(c.tetrahedron) < poorQuality; };
    return this->ChangeAll(
      candidates,
      [&](const Candidate & c) { return isWanted(c.tetrahedron); },
      // what is exterior is a gap this narrow that it is none
      [&](const Candidate & c) {
        return (m_State.IsExterior(c.tetrahedron) || isPoor(c)) && m_SideChanger.GiveToOtherSide(c.tetrahedron);
      },
      [&](const Candidate & c, Finder & finder, ComplexChange & change) {
        return !m_State.IsExterior(c.tetrahedron) && finder.ForTetrahedron(c.tetrahedron, isPoor(c), change);
      });
  }

  std::size_t
  ImproveTriangles(double radiusRatio)
  {
    const auto candidates = this->Collect([&](Id t, std::vector<Candidate> & list) {
      for (int f = 0; f < 4 && !m_State.IsExterior(t); ++f)
      {
        // each once: one finds the same from its other side, or something in the next round
        const Id     other = m_State.complex.Neighbour(t, f);
        const bool   isOthers = other < t && !m_State.IsExterior(other);
        const double r = isOthers ? 1.0 : m_Finder.RadiusRatioOfInterface(t, f);
        if (r < radiusRatio)
        {
          list.push_back({ r, t, f });
        }
      }
    });
    return this->ChangeAll(
      candidates,
      [&](const Candidate & c) { return m_Finder.RadiusRatioOfInterface(c.tetrahedron, c.face) < radiusRatio; },
      [](const Candidate &) { return false; },
      [](const Candidate & c, Finder & finder, ComplexChange & change) {
        return finder.ForTriangle(c.tetrahedron, c.face, change);
      });
  }

private:
  static constexpr std::size_t TetrahedraPerRange = 16384;
  static constexpr std::size_t CandidatesPerRange = 256;

  /** Calls collect(tetrahedron, list) for all, side by side, and returns what the lists have, sorted. */
  template <typename TCollect>
  std::vector<Candidate>
  Collect(const TCollect & collect) const
  {
    auto all = ParallelCollect<Candidate>(
      m_State.complex.Size(), TetrahedraPerRange, [&](std::size_t t, std::vector<Candidate> & list) {
        if (m_State.complex.IsAlive(Id(t)))
        {
          collect(Id(t), list);
        }
      });
    std::sort(all.begin(), all.end());
    return all;
  }

  /** For each candidate that is still wanted when its turn comes: tries `changeSide`, or else makes the change that
   * find(candidate, finder, change) finds. Returns the number of changes. */
  template <typename TIsWanted, typename TChangeSide, typename TFind>
  std::size_t
  ChangeAll(const std::vector<Candidate> & candidates,
            const TIsWanted &              isWanted,
            const TChangeSide &            changeSide,
            const TFind &                  find)
  {
    std::vector<ComplexChange> changes(candidates.size());
    std::vector<char>          isFound(candidates.size(), 0);
    ParallelFor(candidates.size(), CandidatesPerRange, [&](std::size_t begin, std::size_t end) {
      Finder finder(m_State);
      for (std::size_t n = begin; n < end; ++n)
      {
        isFound[n] = find(candidates[n], finder, changes[n]);
      }
    });
    std::size_t count = 0;
    for (std::size_t n = 0; n < candidates.size(); ++n)
    {
      const Candidate & candidate = candidates[n];
      // its place may have been taken by another one since
      if (!m_State.complex.IsAlive(candidate.tetrahedron) || !isWanted(candidate))
      {
        continue;
      }
      if (changeSide(candidate))
      {
        ++count;
        continue;
      }
      const bool hasChanged =
        isFound[n] ? !changes[n].IsUpToDate(m_State.complex) : this->IsTouched(candidate.tetrahedron);
      if (hasChanged ? find(candidate, m_Finder, changes[n]) : bool(isFound[n]))
      {
        m_State.Make(changes[n]);
        ++count;
      }
    }
    return count;
  }

  /** Whether there has been a change at a tetrahedron, or beyond one of its faces. */
  bool
  IsTouched(Id t) const
  {
    const auto & corners = m_State.complex.Corners(t);
    return std::count_if(corners.begin(), corners.end(), [&](PointId p) { return m_State.complex.IsTouched(p); }) >= 3;
  }

  OptimizerState & m_State;
  Finder           m_Finder;
  SideChanger      m_SideChanger;
};
} // namespace

std::size_t
ImproveTetrahedra(OptimizerState & state, double quality, double poorQuality)
{
  return ConnectivityImprover(state).ImproveTetrahedra(quality, poorQuality);
}

std::size_t
ImproveTriangles(OptimizerState & state, double radiusRatio)
{
  return ConnectivityImprover(state).ImproveTriangles(radiusRatio);
}
} // namespace mmm
