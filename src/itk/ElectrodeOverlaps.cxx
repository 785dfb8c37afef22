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
#include "itk/ElectrodeOverlaps.h"

#include "itkImageRegionConstIterator.h"

#include <cmath>

namespace mmm
{
namespace
{
/** Whether two are inside of both at some voxel's centre. */
bool
Overlap(const FloatImage * first, const FloatImage * second)
{
  auto region = first->GetBufferedRegion();
  if (!region.Crop(second->GetBufferedRegion()))
  {
    return false;
  }
  itk::ImageRegionConstIterator<FloatImage> a(first, region);
  itk::ImageRegionConstIterator<FloatImage> b(second, region);
  for (; !a.IsAtEnd(); ++a, ++b)
  {
    if (a.Get() > 0.0f && b.Get() > 0.0f)
    {
      return true;
    }
  }
  return false;
}

/** Whether a cylinder lies within another one, with its axis and its radius. */
bool
IsPartOf(const Electrode & part, const Electrode & body)
{
  const auto isCylinder = [](const Electrode & electrode) {
    return electrode.shape == ElectrodeShape::Cylinder && electrode.end && electrode.innerRadius == 0.0;
  };
  const double tolerance = 1e-3 * body.radius;
  if (!isCylinder(part) || !isCylinder(body) || std::abs(part.radius - body.radius) > tolerance)
  {
    return false;
  }
  const auto   way = *body.end - body.position;
  const double length = way.GetNorm();
  const auto   isOnAxis = [&](const Electrode::PointType & x) {
    const double along = (x - body.position) * way / length;
    const auto   beside = x - (body.position + way * (along / length));
    return beside.GetNorm() < tolerance && along > -tolerance && along < length + tolerance;
  };
  return isOnAxis(part.position) && isOnAxis(*part.end);
}
} // namespace

std::vector<Electrode>
WithBodies(std::vector<Electrode> electrodes)
{
  for (std::size_t n = 0; n < electrodes.size(); ++n)
  {
    for (std::size_t other = n; other-- > 0 && !electrodes[n].bodyLabel;)
    {
      if (!electrodes[other].bodyLabel && IsPartOf(electrodes[n], electrodes[other]))
      {
        electrodes[n].bodyLabel = electrodes[other].label;
      }
    }
  }
  return electrodes;
}

void
ReportCovered(const std::vector<Electrode> & electrodes, PlacedElectrodes & placed)
{
  std::vector<std::size_t> bodies;
  for (std::size_t n = 0, surface = 0; n < electrodes.size(); ++n)
  {
    const auto & distances = placed.surfaces.distances;
    for (std::size_t other = 0; other < n; ++other)
    {
      // a contact is where its body is, and hides nothing else
      const bool isContact = electrodes[n].bodyLabel || electrodes[other].bodyLabel;
      if (!isContact && Overlap(distances[surface], distances[bodies[other]]))
      {
        placed.reports[n].covered.push_back(electrodes[other].name);
      }
    }
    bodies.push_back(surface);
    surface += electrodes[n].gel ? 2 : 1;
  }
}
} // namespace mmm
