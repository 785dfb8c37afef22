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
#include "sizing/ThinLayers.h"

#include "base/ParallelCollect.h"
#include "sizing/SizingParameters.h"

#include <cmath>

namespace mmm
{
namespace
{
using Parameters = MedialAxisParameters;

constexpr std::size_t SamplesPerRange = 4096;

/** Whether the nodes along a line into a material are all its own, as far as a thin layer may reach. */
bool
IsThick(const IndicatorSet & indicators, const Vector & from, const Vector & inwards, Material own)
{
  const Grid & grid = indicators.GetGrid();
  for (double t = 3.0 * Parameters::ProbeStep; t <= Parameters::ThinLayer + 3.0 * Parameters::ProbeStep;
       t += 3.0 * Parameters::ProbeStep)
  {
    Index node;
    for (int a = 0; a < 3; ++a)
    {
      node[a] = int(std::floor((from[a] + t * inwards[a]) / grid.spacing[a] + 0.5));
    }
    if (!grid.Contains(node) || indicators.MaterialAtNode(grid.Offset(node)) != own)
    {
      return false;
    }
  }
  return true;
}

/** The axis point across a thin layer, from `sample` into the material `own`. Returns false where there is none. */
bool
ProbeThinLayer(const IndicatorSet &    indicators,
               const JunctionTable &   junctions,
               const InterfaceSample & sample,
               Material                own,
               Vector &                axisPoint)
{
  const Vector inwards = sample.first == own ? Vector(-sample.normal) : sample.normal;
  if (IsThick(indicators, sample.position, inwards, own))
  {
    return false;
  }
  double inside = 0.0;
  double outside = 0.0;
  for (double t = Parameters::ProbeStep; t <= Parameters::ThinLayer + Parameters::ProbeStep; t += Parameters::ProbeStep)
  {
    if (indicators.MaterialAt(sample.position + t * inwards) != own)
    {
      outside = t;
      break;
    }
    inside = t;
  }
  if (outside == 0.0 || inside == 0.0)
  {
    return false;
  }
  const Material other = indicators.MaterialAt(sample.position + outside * inwards);
  for (int halving = 0; halving < Parameters::Halvings; ++halving)
  {
    const double t = 0.5 * (inside + outside);
    (indicators.MaterialAt(sample.position + t * inwards) == own ? inside : outside) = t;
  }
  const double thickness = 0.5 * (inside + outside);
  const Vector end = sample.position + thickness * inwards;
  const Vector across = indicators.Normal(Cell{ own, other }, end) * (own < other ? 1.0 : -1.0);
  if (across.dot(inwards) < 0.0 || junctions.IsWedge(own, sample.Opposite(own), other, sample.position, end))
  {
    return false;
  }
  axisPoint = sample.position + 0.5 * thickness * inwards;
  return true;
}
} // namespace

std::vector<Vector>
ProbeThinLayers(const IndicatorSet &                 indicators,
                const JunctionTable &                junctions,
                const std::vector<InterfaceSample> & samples)
{
  return ParallelCollect<Vector>(samples.size(), SamplesPerRange, [&](std::size_t s, std::vector<Vector> & found) {
    for (const Material own : { samples[s].first, samples[s].second })
    {
      Vector axisPoint;
      if (!indicators.IsPlane(own) && ProbeThinLayer(indicators, junctions, samples[s], own, axisPoint))
      {
        found.push_back(axisPoint);
      }
    }
  });
}
} // namespace mmm
