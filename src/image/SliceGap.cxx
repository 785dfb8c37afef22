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
#include "image/SliceGap.h"

#include "image/SliceBorders.h"
#include "image/SliceWindow.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace mmm
{
namespace
{
/** How far from a part of a slice the same material may be in the other one if they belong together, in distances of
 * slices. Analysis: on a cap of 90 mm, layers of 2 mm in slices 5 mm apart are up to 8 mm from each other. */
constexpr double FarthestPartner = 2.0;

/** The height of a dome in distances of slices. Analysis: with the profile r = R (1 - (t / h)^2) it has the volume of
 * half a slice then. */
constexpr double DomeHeight = 15.0 / 16.0;

/** The least factor by which distances in the one slice count less than in the other, and halvings on the way to what
 * balances volumes. */
constexpr double LeastBalance = 0.5;
constexpr int    BalanceHalvings = 20;

/** Of pixels whose part has ended. */
constexpr Material NoMaterial = std::numeric_limits<Material>::max();
} // namespace

SliceGap::SliceGap(const SlicePlane & plane, double distance, Slice lower, Slice upper)
  : m_Plane(plane)
  , m_Slices{ { std::move(lower), std::move(upper) } }
{
  if (m_Slices[0] != m_Slices[1])
  {
    this->FindChanges(this->TakeOutEnds(distance));
    this->BalanceVolumes();
  }
}

MaterialDistances
SliceGap::DistancesToMaterials(const Slice & slice) const
{
  MaterialDistances distances;
  for (const Material m : slice)
  {
    if (m == NoMaterial || (m < distances.size() && !distances[m].empty()))
    {
      continue;
    }
    distances.resize(std::max(distances.size(), std::size_t(m) + 1));
    std::vector<char> isIn(slice.size());
    std::transform(slice.begin(), slice.end(), isIn.begin(), [m](Material other) { return other == m; });
    distances[m] = DistancesToSet(m_Plane, isIn);
  }
  return distances;
}

/** Returns the distances to what is left. */
BothSides<MaterialDistances>
SliceGap::TakeOutEnds(double distance)
{
  BothSides<MaterialDistances> distances;
  for (int side = 0; side < SliceSides; ++side)
  {
    distances[side] = this->DistancesToMaterials(m_Slices[side]);
  }
  for (int side = 0; side < SliceSides; ++side)
  {
    m_Ends[side] = this->EndsOf(side, distances[1 - side], FarthestPartner * distance);
  }
  for (int side = 0; side < SliceSides; ++side)
  {
    if (!m_Ends[side].empty() && m_Ends[side].size() < m_Slices[side].size())
    {
      this->FillIn(side);
      distances[side] = this->DistancesToMaterials(m_Slices[side]);
    }
  }
  return distances;
}

/** Its pixels of one material that share edges. */
ImageParts
SliceGap::PartsOf(const Slice & slice) const
{
  MaterialImage image;
  image.grid.size = { { m_Plane.size[0], m_Plane.size[1], 1 } };
  image.materials = slice;
  return FindImageParts(image);
}

std::vector<SliceGap::EndingPixel>
SliceGap::EndsOf(int side, const MaterialDistances & distancesInOther, double farthest) const
{
  const Slice &                         slice = m_Slices[side];
  const ImageParts                      parts = this->PartsOf(slice);
  std::vector<std::vector<std::size_t>> pixels(parts.parts.size());
  std::vector<char>                     ends(parts.parts.size(), 1);
  for (std::size_t n = 0; n < slice.size(); ++n)
  {
    const Material m = slice[n];
    const auto     part = parts.numbers[n];
    pixels[part].push_back(n);
    if (m < distancesInOther.size() && !distancesInOther[m].empty() && distancesInOther[m][n] <= farthest)
    {
      ends[part] = 0;
    }
  }
  std::vector<EndingPixel> found;
  for (std::size_t part = 0; part < pixels.size(); ++part)
  {
    if (ends[part])
    {
      this->AddDome(pixels[part], side, found);
    }
  }
  return found;
}

/** The deeper a pixel lies in a part, the further it reaches: so that at each height, the share of the part's pixels
 * that are there is that of the dome's section. */
void
SliceGap::AddDome(const std::vector<std::size_t> & pixels, int side, std::vector<EndingPixel> & ends) const
{
  // in the window of the part, with a pixel around as far as there are any
  SliceWindow window(m_Plane);
  for (const std::size_t pixel : pixels)
  {
    window.Include(pixel, 1);
  }
  std::vector<char> isOutside(window.Plane().NumberOfPixels(), 1);
  for (const std::size_t pixel : pixels)
  {
    isOutside[window.Offset(pixel)] = 0;
  }
  const auto                                 depths = DistancesToSet(window.Plane(), isOutside);
  std::vector<std::pair<float, std::size_t>> order;
  for (const std::size_t pixel : pixels)
  {
    order.push_back({ -depths[window.Offset(pixel)], pixel });
  }
  std::sort(order.begin(), order.end());
  for (auto begin = order.begin(); begin != order.end();)
  {
    const auto end = std::find_if(begin, order.end(), [&](const auto & entry) { return entry.first != begin->first; });
    const double deeper = 0.5 * double((begin - order.begin()) + (end - order.begin())) / double(order.size());
    const double reach = DomeHeight * std::sqrt(1.0 - std::sqrt(deeper));
    for (; begin != end; ++begin)
    {
      ends.push_back({ begin->second, m_Slices[side][begin->second], reach });
    }
  }
}

/** Gives the pixels that end to the material that is nearest, the first of equals. */
void
SliceGap::FillIn(int side)
{
  Slice & slice = m_Slices[side];
  for (const EndingPixel & end : m_Ends[side])
  {
    slice[end.pixel] = NoMaterial;
  }
  const MaterialDistances distances = this->DistancesToMaterials(slice);
  for (const EndingPixel & end : m_Ends[side])
  {
    float nearest = std::numeric_limits<float>::infinity();
    for (std::size_t m = 0; m < distances.size(); ++m)
    {
      if (!distances[m].empty() && distances[m][end.pixel] < nearest)
      {
        nearest = distances[m][end.pixel];
        slice[end.pixel] = Material(m);
      }
    }
  }
}

void
SliceGap::FindChanges(const BothSides<MaterialDistances> & distances)
{
  const auto isThere = [&](int side, std::size_t m) {
    return m < distances[side].size() && !distances[side][m].empty();
  };
  std::vector<Material> common;
  for (std::size_t m = 0; m < distances[0].size(); ++m)
  {
    if (isThere(0, m) && isThere(1, m))
    {
      common.push_back(Material(m));
    }
  }
  SliceBorders borders(m_Plane, distances);
  const auto   forEachPair = [](const std::vector<Material> & materials, const auto & body) {
    for (std::size_t a = 0; a < materials.size(); ++a)
    {
      for (std::size_t b = a + 1; b < materials.size(); ++b)
      {
        body(materials[a], materials[b]);
      }
    }
  };
  for (std::size_t n = 0; n < m_Slices[0].size(); ++n)
  {
    const Material below = m_Slices[0][n];
    const Material above = m_Slices[1][n];
    if (below == above || !isThere(1, below) || !isThere(0, above))
    {
      continue;
    }
    // these two, and what comes before them on the way to either
    ChangingPixel change{ n, {}, {} };
    for (const Material m : common)
    {
      if (distances[0][m][n] <= distances[0][above][n] && distances[1][m][n] <= distances[1][below][n])
      {
        change.candidates.push_back(m);
      }
    }
    forEachPair(change.candidates, [&](Material a, Material b) { borders.Enlarge(a, b, n); });
    m_Changes.push_back(std::move(change));
  }
  borders.Compute();
  for (ChangingPixel & change : m_Changes)
  {
    forEachPair(change.candidates,
                [&](Material a, Material b) { change.contests.push_back(borders.At(a, b, change.pixel)); });
  }
}

/** Fingers end sooner than what is around them goes on. So that neither gains, half of the volume of the pixels that
 * change from one material to another, where they are connected, stays with either. */
void
SliceGap::BalanceVolumes()
{
  Slice                                             kindAt(m_Plane.NumberOfPixels(), 0);
  std::map<std::pair<Material, Material>, Material> kinds;
  for (const ChangingPixel & change : m_Changes)
  {
    if (change.contests.size() == 1)
    {
      const auto next = Material(kinds.size() + 1);
      kindAt[change.pixel] =
        kinds.insert({ { m_Slices[0][change.pixel], m_Slices[1][change.pixel] }, next }).first->second;
    }
  }
  const ImageParts                          parts = this->PartsOf(kindAt);
  std::vector<std::vector<ChangingPixel *>> members(parts.parts.size());
  for (ChangingPixel & change : m_Changes)
  {
    if (change.contests.size() == 1)
    {
      members[parts.numbers[change.pixel]].push_back(&change);
    }
  }
  for (const auto & part : members)
  {
    double least = LeastBalance;
    double most = 1.0 / LeastBalance;
    for (int halving = 0; !part.empty() && halving < BalanceHalvings; ++halving)
    {
      const double balance = std::sqrt(least * most);
      double       sum = 0.0; // of the shares at which pixels change
      for (const ChangingPixel * change : part)
      {
        const double below = balance * std::abs(change->contests[0][0]);
        sum += below / (below + std::abs(change->contests[0][1]));
      }
      (sum < 0.5 * double(part.size()) ? least : most) = balance;
    }
    for (ChangingPixel * change : part)
    {
      change->contests[0][0] *= std::sqrt(least * most);
    }
  }
}

/** The material whose worst contest goes best. */
Material
SliceGap::Winner(const ChangingPixel & pixel, double share)
{
  const auto &        candidates = pixel.candidates;
  std::vector<double> worst(candidates.size(), std::numeric_limits<double>::infinity());
  auto                contest = pixel.contests.begin();
  for (std::size_t a = 0; a < candidates.size(); ++a)
  {
    for (std::size_t b = a + 1; b < candidates.size(); ++b, ++contest)
    {
      const double lead = (1.0 - share) * (*contest)[0] + share * (*contest)[1];
      worst[a] = std::min(worst[a], lead);
      worst[b] = std::min(worst[b], -lead);
    }
  }
  return candidates[std::size_t(std::max_element(worst.begin(), worst.end()) - worst.begin())];
}

Slice
SliceGap::At(double share) const
{
  // where one of the two has no partner, the nearer slice is taken
  Slice slice = m_Slices[share < 0.5 ? 0 : 1];
  for (const ChangingPixel & change : m_Changes)
  {
    slice[change.pixel] = Winner(change, share);
  }
  const bool lowerFirst = share >= 0.5;
  for (const int side : { lowerFirst ? 0 : 1, lowerFirst ? 1 : 0 }) // the nearer one covers the other
  {
    const double away = side == 0 ? share : 1.0 - share;
    for (const EndingPixel & end : m_Ends[side])
    {
      if (away <= end.reach)
      {
        slice[end.pixel] = end.material;
      }
    }
  }
  return slice;
}
} // namespace mmm
