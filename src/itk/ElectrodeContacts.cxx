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
#include "itk/ElectrodeContacts.h"

#include "itk/LabelDomain.h"

#include <limits>
#include <map>

namespace mmm
{
namespace
{
using Point = Electrode::PointType;

/** The electrodes of a label, or of a gel's label. */
struct Owners
{
  std::vector<std::size_t> electrodes;
  std::vector<std::size_t> gels;
};

std::size_t
Nearest(const std::vector<std::size_t> & candidates, const Point & x, const std::vector<ElectrodeReport> & reports)
{
  double      least = std::numeric_limits<double>::infinity();
  std::size_t nearest = candidates.front();
  for (const std::size_t candidate : candidates)
  {
    const double distance = x.SquaredEuclideanDistanceTo(reports[candidate].position);
    if (distance < least)
    {
      least = distance;
      nearest = candidate;
    }
  }
  return nearest;
}
} // namespace

void
MeasureContacts(const Electrodes &              electrodes,
                const itk::LabelInterfaceMesh * surface,
                const std::vector<int> &        exteriorLabels,
                int                             outsideLabel,
                std::vector<ElectrodeReport> &  reports)
{
  if (electrodes.list.empty())
  {
    return;
  }
  std::map<int, Owners> owners;
  for (std::size_t n = 0; n < electrodes.list.size(); ++n)
  {
    const Electrode & electrode = electrodes.list[n];
    owners[electrode.label].electrodes.push_back(n);
    reports[n].contactArea = 0.0;
    if (electrode.gel)
    {
      owners[electrode.gel->label].gels.push_back(n);
      reports[n].gelContactArea = 0.0;
    }
  }
  std::size_t number = 0;
  for (auto cell = surface->GetCells()->Begin(); cell != surface->GetCells()->End(); ++cell, ++number)
  {
    const auto   sides = surface->GetCellData()->ElementAt(number);
    const auto * ids = cell.Value()->GetPointIds();
    const Point  a = surface->GetPoint(ids[0]);
    const Point  b = surface->GetPoint(ids[1]);
    const Point  c = surface->GetPoint(ids[2]);
    for (const int side : { 0, 1 })
    {
      const int  other = sides[1 - side];
      const auto found = owners.find(sides[side]);
      if (found == owners.end() || other == outsideLabel || Contains(exteriorLabels, other))
      {
        continue;
      }
      const double area = 0.5 * itk::CrossProduct(b - a, c - a).GetNorm();
      Point        middle;
      for (int axis = 0; axis < 3; ++axis)
      {
        middle[axis] = (a[axis] + b[axis] + c[axis]) / 3.0;
      }
      const auto below = owners.find(other);
      const bool isOnGel = below != owners.end() && !below->second.gels.empty();
      if (!found->second.electrodes.empty())
      {
        const std::size_t n = Nearest(found->second.electrodes, middle, reports);
        // with a gel, what counts is that; other electrodes are no contact
        if (electrodes.list[n].gel ? isOnGel : below == owners.end())
        {
          reports[n].contactArea += area;
        }
      }
      else if (below == owners.end())
      {
        reports[Nearest(found->second.gels, middle, reports)].gelContactArea += area;
      }
    }
  }
}
} // namespace mmm
