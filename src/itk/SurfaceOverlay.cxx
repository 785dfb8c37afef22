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

#include "base/FaceNeighbours.h"
#include "indicators/IndicatorSmoothing.h"
#include "itk/ImageRegions.h"
#include "itk/LabelDomain.h"
#include "itk/LabelSmoothing.h"

#include "itkImageRegionConstIterator.h"
#include "itkImageRegionIterator.h"

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

/** A region within that of a grid. */
IndexBox
BoxOf(const FloatImage::RegionType & region, const FloatImage::RegionType & whole)
{
  IndexBox box;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    box.lower[axis] = static_cast<int>(region.GetIndex(axis) - whole.GetIndex(axis));
    box.upper[axis] = static_cast<int>(region.GetUpperIndex()[axis] - whole.GetIndex(axis));
  }
  return box;
}

FloatImage::RegionType
RegionOf(const IndexBox & box)
{
  FloatImage::RegionType region;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    region.SetIndex(axis, box.lower[axis]);
    region.SetSize(axis, static_cast<itk::SizeValueType>(box.upper[axis] - box.lower[axis] + 1));
  }
  return region;
}

/** The distance as indicators have it: within the band, and not too near to 0. */
float
ToLead(double distance)
{
  const float sign = distance > 0.0 ? 1.0f : -1.0f;
  return sign * std::min(std::max(static_cast<float>(std::abs(distance)), LeastDistance), Band);
}

/** The nodes of a layer that are not far, and those that interpolation between them takes. */
void
ShrinkToBand(IndicatorLayer & layer)
{
  IndexBox near{ layer.box.upper, layer.box.lower };
  auto     distance = layer.distances.begin();
  layer.box.Visit([&](const Index & at) {
    for (int a = 0; *distance > -Band && a < 3; ++a)
    {
      near.lower[a] = std::min(near.lower[a], at[a]);
      near.upper[a] = std::max(near.upper[a], at[a]);
    }
    ++distance;
  });
  constexpr int margin = 2;
  for (int a = 0; a < 3; ++a)
  {
    near.lower[a] = std::max(near.lower[a] - margin, layer.box.lower[a]);
    near.upper[a] = std::min(near.upper[a] + margin, layer.box.upper[a]);
  }
  std::vector<float> distances;
  distance = layer.distances.begin();
  layer.box.Visit([&](const Index & at) {
    if (near.Contains(at))
    {
      distances.push_back(*distance);
    }
    ++distance;
  });
  layer.box = near;
  layer.distances.swap(distances);
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

SurfaceOverlay::Layers
SurfaceOverlay::GetLayers(const GridGeometry & geometry) const
{
  Layers layers;
  for (std::size_t k = 0; k < m_Surfaces.distances.size(); ++k)
  {
    const FloatImage & image = *m_Surfaces.distances[k];
    auto               region = image.GetBufferedRegion();
    layers.push_back({ m_Surfaces.labels[k], m_Surfaces.GetReplaced(k), {}, {} });
    IndicatorLayer & layer = layers.back();
    if (!region.Crop(geometry.GetRegion()))
    {
      layer.box = { { { 0, 0, 0 } }, { { -1, -1, -1 } } };
      continue;
    }
    layer.box = BoxOf(region, geometry.GetRegion());
    layer.distances.reserve(region.GetNumberOfPixels());
    itk::ImageRegionConstIterator<FloatImage> value(&image, region);
    for (; !value.IsAtEnd(); ++value)
    {
      layer.distances.push_back(ToLead(value.Get() / geometry.GetUnit()));
    }
    ShrinkToBand(layer);
  }
  return layers;
}

std::vector<int>
SurfaceOverlay::GetTops(const int * own, const Layers & layers, const Grid & grid)
{
  std::vector<int> tops(grid.NumberOfNodes(), -1);
  for (std::size_t k = 0; k < layers.size(); ++k)
  {
    auto distance = layers[k].distances.begin();
    layers[k].box.Visit([&](const Index & at) {
      const auto n = grid.Offset(at);
      if (*distance++ > 0.0f && layers[k].Hides(tops[n] < 0 ? own[n] : layers[tops[n]].label))
      {
        tops[n] = static_cast<int>(k);
      }
    });
  }
  return tops;
}

void
SurfaceOverlay::TakeMergedIslands(const int * labels, const std::vector<int> & tops, const Grid & grid, Layers & layers)
{
  for (IndicatorLayer & layer : layers)
  {
    auto distance = layer.distances.begin();
    layer.box.Visit([&](const Index & at) {
      const auto n = grid.Offset(at);
      if (tops[n] >= 0 && layers[tops[n]].label != labels[n] && layer.label != labels[n])
      {
        *distance = -std::abs(*distance);
      }
      ++distance;
    });
  }
}

LabelImage::Pointer
SurfaceOverlay::MakeImageBelow(const LabelImage *       labels,
                               const std::vector<int> & present,
                               const GridGeometry &     geometry,
                               const int *              own,
                               const std::vector<int> & tops) const
{
  const Grid & grid = geometry.GetGrid();
  const auto   below = LabelImage::New();
  below->CopyInformation(labels);
  below->SetRegions(labels->GetLargestPossibleRegion());
  below->Allocate();
  int * const              label = below->GetBufferPointer();
  std::vector<bool>        isKnown(grid.NumberOfNodes());
  std::vector<std::size_t> known;
  for (std::size_t n = 0; n < isKnown.size(); ++n)
  {
    const bool isHidden = tops[n] >= 0;
    label[n] = isHidden ? own[n] : labels->GetBufferPointer()[n];
    isKnown[n] = !isHidden || std::binary_search(present.begin(), present.end(), label[n]);
    if (isKnown[n])
    {
      known.push_back(n);
    }
  }
  // from voxel to voxel, all at once
  for (std::size_t next = 0; next < known.size(); ++next)
  {
    ForEachFaceNeighbour(grid, grid.IndexAt(known[next]), [&](const Index & beside) {
      const auto n = grid.Offset(beside);
      if (!isKnown[n])
      {
        label[n] = label[known[next]];
        isKnown[n] = true;
        known.push_back(n);
      }
    });
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
  const Grid &    grid = geometry.GetGrid();
  const auto      image = CopyRegion(m_Image.GetPointer(), geometry.GetRegion(), present.front());
  const int *     own = image->GetBufferPointer();
  Layers          layers = this->GetLayers(geometry);
  const auto      tops = GetTops(own, layers, grid);
  LabelIndicators below = SmoothImage(options, this->MakeImageBelow(labels, present, geometry, own, tops), monitor);
  TakeMergedIslands(labels->GetBufferPointer(), tops, grid, layers);

  std::vector<LabelIndicator> indicators;
  for (const int label : present)
  {
    const auto place = std::find(below.labels.begin(), below.labels.end(), label);
    indicators.push_back({ label, { { { 0, 0, 0 } }, { { -1, -1, -1 } } }, {} });
    LabelIndicator & indicator = indicators.back();
    for (const IndicatorLayer & layer : layers)
    {
      indicator.box = layer.label == label ? Union(indicator.box, layer.box) : indicator.box;
    }
    const auto   source = place == below.labels.end() ? nullptr : below.images[place - below.labels.begin()];
    const auto   sourceRegion = source ? source->GetBufferedRegion() : FloatImage::RegionType();
    const auto & whole = labels->GetLargestPossibleRegion();
    const auto   sourceBox = source ? BoxOf(sourceRegion, whole) : indicator.box;
    indicator.box = Union(indicator.box, sourceBox);
    const Index size = indicator.box.Size();
    indicator.values.assign(std::size_t(size[0]) * size[1] * size[2], -Band);
    if (source)
    {
      const float * value = source->GetBufferPointer();
      sourceBox.Visit([&](const Index & at) { indicator.At(at) = *value++; });
      below.images[place - below.labels.begin()] = nullptr;
    }
  }
  PutOnTop(grid, layers, indicators);

  std::vector<FloatImage::Pointer> images;
  for (LabelIndicator & indicator : indicators)
  {
    images.push_back(FloatImage::New());
    images.back()->CopyInformation(labels);
    images.back()->SetRegions(RegionOf(indicator.box));
    images.back()->Allocate();
    std::copy(indicator.values.begin(), indicator.values.end(), images.back()->GetBufferPointer());
    indicator.values = {};
  }
  return images;
}

LabelImage::Pointer
ComposeLabels(const LabelImage * labels, const SurfaceInputs & surfaces)
{
  const auto & whole = labels->GetLargestPossibleRegion();
  const auto   composed = LabelImage::New();
  composed->CopyInformation(labels);
  composed->SetRegions(whole);
  composed->Allocate();
  std::copy_n(labels->GetBufferPointer(), whole.GetNumberOfPixels(), composed->GetBufferPointer());
  for (std::size_t k = 0; k < surfaces.distances.size(); ++k)
  {
    const auto replaced = surfaces.GetReplaced(k);
    auto       region = surfaces.distances[k]->GetBufferedRegion();
    const bool isInImage = region.Crop(whole);
    bool       isThere = false;
    if (isInImage)
    {
      itk::ImageRegionConstIterator<FloatImage> distance(surfaces.distances[k], region);
      itk::ImageRegionIterator<LabelImage>      label(composed, region);
      for (; !label.IsAtEnd(); ++label, ++distance)
      {
        if (distance.Get() > 0.0f && (replaced.empty() || Contains(replaced, label.Get())))
        {
          label.Set(surfaces.labels[k]);
          isThere = true;
        }
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
