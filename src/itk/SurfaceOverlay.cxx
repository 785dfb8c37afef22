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
#include "itk/SurfaceOverlay.h"

#include "base/IndexBox.h"
#include "indicators/IndicatorSmoothing.h"
#include "itk/ImageRegions.h"
#include "itk/LabelSmoothing.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
constexpr auto Band = static_cast<float>(IndicatorBandWidth);
/** No interface passes closer to a voxel's centre than this, in units of the grid: which side the centre is on is
 * certain then, and the surface is where it was within as much. */
constexpr float LeastDistance = 0.02f;

using Box = IndexBox;

Box
EmptyBox(const Grid & grid)
{
  return { grid.size, { { -1, -1, -1 } } };
}

/** The nodes at which values are above the band's lower end. */
Box
BoxOf(const Grid & grid, const std::vector<float> & values)
{
  Box box = EmptyBox(grid);
  for (std::size_t n = 0; n < values.size(); ++n)
  {
    if (values[n] > -Band)
    {
      const Index at = grid.IndexAt(n);
      for (int a = 0; a < 3; ++a)
      {
        box.lower[a] = std::min(box.lower[a], at[a]);
        box.upper[a] = std::max(box.upper[a], at[a]);
      }
    }
  }
  return box;
}

Box
Union(const Box & first, const Box & second)
{
  Box box;
  for (int a = 0; a < 3; ++a)
  {
    box.lower[a] = std::min(first.lower[a], second.lower[a]);
    box.upper[a] = std::max(first.upper[a], second.upper[a]);
  }
  return box;
}

/** An image of the grid, which begins at the index 0. */
Box
BoxOf(const FloatImage::RegionType & region)
{
  Box box;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    box.lower[axis] = static_cast<int>(region.GetIndex(axis));
    box.upper[axis] = static_cast<int>(region.GetUpperIndex()[axis]);
  }
  return box;
}

FloatImage::RegionType
RegionOf(const Box & box)
{
  FloatImage::RegionType region;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    region.SetIndex(axis, box.lower[axis]);
    region.SetSize(axis, static_cast<itk::SizeValueType>(box.upper[axis] - box.lower[axis] + 1));
  }
  return region;
}

/** The indicators of the image's labels; one that is everywhere has no boundary. */
LabelIndicators
SmoothImage(const SmoothingOptions & options, const LabelImage * image, Monitor & monitor)
{
  const auto counts = CountLabels(image);
  if (counts.size() > 1)
  {
    return ComputeIndicatorImages(options, image, monitor);
  }
  LabelIndicators indicators;
  const auto      everywhere = FloatImage::New();
  everywhere->CopyInformation(image);
  everywhere->SetRegions(image->GetLargestPossibleRegion());
  everywhere->Allocate();
  everywhere->FillBuffer(Band);
  indicators.labels.push_back(counts.begin()->first);
  indicators.images.push_back(everywhere);
  return indicators;
}
} // namespace

SurfaceOverlay::Distances
SurfaceOverlay::GetDistances(const LabelImage * labels, const GridGeometry & geometry) const
{
  const auto beyond = static_cast<float>(-Band * geometry.GetUnit());
  Distances  distances;
  for (std::size_t k = 0; k < m_Surfaces.distances.size(); ++k)
  {
    const auto    part = CopyRegion(m_Surfaces.distances[k].GetPointer(), geometry.GetRegion(), beyond);
    const float * value = part->GetBufferPointer();
    distances.emplace_back(geometry.GetGrid().NumberOfNodes());
    for (float & distance : distances.back())
    {
      distance = std::min(static_cast<float>(*value++ / geometry.GetUnit()), Band);
      const float least = distance > 0.0f ? LeastDistance : -LeastDistance;
      distance = std::max(std::abs(distance) < LeastDistance ? least : distance, -Band);
    }
  }
  // islands that were merged are not in surfaces any more
  const int * label = labels->GetBufferPointer();
  for (std::size_t n = 0; n < geometry.GetGrid().NumberOfNodes(); ++n, ++label)
  {
    std::size_t top = distances.size();
    while (top > 0 && distances[top - 1][n] < 0.0f)
    {
      --top;
    }
    for (std::size_t k = 0; k < top && m_Surfaces.labels[top - 1] != *label; ++k)
    {
      if (m_Surfaces.labels[k] != *label)
      {
        distances[k][n] = -std::abs(distances[k][n]);
      }
    }
  }
  return distances;
}

LabelImage::Pointer
SurfaceOverlay::MakeImageBelow(const LabelImage *       labels,
                               const std::vector<int> & present,
                               const GridGeometry &     geometry,
                               const Distances &        distances) const
{
  const Grid & grid = geometry.GetGrid();
  const auto   own = CopyRegion(m_Image.GetPointer(), geometry.GetRegion(), present.front());
  const auto   below = LabelImage::New();
  below->CopyInformation(labels);
  below->SetRegions(labels->GetLargestPossibleRegion());
  below->Allocate();
  int * const              label = below->GetBufferPointer();
  std::vector<bool>        isKnown(grid.NumberOfNodes());
  std::vector<std::size_t> known;
  for (std::size_t n = 0; n < isKnown.size(); ++n)
  {
    const bool isHidden =
      std::any_of(distances.begin(), distances.end(), [n](const auto & values) { return values[n] > 0.0f; });
    label[n] = isHidden ? own->GetBufferPointer()[n] : labels->GetBufferPointer()[n];
    isKnown[n] = !isHidden || std::binary_search(present.begin(), present.end(), label[n]);
    if (isKnown[n])
    {
      known.push_back(n);
    }
  }
  // from voxel to voxel, all at once
  for (std::size_t next = 0; next < known.size(); ++next)
  {
    const Index at = grid.IndexAt(known[next]);
    for (int a = 0; a < 3; ++a)
    {
      for (const int step : { -1, 1 })
      {
        Index beside = at;
        beside[a] += step;
        if (grid.Contains(beside) && !isKnown[grid.Offset(beside)])
        {
          const auto n = grid.Offset(beside);
          label[n] = label[known[next]];
          isKnown[n] = true;
          known.push_back(n);
        }
      }
    }
  }
  if (known.empty())
  {
    below->FillBuffer(present.front());
  }
  return below;
}

std::vector<FloatImage::Pointer>
SurfaceOverlay::ComputeIndicators(const LabelImage *       labels,
                                  const std::vector<int> & present,
                                  const GridGeometry &     geometry,
                                  const SmoothingOptions & options,
                                  Monitor &                monitor) const
{
  const Grid &     grid = geometry.GetGrid();
  const Distances  distances = this->GetDistances(labels, geometry);
  LabelIndicators  below = SmoothImage(options, this->MakeImageBelow(labels, present, geometry, distances), monitor);
  std::vector<Box> boxes;
  for (const auto & values : distances)
  {
    boxes.push_back(BoxOf(grid, values));
  }

  std::vector<FloatImage::Pointer> indicators;
  for (const int label : present)
  {
    const auto place = std::find(below.labels.begin(), below.labels.end(), label);
    const bool isBelow = place != below.labels.end();
    const auto image = isBelow ? below.images[place - below.labels.begin()] : nullptr;
    const Box  imageBox = isBelow ? BoxOf(image->GetBufferedRegion()) : EmptyBox(grid);
    Box        box = imageBox;
    for (std::size_t k = 0; k < boxes.size(); ++k)
    {
      if (m_Surfaces.labels[k] == label)
      {
        box = Union(box, boxes[k]);
      }
    }
    const auto indicator = FloatImage::New();
    indicator->CopyInformation(labels);
    indicator->SetRegions(RegionOf(box));
    indicator->Allocate();
    float * value = indicator->GetBufferPointer();
    box.Visit([&](const Index & at) {
      const auto n = grid.Offset(at);
      float      largest = -Band;
      float      over = -Band;
      for (std::size_t k = distances.size(); k-- > 0;)
      {
        if (m_Surfaces.labels[k] == label)
        {
          largest = std::max(largest, std::min(distances[k][n], -over));
        }
        else
        {
          over = std::max(over, distances[k][n]);
        }
      }
      if (imageBox.Contains(at))
      {
        const float own = image->GetPixel({ { at[0], at[1], at[2] } });
        largest = std::max(largest, std::min(own, -over));
      }
      *value++ = largest;
    });
    indicators.push_back(indicator);
  }
  return indicators;
}

LabelImage::Pointer
ComposeLabels(const LabelImage * labels, const SurfaceInputs & surfaces)
{
  const auto composed = LabelImage::New();
  composed->CopyInformation(labels);
  composed->SetRegions(labels->GetLargestPossibleRegion());
  composed->Allocate();
  const auto voxels = labels->GetLargestPossibleRegion().GetNumberOfPixels();
  int *      label = composed->GetBufferPointer();
  std::copy(labels->GetBufferPointer(), labels->GetBufferPointer() + voxels, label);
  for (std::size_t k = 0; k < surfaces.distances.size(); ++k)
  {
    const float * const distance = surfaces.distances[k]->GetBufferPointer();
    bool                isThere = false;
    for (std::size_t v = 0; v < voxels; ++v)
    {
      if (distance[v] > 0.0f)
      {
        label[v] = surfaces.labels[k];
        isThere = true;
      }
    }
    if (!isThere)
    {
      itkGenericExceptionMacro("No voxel's centre is within surface "
                               << k << ", of label " << surfaces.labels[k]
                               << ": it is thinner than the voxels. Smaller voxels are needed.");
    }
  }
  return composed;
}

std::string
DescribeError(const SurfaceInputs & surfaces)
{
  const auto & images = surfaces.distances;
  if (surfaces.labels.size() != images.size())
  {
    return "There are " + std::to_string(surfaces.labels.size()) + " surface labels for " +
           std::to_string(images.size()) + " surface distance images.";
  }
  const auto missing = std::find(images.begin(), images.end(), nullptr);
  return missing == images.end() ? ""
                                 : "Surface distance image " + std::to_string(missing - images.begin()) + " of " +
                                     std::to_string(images.size()) + " is missing.";
}
} // namespace mmm
