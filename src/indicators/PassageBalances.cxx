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
#include "indicators/PassageBalances.h"

#include "base/ParallelCollect.h"
#include "indicators/CriticalPoint.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace mmm
{
namespace
{
constexpr std::size_t PlacesPerRange = 256;

/** A critical point of the difference of two materials, by the nodes around it. */
struct Balance
{
  IndexBox nodes;
  Material leader;
  Material other;
  float    lead;
};

IndexBox
NodesAround(const Grid & grid, const Vector & x)
{
  Index lower;
  Index upper;
  for (int a = 0; a < 3; ++a)
  {
    const double at = x[a] / grid.spacing[a];
    lower[a] = int(std::floor(at + PassageParameters::NearNode));
    upper[a] = int(std::ceil(at - PassageParameters::NearNode));
  }
  return { grid.Clamp(lower), grid.Clamp(upper) };
}

bool
FindBalance(const IndicatorSet & indicators, const WeakPlace & place, Balance & balance)
{
  const Material own = place.own;
  Vector         x = place.position;
  if (!FindCriticalPoint(indicators, own, place.second, PassageParameters::CriticalPointReach, x))
  {
    return false;
  }
  const double lead = indicators.Difference(own, place.second, x);
  balance = { NodesAround(indicators.GetGrid(), x),
              lead > 0.0 ? own : place.second,
              lead > 0.0 ? place.second : own,
              float(std::abs(lead)) };
  return balance.lead < PassageParameters::Lead && indicators.MaterialAt(x) == balance.leader;
}
} // namespace

void
TipBalances(const IndicatorSet & indicators, const std::vector<WeakPlace> & places, std::vector<Raise> & raises)
{
  auto balances =
    ParallelCollect<Balance>(places.size(), PlacesPerRange, [&](std::size_t n, std::vector<Balance> & found) {
      Balance balance;
      if (FindBalance(indicators, places[n], balance))
      {
        found.push_back(balance);
      }
    });
  std::stable_sort(
    balances.begin(), balances.end(), [](const Balance & a, const Balance & b) { return a.lead > b.lead; });

  // the leaders at nodes, by the node and the two materials
  std::map<std::tuple<std::size_t, Material, Material>, Material> leaders;
  for (const Balance & balance : balances)
  {
    const auto pair = std::minmax(balance.leader, balance.other);
    bool       isLost = false;
    balance.nodes.Visit([&](const Index & node) {
      const auto at = leaders.find({ indicators.GetGrid().Offset(node), pair.first, pair.second });
      isLost = isLost || (at != leaders.end() && at->second == balance.other);
    });
    const Material leader = isLost ? balance.other : balance.leader;
    const Material other = isLost ? balance.leader : balance.other;
    const float    wanted = PassageParameters::Lead;
    const float    amount = 0.5f * (isLost ? wanted + balance.lead : wanted - balance.lead);
    balance.nodes.Visit([&](const Index & node) {
      const auto n = indicators.GetGrid().Offset(node);
      leaders.insert({ { n, pair.first, pair.second }, leader });
      raises.push_back({ n, leader, amount });
      raises.push_back({ n, other, -amount });
    });
  }
}
} // namespace mmm
