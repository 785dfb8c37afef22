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
#include "indicators/IndicatorSet.h"

#include <utility>

namespace mmm
{
namespace
{
bool
IsBeyondBox(const Grid & grid, const Vector & x)
{
  bool isBeyond = false;
  for (int a = 0; a < 3; ++a)
  {
    isBeyond |= x[a] < grid.LowerFace(a) || x[a] > grid.UpperFace(a);
  }
  return isBeyond;
}
} // namespace

IndicatorSet::IndicatorSet(const Grid & grid, std::vector<IndicatorBricks> indicators, double outside)
  : m_Grid(grid)
  , m_Indicators(std::move(indicators))
  , m_Outside(outside)
  , m_Planes(grid, m_Indicators.size())
  , m_Candidates(grid, m_Indicators, outside)
{}

double
IndicatorSet::Value(Material m, const Vector & x) const
{
  return this->IsPlane(m) ? m_Planes.Value(m, x) : this->Evaluate(m, TricubicStencil(m_Grid, x));
}

double
IndicatorSet::ValueAndGradient(Material m, const Vector & x, Vector & gradient) const
{
  if (this->IsPlane(m))
  {
    gradient = m_Planes.Gradient(m);
    return m_Planes.Value(m, x);
  }
  return TricubicGradientStencil(m_Grid, x).Value(m_Indicators[m], m_Outside, gradient);
}

double
IndicatorSet::Difference(Material first, Material last, const Vector & x) const
{
  if (this->IsPlane(first) || this->IsPlane(last))
  {
    return this->Value(first, x) - this->Value(last, x);
  }
  const TricubicStencil stencil(m_Grid, x);
  return this->Evaluate(first, stencil) - this->Evaluate(last, stencil);
}

Material
IndicatorSet::MaterialAt(const Vector & x) const
{
  if (IsBeyondBox(m_Grid, x))
  {
    Material outermost = 0;
    double   furthest = 0.0;
    for (int p = 0; p < BoxPlanes::Count; ++p)
    {
      const Material plane = m_Planes.At(p);
      const double   value = m_Planes.Value(plane, x);
      if (value > furthest)
      {
        furthest = value;
        outermost = plane;
      }
    }
    return outermost;
  }
  const auto range = this->Candidates(x);
  if (range.second - range.first == 1)
  {
    return *range.first;
  }
  const TricubicStencil stencil(m_Grid, x);
  Material              best = 0;
  double                largest = -1e300;
  for (auto m = range.first; m != range.second; ++m)
  {
    const double value = this->Evaluate(*m, stencil);
    if (value > largest)
    {
      largest = value;
      best = *m;
    }
  }
  return best;
}

double
IndicatorSet::InsideOutside(Material m, const Vector & x) const
{
  const TricubicStencil stencil(m_Grid, x);
  double                others = m_Outside;
  const auto            range = this->Candidates(x);
  for (auto j = range.first; j != range.second; ++j)
  {
    if (*j != m)
    {
      others = std::max(others, this->Evaluate(*j, stencil));
    }
  }
  return this->Evaluate(m, stencil) - others;
}

double
IndicatorSet::CellIndicator(const Cell & cell, const Vector & x) const
{
  double sum = 0.0;
  for (const Material m : cell)
  {
    const double g = this->IsPlane(m) ? m_Planes.Value(m, x) : this->InsideOutside(m, x);
    sum += g * g;
  }
  return sum;
}
} // namespace mmm
