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
#include "itk/LabelSmoothing.h"

#include "indicators/IndicatorSmoothing.h"
#include "indicators/PassageWidening.h"
#include "indicators/VolumeCorrection.h"
#include "itk/FilterMonitor.h"
#include "itk/GridGeometry.h"
#include "itk/Labels.h"

#include <cmath>

namespace mmm
{
namespace
{
/** The block in the image's physical space; beyond it, its values are the lowest. */
FloatImage::Pointer
MakeImage(const LabelImage * labels, const Block<float> & block, double unit, bool cropToBand)
{
  const auto &           whole = labels->GetLargestPossibleRegion();
  FloatImage::RegionType blockRegion;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    blockRegion.SetIndex(axis, whole.GetIndex(axis) + block.lower[axis]);
    blockRegion.SetSize(axis, static_cast<itk::SizeValueType>(block.size[axis]));
  }
  const auto image = FloatImage::New();
  image->CopyInformation(labels);
  image->SetRegions(cropToBand ? blockRegion : whole);
  image->Allocate();
  if (!cropToBand)
  {
    image->FillBuffer(static_cast<float>(-IndicatorBandWidth * unit));
  }
  auto value = block.values.begin();
  for (int k = 0; k < block.size[2]; ++k)
  {
    for (int j = 0; j < block.size[1]; ++j)
    {
      auto start = blockRegion.GetIndex();
      start[1] += j;
      start[2] += k;
      float * row = image->GetBufferPointer() + image->ComputeOffset(start);
      for (int i = 0; i < block.size[0]; ++i)
      {
        *row++ = static_cast<float>(*value++ * unit);
      }
    }
  }
  return image;
}
} // namespace

double
IndicatorBandWidthOf(const itk::ImageBase<3> * image)
{
  return IndicatorBandWidth * GridGeometry(image, image->GetLargestPossibleRegion()).GetUnit();
}

LabelIndicators
ComputeIndicatorImages(const SmoothingOptions & options, const LabelImage * image, Monitor & monitor)
{
  LabelIndicators indicators;
  indicators.labels = LabelsOf(image);
  const std::size_t   count = indicators.labels.size();
  const GridGeometry  geometry(image, image->GetLargestPossibleRegion());
  const double        radius = std::isnan(options.radius) ? 0.5 : geometry.ToGridUnit(options.radius);
  const MaterialImage materials = MakeMaterialImage(image, indicators.labels);
  const auto          boxes = ComputeMaterialBoxes(materials);

  std::vector<Block<float>> blocks(count);
  for (std::size_t n = 0; n < count; ++n)
  {
    blocks[n] = ComputeSmoothIndicator(materials, static_cast<Material>(n), boxes[n], radius);
    monitor.Report(static_cast<double>(n + 1) / (count + 1));
  }
  if (radius > 0.0)
  {
    // what comes last has its way: volumes, unless it is contacts
    if (!options.keepContacts)
    {
      WidenPassages(materials.grid, options.keepContacts, blocks);
    }
    CorrectVolumes(materials, blocks);
    monitor.Report((count + 0.5) / (count + 1));
    if (options.keepContacts)
    {
      WidenPassages(materials.grid, options.keepContacts, blocks);
    }
  }
  for (auto & block : blocks)
  {
    indicators.images.push_back(MakeImage(image, block, geometry.GetUnit(), options.cropToBand));
    block = Block<float>();
  }
  monitor.Report(1.0);
  return indicators;
}

LabelIndicators
ComputeIndicatorImages(itk::ProcessObject * filter, const SmoothingOptions & options, const LabelImage * image)
{
  LabelIndicators indicators;
  RunStage(filter, "indicators", [&](FilterMonitor & monitor) {
    indicators = ComputeIndicatorImages(options, image, monitor);
  });
  return indicators;
}
} // namespace mmm
