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
#include "itk/IndicatorLayers.h"

#include "indicators/IndicatorSet.h"

#include <algorithm>
#include <set>

namespace mmm
{
namespace
{
constexpr auto Band = static_cast<float>(IndicatorBandWidth);
/** By how much a layer leads per distance. Signed distances lead by twice of it; a layer that leaves some labels as
 * they are leads by less, as the kink of its lead at its rim is one of their interface, which interpolation rounds; and
 * one that is within such a layer by less again. */
constexpr float WholeSlope = 2.0f;
constexpr float PartSlope = 1.0f;
constexpr float WithinSlope = 0.3f;
/** What is left of the differences below a layer's surface, and the depth below it from which on they are whole: these,
 * too, have kinks, where interfaces end at the surface. */
constexpr float Softness = 0.3f;
constexpr float SoftDepth = 3.0f;

/** From Softness above the surface to 1 below it. */
float
SoftnessAt(float distance)
{
  const float t = std::min(std::max((-distance - 1.0f) / (SoftDepth - 1.0f), 0.0f), 1.0f);
  return Softness + (1.0f - Softness) * t * t * (3.0f - 2.0f * t);
}

bool
Meet(const IndexBox & first, const IndexBox & second)
{
  for (int a = 0; a < 3; ++a)
  {
    if (first.lower[a] > second.upper[a] || second.lower[a] > first.upper[a])
    {
      return false;
    }
  }
  return true;
}

template <typename TCondition>
std::vector<LabelIndicator *>
FindAt(const IndexBox & box, std::vector<LabelIndicator> & indicators, const TCondition & isWanted)
{
  std::vector<LabelIndicator *> found;
  for (LabelIndicator & indicator : indicators)
  {
    if (isWanted(indicator.label) && !IsEmpty(indicator.box) && Meet(indicator.box, box))
    {
      found.push_back(&indicator);
    }
  }
  return found;
}

void
PutOnTop(const IndicatorLayer & layer, float slope, std::vector<LabelIndicator> & indicators)
{
  LabelIndicator & own = *std::find_if(indicators.begin(), indicators.end(), [&](const LabelIndicator & indicator) {
    return indicator.label == layer.label;
  });
  const auto       below = FindAt(layer.box, indicators, [&](int label) { return layer.Hides(label); });
  const bool       isWhole = layer.replaced.empty();
  auto             distance = layer.distances.begin();
  layer.box.Visit([&](const Index & at) {
    const float lead = slope * *distance;
    const float softness = isWhole ? SoftnessAt(*distance) : 1.0f;
    ++distance;
    float largest = -Band;
    for (LabelIndicator * const indicator : below)
    {
      largest = indicator->box.Contains(at) ? std::max(largest, indicator->At(at)) : largest;
    }
    for (LabelIndicator * const indicator : below)
    {
      if (indicator->box.Contains(at))
      {
        float & value = indicator->At(at);
        value = largest - softness * (largest - value) - std::max(lead, 0.0f);
      }
    }
    float & value = own.At(at);
    value = std::max(value, largest + std::min(lead, 0.0f));
  });
}

/** Makes the two largest indicators opposite. */
void
Balance(const IndexBox & box, const Grid & grid, std::vector<bool> & isDone, std::vector<LabelIndicator> & indicators)
{
  const auto there = FindAt(box, indicators, [](int) { return true; });
  box.Visit([&](const Index & at) {
    const auto n = grid.Offset(at);
    if (isDone[n])
    {
      return;
    }
    isDone[n] = true;
    float first = -Band;
    float second = -Band;
    for (LabelIndicator * const indicator : there)
    {
      if (indicator->box.Contains(at))
      {
        const float value = indicator->At(at);
        second = std::max(second, std::min(first, value));
        first = std::max(first, value);
      }
    }
    for (LabelIndicator * const indicator : there)
    {
      if (indicator->box.Contains(at))
      {
        float & value = indicator->At(at);
        value = std::min(std::max(value - 0.5f * (first + second), -Band), Band);
      }
    }
  });
}
} // namespace

bool
IndicatorLayer::Hides(int other) const
{
  return replaced.empty() || std::find(replaced.begin(), replaced.end(), other) != replaced.end();
}

bool
IsEmpty(const IndexBox & box)
{
  return box.lower[0] > box.upper[0] || box.lower[1] > box.upper[1] || box.lower[2] > box.upper[2];
}

IndexBox
Union(const IndexBox & first, const IndexBox & second)
{
  if (IsEmpty(first) || IsEmpty(second))
  {
    return IsEmpty(first) ? second : first;
  }
  IndexBox box;
  for (int a = 0; a < 3; ++a)
  {
    box.lower[a] = std::min(first.lower[a], second.lower[a]);
    box.upper[a] = std::max(first.upper[a], second.upper[a]);
  }
  return box;
}

void
PutOnTop(const Grid & grid, const std::vector<IndicatorLayer> & layers, std::vector<LabelIndicator> & indicators)
{
  std::set<int> earlier;
  for (const IndicatorLayer & layer : layers)
  {
    const auto & replaced = layer.replaced;
    const bool   isWithin =
      std::all_of(replaced.begin(), replaced.end(), [&](int label) { return earlier.count(label) != 0; });
    PutOnTop(layer, replaced.empty() ? WholeSlope : isWithin ? WithinSlope : PartSlope, indicators);
    earlier.insert(layer.label);
  }
  std::vector<bool> isDone(grid.NumberOfNodes());
  for (const IndicatorLayer & layer : layers)
  {
    Balance(layer.box, grid, isDone, indicators);
  }
}
} // namespace mmm
