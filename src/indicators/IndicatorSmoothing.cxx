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
#include "indicators/IndicatorSmoothing.h"

#include "indicators/BoxDistance.h"
#include "indicators/LevelSet.h"
#include "base/IndexBox.h"
#include "base/Parallel.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mmm
{
namespace
{
using Parameters = SmoothingParameters;

/** How many nodes the band reaches beyond a material's box along an axis. */
int
BandNodes(const Grid & grid, int axis)
{
  return 1 + int(std::ceil(IndicatorBandWidth / grid.spacing[axis]));
}

std::vector<float>
BandValues(const LevelSet & levelSet)
{
  std::vector<float> values;
  values.reserve(levelSet.Band().size());
  for (const auto n : levelSet.Band())
  {
    values.push_back(levelSet.Values()[n]);
  }
  return values;
}

/** How far the interface has to stay from the centre of each of the band's voxels. */
std::vector<float>
CentreMargins(const MaterialImage & image, const LevelSet & levelSet)
{
  std::vector<float> margins(levelSet.Band().size(), Parameters::CentreMargin);
  ParallelFor(margins.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b)
    {
      const auto n = levelSet.Band()[b];
      // only the voxels beside the interface matter
      if (std::abs(levelSet.Values()[n]) < 1.0f)
      {
        margins[b] = CentreMarginOf(image, levelSet.IndexAt(n));
      }
    }
  });
  return margins;
}

void
AntiAlias(LevelSet & levelSet, const std::vector<float> & margins)
{
  const float        width = float(levelSet.GetWidth());
  std::vector<float> lower = BandValues(levelSet);
  std::vector<float> upper(lower.size());
  for (std::size_t b = 0; b < lower.size(); ++b)
  {
    const bool inside = lower[b] > 0.0f;
    lower[b] = inside ? margins[b] : -width;
    upper[b] = inside ? width : -margins[b];
  }
  levelSet.FlowByMeanCurvature(lower, upper, Parameters::AntiAliasTolerance, Parameters::AntiAliasSteps);
}

/** The set moved outwards by `offset` (inwards where negative) and back: closing, or opening, per node of the band. */
std::vector<float>
OffsetAndBack(LevelSet levelSet, double offset)
{
  for (float & value : levelSet.Values())
  {
    value += float(offset);
  }
  levelSet.Redistance(LevelSet::Before::NearDistances);
  std::vector<float> values = BandValues(levelSet);
  for (float & value : values)
  {
    value -= float(offset);
  }
  return values;
}

void
Tighten(LevelSet & levelSet, const std::vector<float> & margins, double radius)
{
  std::vector<float>       opening = OffsetAndBack(levelSet, -radius);
  std::vector<float>       closing = OffsetAndBack(levelSet, radius);
  const std::vector<float> start = BandValues(levelSet);
  const float              yield = float(std::max(0.0, radius - 0.5));
  for (std::size_t b = 0; b < opening.size(); ++b)
  {
    opening[b] = std::min(opening[b] - Parameters::MortarSlack, start[b]);
    closing[b] = std::max(closing[b] + Parameters::MortarSlack, start[b]);
    if (start[b] > 0.0f)
    {
      opening[b] = std::max(opening[b], std::min(start[b], margins[b] - yield));
    }
    else
    {
      closing[b] = std::min(closing[b], std::max(start[b], yield - margins[b]));
    }
  }
  levelSet.FlowByMeanCurvature(opening, closing, Parameters::TighteningTolerance, Parameters::TighteningSteps);
}
} // namespace

bool
IsThin(const MaterialImage & image, const Index & at)
{
  const Material own = image.AtNearest(at);
  for (int block = 0; block < 8; ++block)
  {
    bool isWhole = true;
    for (int corner = 0; corner < 8 && isWhole; ++corner)
    {
      const auto along = [&](int a) { return at[a] - ((block >> a) & 1) + ((corner >> a) & 1); };
      isWhole = image.AtNearest(Index{ { along(0), along(1), along(2) } }) == own;
    }
    if (isWhole)
    {
      return false;
    }
  }
  return true;
}

float
CentreMarginOf(const MaterialImage & image, const Index & at)
{
  if (!IsThin(image, at))
  {
    return Parameters::CentreMargin;
  }
  int likewise = 0;
  for (int a = 0; a < 3; ++a)
  {
    for (const int step : { -1, 1 })
    {
      Index beside = at;
      beside[a] += step;
      likewise += image.AtNearest(beside) == image.AtNearest(at);
    }
  }
  return likewise > 1 ? Parameters::ThinCentreMargin : Parameters::TipCentreMargin;
}

std::vector<MaterialBox>
ComputeMaterialBoxes(const MaterialImage & image)
{
  std::vector<Index> lower(image.numberOfMaterials, image.grid.size);
  std::vector<Index> upper(image.numberOfMaterials, Index{ { -1, -1, -1 } });
  IndexBox::Of(image.grid.size).Visit([&](const Index & at) {
    const Material m = image.materials[image.grid.Offset(at)];
    for (int a = 0; a < 3; ++a)
    {
      lower[m][a] = std::min(lower[m][a], at[a]);
      upper[m][a] = std::max(upper[m][a], at[a]);
    }
  });
  std::vector<MaterialBox> boxes(image.numberOfMaterials);
  for (std::size_t m = 0; m < boxes.size(); ++m)
  {
    if (upper[m][0] >= 0)
    {
      boxes[m] = { lower[m], IndexBox{ lower[m], upper[m] }.Size() };
    }
  }
  return boxes;
}

MaterialBox
ComputeIndicatorBox(const Grid & grid, const MaterialBox & box)
{
  MaterialBox covered;
  for (int a = 0; a < 3; ++a)
  {
    const int band = BandNodes(grid, a);
    covered.lower[a] = std::max(box.lower[a] - band, 0);
    covered.size[a] = std::min(box.lower[a] + box.size[a] + band, grid.size[a]) - covered.lower[a];
  }
  return covered;
}

Block<float>
ComputeSmoothIndicator(const MaterialImage & image, Material material, const MaterialBox & box, double radius)
{
  const Grid & grid = image.grid;
  Index        lower;
  Index        size;
  for (int a = 0; a < 3; ++a)
  {
    const int band = BandNodes(grid, a);
    const int low = std::max(box.lower[a] - band, -Parameters::BorderContinuation);
    const int high = std::min(box.lower[a] + box.size[a] + band, grid.size[a] + Parameters::BorderContinuation);
    lower[a] = low;
    size[a] = high - low;
  }

  LevelSet levelSet(lower, size, grid.spacing, IndicatorBandWidth);
  ComputeBoxDistance(image, material, levelSet);
  if (radius > 0.0)
  {
    const double flowBand = Parameters::FlowBandWidth + std::max(0.0, radius - 0.5);
    levelSet.SelectBand(flowBand);
    const auto margins = CentreMargins(image, levelSet);
    AntiAlias(levelSet, margins);
    levelSet.Redistance(LevelSet::Before::NearDistances);
    Tighten(levelSet, margins, radius);
    levelSet.SelectBand(IndicatorBandWidth);
    levelSet.Redistance(LevelSet::Before::NearDistances);
  }

  const auto covered = ComputeIndicatorBox(grid, box);
  return levelSet.Copy(covered.lower, covered.size);
}

IndicatorSet
MakeIndicatorSet(const Grid & grid, const std::vector<Block<float>> & blocks)
{
  std::vector<IndicatorBricks> indicators;
  for (const auto & block : blocks)
  {
    const BlockView<const float> view{ block.lower, block.size, block.values.data() };
    indicators.emplace_back(grid, view, -float(IndicatorBandWidth));
  }
  return IndicatorSet(grid, std::move(indicators), -IndicatorBandWidth);
}
} // namespace mmm
