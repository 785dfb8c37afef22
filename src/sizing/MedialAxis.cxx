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
#include "sizing/MedialAxis.h"

#include "base/IndexBox.h"
#include "base/ParallelCollect.h"
#include "base/Shortened.h"
#include "sizing/SizingParameters.h"
#include "sizing/SourcePropagation.h"
#include "sizing/ThinLayers.h"

#include <algorithm>

namespace mmm
{
namespace
{
using Parameters = MedialAxisParameters;

/** The nodes that a node's feet are compared with. */
struct NeighbourStep
{
  int    offset[3];
  double largestCosine;
};
constexpr double        Beside = Parameters::LargestCosine;
constexpr double        Across = Parameters::LargestDiagonalCosine;
constexpr NeighbourStep NeighbourSteps[] = { { { 1, 0, 0 }, Beside },  { { 0, 1, 0 }, Beside },
                                             { { 0, 0, 1 }, Beside },  { { 1, 1, 1 }, Across },
                                             { { 1, 1, -1 }, Across }, { { 1, -1, 1 }, Across },
                                             { { 1, -1, -1 }, Across } };

/** The foot of x on the plane that touches the interface at a sample, which is known to be near. */
Vector
RefineFoot(const InterfaceSample & sample, const Vector & x)
{
  const Vector away = x - sample.position;
  const Vector along = away - away.dot(sample.normal) * sample.normal;
  return sample.position + Shortened(along, Parameters::LongestRefinement);
}

/** The point between x and y that is as far from p as from q. */
Vector
EquidistantPoint(const Vector & x, const Vector & y, const Vector & p, const Vector & q)
{
  const Vector apart = q - p;
  const double slope = (y - x).dot(apart);
  const double fraction = slope > 0.0 ? (0.5 * (p + q) - x).dot(apart) / slope : 0.5;
  return x + std::min(std::max(fraction, 0.0), 1.0) * (y - x);
}

/** The centre of the ball that touches the interfaces at p and q, by the normals there, near a guess. */
Vector
BallCentre(const Vector & guess, const Vector & p, const Vector & normalAtP, const Vector & q, const Vector & normalAtQ)
{
  // a ball through both that touches the plane of normal n at one of them has the radius |q - p|^2 / 2 n (q - p)
  const Vector apart = q - p;
  const double slopeP = normalAtP.dot(apart);
  const double slopeQ = normalAtQ.dot(apart);
  const double square = apart.squaredNorm();
  if (std::min(slopeP * slopeP, slopeQ * slopeQ) <
      Parameters::LeastNormalCosine * Parameters::LeastNormalCosine * square)
  {
    return guess;
  }
  const Vector centre = 0.5 * (p + q) + 0.25 * square * (normalAtP / slopeP - normalAtQ / slopeQ);
  return guess + Shortened(centre - guess, Parameters::LongestCorrection);
}

/** Finds nodes whose feet lie apart from those of their neighbours and are seen under a wide angle. */
class FootComparison
{
public:
  FootComparison(const IndicatorSet &                 indicators,
                 const JunctionTable &                junctions,
                 const std::vector<InterfaceSample> & samples,
                 const PropagatedField &              feet)
    : m_Indicators(indicators)
    , m_Junctions(junctions)
    , m_Samples(samples)
    , m_Feet(feet)
  {}

  std::vector<Vector>
  AxisPoints() const
  {
    const Grid & grid = m_Indicators.GetGrid();
    return ParallelCollect<Vector>(grid.size[2], 1, [&](std::size_t k, std::vector<Vector> & axis) {
      IndexBox{ { { 0, 0, int(k) } }, { { grid.size[0] - 1, grid.size[1] - 1, int(k) } } }.Visit(
        [&](const Index & at) { this->AddAxisPoints(at, axis); });
    });
  }

private:
  bool
  IsDeep(std::size_t node) const
  {
    return m_Feet.values[node] >= Parameters::LeastDepth && m_Feet.sources[node] != PropagatedField::NoSource;
  }

  void
  AddAxisPoints(const Index & at, std::vector<Vector> & axis) const
  {
    const Grid &      grid = m_Indicators.GetGrid();
    const std::size_t n = grid.Offset(at);
    if (!this->IsDeep(n))
    {
      return;
    }
    const Material          own = m_Indicators.MaterialAtNode(n);
    const Vector            x = grid.Position(at);
    const InterfaceSample & p = m_Samples[m_Feet.sources[n]];
    for (const auto & step : NeighbourSteps)
    {
      const Index after{ { at[0] + step.offset[0], at[1] + step.offset[1], at[2] + step.offset[2] } };
      if (!grid.Contains(after))
      {
        continue;
      }
      const std::size_t m = grid.Offset(after);
      if (m_Feet.sources[m] == m_Feet.sources[n] || !this->IsDeep(m) || m_Indicators.MaterialAtNode(m) != own)
      {
        continue;
      }
      const Vector            y = grid.Position(after);
      const InterfaceSample & q = m_Samples[m_Feet.sources[m]];
      const Vector            atP = RefineFoot(p, x);
      const Vector            atQ = RefineFoot(q, y);
      const Vector            toP = atP - x;
      const Vector            toQ = atQ - y;
      if ((atP - atQ).squaredNorm() < Parameters::LeastSeparation * Parameters::LeastSeparation ||
          toP.dot(toQ) > step.largestCosine * toP.norm() * toQ.norm())
      {
        continue;
      }
      if (!m_Junctions.IsWedge(own, p.Opposite(own), q.Opposite(own), atP, atQ))
      {
        axis.push_back(BallCentre(EquidistantPoint(x, y, atP, atQ), atP, p.normal, atQ, q.normal));
      }
    }
  }

  const IndicatorSet &                 m_Indicators;
  const JunctionTable &                m_Junctions;
  const std::vector<InterfaceSample> & m_Samples;
  const PropagatedField &              m_Feet;
};
} // namespace

std::vector<Vector>
ComputeMedialAxis(const IndicatorSet & indicators, const std::vector<InterfaceSample> & samples)
{
  std::vector<Source> sources;
  sources.reserve(samples.size());
  for (const auto & sample : samples)
  {
    sources.push_back({ sample.position.cast<float>(), 0.0f });
  }
  const JunctionTable   junctions(indicators);
  const PropagatedField feet = PropagateSources(indicators.GetGrid(), sources, 1.0);
  std::vector<Vector>   axis = FootComparison(indicators, junctions, samples, feet).AxisPoints();
  const auto            thin = ProbeThinLayers(indicators, junctions, samples);
  axis.insert(axis.end(), thin.begin(), thin.end());
  return axis;
}
} // namespace mmm
