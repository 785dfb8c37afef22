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
#include "base/Parallel.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
/** Labels are continued this many nodes beyond the image border, so that the flow meets it at right angles. */
constexpr int BorderContinuation = 3;
/** Opening and closing are known to this accuracy: a smooth boundary is not pressed against its own opening. */
constexpr float MortarSlack = 0.05f;
/** The boundary moves less than a voxel: nodes further away need not be solved for. */
constexpr double FlowBandWidth = 2.0;
/** The flows end when the boundary moves less than this per unit of time, root mean square. */
constexpr double AntiAliasTolerance = 0.01;
constexpr double TighteningTolerance = 0.005;
/** No flow that was seen needs as many. */
constexpr int AntiAliasSteps = 200;
constexpr int TighteningSteps = 100;

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
  std::vector<float> margins(levelSet.Band().size(), CentreMargin);
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
  levelSet.FlowByMeanCurvature(lower, upper, AntiAliasTolerance, AntiAliasSteps);
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
    opening[b] = std::min(opening[b] - MortarSlack, start[b]);
    closing[b] = std::max(closing[b] + MortarSlack, start[b]);
    if (start[b] > 0.0f)
    {
      opening[b] = std::max(opening[b], std::min(start[b], margins[b] - yield));
    }
    else
    {
      closing[b] = std::min(closing[b], std::max(start[b], yield - margins[b]));
    }
  }
  levelSet.FlowByMeanCurvature(opening, closing, TighteningTolerance, TighteningSteps);
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
    return CentreMargin;
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
  return likewise > 1 ? ThinCentreMargin : TipCentreMargin;
}

std::vector<MaterialBox>
ComputeMaterialBoxes(const MaterialImage & image)
{
  std::vector<Index> lower(image.numberOfMaterials, image.grid.size);
  std::vector<Index> upper(image.numberOfMaterials, Index{ { -1, -1, -1 } });
  std::size_t        n = 0;
  for (int k = 0; k < image.grid.size[2]; ++k)
  {
    for (int j = 0; j < image.grid.size[1]; ++j)
    {
      for (int i = 0; i < image.grid.size[0]; ++i, ++n)
      {
        const Index at{ { i, j, k } };
        Index &     low = lower[image.materials[n]];
        Index &     high = upper[image.materials[n]];
        for (int a = 0; a < 3; ++a)
        {
          low[a] = std::min(low[a], at[a]);
          high[a] = std::max(high[a], at[a]);
        }
      }
    }
  }
  std::vector<MaterialBox> boxes(image.numberOfMaterials);
  for (std::size_t m = 0; m < boxes.size(); ++m)
  {
    if (upper[m][0] >= 0)
    {
      boxes[m].lower = lower[m];
      boxes[m].size =
        Index{ { upper[m][0] - lower[m][0] + 1, upper[m][1] - lower[m][1] + 1, upper[m][2] - lower[m][2] + 1 } };
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
    const int low = std::max(box.lower[a] - band, -BorderContinuation);
    const int high = std::min(box.lower[a] + box.size[a] + band, grid.size[a] + BorderContinuation);
    lower[a] = low;
    size[a] = high - low;
  }

  LevelSet levelSet(lower, size, grid.spacing, IndicatorBandWidth);
  ComputeBoxDistance(image, material, levelSet);
  if (radius > 0.0)
  {
    const double flowBand = FlowBandWidth + std::max(0.0, radius - 0.5);
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
} // namespace mmm
