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
#include "indicators/IndicatorRaises.h"

#include "indicators/BlockValue.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
/** Keeps the largest gain and the largest loss of each material at a node. */
void
KeepLargest(std::vector<Raise> & raises)
{
  std::sort(raises.begin(), raises.end(), [](const Raise & a, const Raise & b) {
    return a.node != b.node           ? a.node < b.node
           : a.material != b.material ? a.material < b.material
           : a.IsLoss() != b.IsLoss() ? b.IsLoss()
                                      : std::abs(a.amount) > std::abs(b.amount);
  });
  const auto isSame = [](const Raise & a, const Raise & b) {
    return a.node == b.node && a.material == b.material && a.IsLoss() == b.IsLoss();
  };
  raises.erase(std::unique(raises.begin(), raises.end(), isSame), raises.end());
}

/** By how much a node's material leads another one or, if that is the same, everybody. */
float
LeadAtNode(const IndicatorSet &        indicators,
           std::vector<Block<float>> & blocks,
           Material                    own,
           Material                    other,
           const Index &               node)
{
  const auto range = indicators.Candidates(indicators.GetGrid().Position(node));
  float      largest = -1e30f;
  for (auto m = range.first; m != range.second; ++m)
  {
    const float * value = *m != own && (*m == other || other == own) ? FindValue(blocks[*m], node) : nullptr;
    largest = value ? std::max(largest, *value) : largest;
  }
  return *FindValue(blocks[own], node) - largest;
}

/** Whether a node or one of its 26 neighbours is of a material. */
bool
IsNear(const IndicatorSet & indicators, Material material, const Index & node)
{
  const Grid & grid = indicators.GetGrid();
  bool         found = false;
  IndexBox{ grid.Clamp({ { node[0] - 1, node[1] - 1, node[2] - 1 } }),
            grid.Clamp({ { node[0] + 1, node[1] + 1, node[2] + 1 } }) }
    .Visit([&](const Index & other) { found = found || indicators.MaterialAtNode(grid.Offset(other)) == material; });
  return found;
}
} // namespace

void
ApplyRaises(const IndicatorSet & indicators, std::vector<Raise> & raises, std::vector<Block<float>> & blocks)
{
  KeepLargest(raises);
  for (const Raise & raise : raises)
  {
    const Index    node = indicators.GetGrid().IndexAt(raise.node);
    const Material own = indicators.MaterialAtNode(raise.node);
    float * const  value = FindValue(blocks[raise.material], node);
    // further away, a material could get to others that none of its voxels touches
    if (value == nullptr || (!raise.IsLoss() && !IsNear(indicators, raise.material, node)))
    {
      continue;
    }
    float amount = raise.amount;
    if ((own == raise.material) == raise.IsLoss())
    {
      const float spare =
        std::max(0.0f, LeadAtNode(indicators, blocks, own, raise.material, node) - PassageParameters::NodeLead);
      amount = std::min(std::max(amount, -spare), spare);
    }
    *value += amount;
  }
}
} // namespace mmm
