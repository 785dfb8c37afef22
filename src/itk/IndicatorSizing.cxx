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
#include "itk/IndicatorSizing.h"

#include "itk/FilterMonitor.h"
#include "itk/IndicatorImages.h"
#include "itk/SizingImage.h"
#include "itk/SizingOptions.h"

#include <algorithm>
#include <sstream>

namespace mmm
{
namespace
{
/** What users add, in the grid's unit. */
SizingControl
MakeControl(const IndicatorInputs & inputs,
            const SizingInputs &    sizing,
            const GridGeometry &    geometry,
            const IndicatorSet &    indicators)
{
  SizingControl control;
  if (sizing.image)
  {
    control.image = ReadSizingImage(sizing.image.GetPointer(), geometry);
    control.imageReplaces = sizing.options.sizingImageReplaces;
  }
  if (sizing.region)
  {
    control.region = ReadMask(sizing.region.GetPointer());
    control.regionRule = ToGridUnit(sizing.options.region, geometry);
    if (!IsInMaterials(control.region, indicators, inputs.exterior))
    {
      itkGenericExceptionMacro("No voxel of the region of interest is in what is meshed.");
    }
  }
  const LabelSizeRules & rules = sizing.options.labelSizes;
  if (!rules.empty())
  {
    for (const auto label : inputs.labels)
    {
      const auto rule = rules.find(label);
      control.materials.push_back(rule == rules.end() ? SizeRule() : ToGridUnit(rule->second, geometry));
    }
  }
  return control;
}

std::string
DescribeRegion(const itk::ImageBase<3> * image, const char * name, const itk::ImageRegion<3> & region)
{
  if (image == nullptr || image->GetLargestPossibleRegion() == region)
  {
    return {};
  }
  std::ostringstream words;
  words << "The " << name << " covers " << image->GetLargestPossibleRegion() << " and the indicator images together "
        << region << ". They must be the same.";
  return words.str();
}
} // namespace

std::string
DescribeError(const IndicatorInputs & indicators, const SizingInputs & sizing)
{
  for (const std::string & error : { DescribeError(indicators),
                                     DescribeError(sizing),
                                     DescribeUnknownLabels(sizing.options.labelSizes, indicators.labels) })
  {
    if (!error.empty())
    {
      return error;
    }
  }
  return {};
}

std::string
DescribeGeometryError(const IndicatorInputs & indicators, const SizingInputs & sizing)
{
  const auto        region = UnionOfRegions(indicators.images);
  const std::string error = DescribeRegion(sizing.image, "sizing image", region);
  return error.empty() ? DescribeRegion(sizing.region, "region of interest", region) : error;
}

FloatImage::Pointer
ComputeSizingImage(const IndicatorInputs & inputs, const SizingInputs & sizing, Monitor & monitor)
{
  const IndicatorImages images(inputs.images);
  const GridGeometry &  geometry = images.GetGeometry();
  const IndicatorSet    indicators = images.MakeIndicatorSet();
  const auto            sizes = ComputeSizing(indicators,
                                   inputs.exterior,
                                   ToGridUnit(sizing.options, geometry),
                                   MakeControl(inputs, sizing, geometry, indicators),
                                   monitor);
  const auto            image = FloatImage::New();
  image->CopyInformation(inputs.images.front());
  image->SetRegions(geometry.GetRegion());
  image->Allocate();
  std::transform(sizes.begin(), sizes.end(), image->GetBufferPointer(), [&](float size) {
    return static_cast<float>(size * geometry.GetUnit());
  });
  return image;
}

FloatImage::Pointer
ComputeSizingImage(itk::ProcessObject * filter, const IndicatorInputs & indicators, const SizingInputs & sizing)
{
  FloatImage::Pointer image;
  RunStage(filter, "sizing", [&](FilterMonitor & monitor) { image = ComputeSizingImage(indicators, sizing, monitor); });
  return image;
}
} // namespace mmm
