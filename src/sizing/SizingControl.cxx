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
#include "sizing/SizingControl.h"

#include "base/Parallel.h"
#include "sizing/SizingParameters.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mmm
{
namespace
{
constexpr std::size_t Grain = 4096;

/** The node nearest to a point of the image box. */
std::size_t
NearestNode(const Grid & grid, const Vector & x)
{
  Index node;
  for (int a = 0; a < 3; ++a)
  {
    node[a] = int(std::lround(x[a] / grid.spacing[a]));
  }
  return grid.Offset(grid.Clamp(node));
}
} // namespace

bool
IsInMaterials(const std::vector<std::uint8_t> & region, const IndicatorSet & indicators, int exterior)
{
  for (std::size_t n = 0; n < region.size(); ++n)
  {
    if (region[n] && int(indicators.MaterialAtNode(n)) != exterior)
    {
      return true;
    }
  }
  return false;
}

SizeRules::Bounds
SizeRules::Bounds::Under(const SizeRule & rule, double limit) const
{
  const bool   hasMinimum = !std::isnan(rule.minimumSize);
  const bool   hasMaximum = !std::isnan(rule.maximumSize);
  const double lower = hasMinimum ? rule.minimumSize : (hasMaximum ? std::min(minimum, rule.maximumSize) : minimum);
  const double upper = hasMaximum ? rule.maximumSize : std::max(maximum, lower);
  return { std::min(lower, limit), std::min(upper, limit) };
}

SizeRules::SizeRules(const IndicatorSet &     indicators,
                     const SizingParameters & parameters,
                     const SizingControl &    control)
  : m_Indicators(indicators)
  , m_Control(control)
  , m_Rules(control.materials)
{
  m_Rules.resize(indicators.GetNumberOfMaterials());
  const Bounds general =
    Bounds{ parameters.minimumSize, parameters.maximumSize }.Under(SizeRule(), parameters.sizeLimit);
  for (const SizeRule & rule : m_Rules)
  {
    const Bounds bounds = general.Under(rule, parameters.sizeLimit);
    const Bounds inRegion = bounds.Under(control.regionRule, parameters.sizeLimit);
    m_Bounds[0].push_back(bounds);
    m_Bounds[1].push_back(inRegion);
    m_HasLocalLimits = m_HasLocalLimits || bounds.maximum != general.maximum || inRegion.maximum != general.maximum;
  }
}

double
SizeRules::In(Material material, bool inRegion, double size) const
{
  const Bounds & bounds = m_Bounds[inRegion][material];
  return std::min(std::max(size * m_Rules[material].factor, bounds.minimum), bounds.maximum);
}

float
SizeRules::AtInterface(const InterfaceSample & sample, double size) const
{
  const std::size_t node = NearestNode(m_Indicators.GetGrid(), sample.position);
  if (m_Control.imageReplaces && m_Control.image[node] < SizingControl::NoLimit)
  {
    return std::numeric_limits<float>::infinity();
  }
  const bool inRegion = this->IsInRegion(node);
  if (m_Indicators.IsPlane(sample.second))
  {
    return float(this->In(sample.first, inRegion, size));
  }
  const bool firstRules = m_Rules[sample.first].IsGiven();
  const bool secondRules = m_Rules[sample.second].IsGiven();
  if (firstRules != secondRules)
  {
    return float(this->In(firstRules ? sample.first : sample.second, inRegion, size));
  }
  return float(std::min(this->In(sample.first, inRegion, size), this->In(sample.second, inRegion, size)));
}

float
SizeRules::LimitAt(std::size_t node) const
{
  return float(m_Bounds[this->IsInRegion(node)][m_Indicators.MaterialAtNode(node)].maximum);
}

void
SizeRules::CompleteSources(std::vector<Source> & sources) const
{
  const auto isInfinite = [](const Source & source) { return std::isinf(source.value); };
  sources.erase(std::remove_if(sources.begin(), sources.end(), isInfinite), sources.end());

  if (!m_HasLocalLimits)
  {
    return;
  }
  // a limit spreads from the rim of where it holds
  const Grid & grid = m_Indicators.GetGrid();
  for (std::size_t n = 0; n < grid.NumberOfNodes(); ++n)
  {
    const float limit = this->LimitAt(n);
    const Index at = grid.IndexAt(n);
    bool        isRim = false;
    for (int step = 0; step < 6 && !isRim; ++step)
    {
      Index neighbor = at;
      neighbor[step / 2] += step % 2 ? 1 : -1;
      isRim = grid.Contains(neighbor) && this->LimitAt(grid.Offset(neighbor)) > limit;
    }
    if (isRim)
    {
      sources.push_back({ grid.Position(at).cast<float>(), limit });
    }
  }
}

std::vector<float>
SizeRules::NodeSizes() const
{
  std::vector<float> sizes = m_Control.image;
  ParallelFor(sizes.size(), Grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      if (!(sizes[n] < SizingControl::NoLimit))
      {
        sizes[n] = std::numeric_limits<float>::infinity();
      }
      else if (m_Control.imageReplaces)
      {
        sizes[n] = float(this->In(m_Indicators.MaterialAtNode(n), this->IsInRegion(n), sizes[n]));
      }
    }
  });
  return sizes;
}

void
SizeRules::LimitSizes(std::vector<float> & sizes) const
{
  ParallelFor(sizes.size(), Grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      sizes[n] = std::min(sizes[n], this->LimitAt(n));
    }
  });
}
} // namespace mmm
