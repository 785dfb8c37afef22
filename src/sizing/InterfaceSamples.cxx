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
#include "sizing/InterfaceSamples.h"

#include "base/ParallelCollect.h"

namespace mmm
{
namespace
{
/** Where f_first - f_second vanishes between two neighbouring nodes, as a fraction of the way. */
double
CrossingFraction(const IndicatorSet & indicators, Material first, Material second, const Index & a, const Index & b)
{
  const double atA = indicators.ValueAtNode(first, a) - indicators.ValueAtNode(second, a);
  const double atB = indicators.ValueAtNode(first, b) - indicators.ValueAtNode(second, b);
  return atA > 0.0 && atB < 0.0 ? atA / (atA - atB) : 0.5;
}

void
CollectPlane(const IndicatorSet & indicators, int exterior, int k, std::vector<InterfaceSample> & samples)
{
  const Grid & grid = indicators.GetGrid();
  for (int j = 0; j < grid.size[1]; ++j)
  {
    for (int i = 0; i < grid.size[0]; ++i)
    {
      const Index    at{ { i, j, k } };
      const Material own = indicators.MaterialAtNode(grid.Offset(at));
      const Vector   x = grid.Position(at);
      for (int a = 0; a < 3; ++a)
      {
        Index after = at;
        ++after[a];
        if (after[a] < grid.size[a])
        {
          const Material other = indicators.MaterialAtNode(grid.Offset(after));
          if (other != own)
          {
            const Vector y = grid.Position(after);
            const double t = CrossingFraction(indicators, own, other, at, after);
            const Vector crossing = x + t * (y - x);
            const Vector toHigher = indicators.Normal(Cell{ own, other }, crossing);
            samples.push_back({ crossing, own, other, own < other ? toHigher : Vector(-toHigher) });
          }
        }
        for (int side = 0; side < 2; ++side)
        {
          if (int(own) != exterior && at[a] == (side ? grid.size[a] - 1 : 0))
          {
            const double sign = side ? 1.0 : -1.0;
            samples.push_back({ x + sign * 0.5 * grid.spacing[a] * Vector::Unit(a),
                                own,
                                indicators.Planes().At(2 * a + side),
                                sign * Vector::Unit(a) });
          }
        }
      }
    }
  }
}
} // namespace

std::vector<InterfaceSample>
CollectInterfaceSamples(const IndicatorSet & indicators, int exterior)
{
  return ParallelCollect<InterfaceSample>(
    indicators.GetGrid().size[2], 1, [&](std::size_t k, std::vector<InterfaceSample> & samples) {
      CollectPlane(indicators, exterior, int(k), samples);
    });
}
} // namespace mmm
