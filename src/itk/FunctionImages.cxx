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
#include "itk/FunctionImages.h"

#include "indicators/FunctionIndicators.h"
#include "itk/Labels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mmm
{
namespace
{
bool
IsIn(const std::vector<int> & labels, int label)
{
  return std::find(labels.begin(), labels.end(), label) != labels.end();
}

/** The values of functions, and of the exterior if it is what they leave. */
struct Functions
{
  Functions(const IndicatorInputs & inputs, const std::vector<int> & exteriorLabels)
    : labels(inputs.labels)
  {
    for (const FloatImage * image : inputs.images)
    {
      values.push_back(image->GetBufferPointer());
    }
    if (!exteriorLabels.empty() &&
        std::none_of(labels.begin(), labels.end(), [&](int label) { return IsIn(exteriorLabels, label); }))
    {
      remainder = ComputeRemainder(values, inputs.images[0]->GetBufferedRegion().GetNumberOfPixels());
      labels.push_back(exteriorLabels.front());
      values.push_back(remainder.data());
    }
  }

  std::vector<int>           labels;
  std::vector<const float *> values;
  std::vector<float>         remainder;
};

/** Throws if the values cannot be those of an indicator. */
void
VerifyValues(const FloatImage * image, const std::string & name)
{
  const float * values = image->GetBufferPointer();
  const auto    end = values + image->GetBufferedRegion().GetNumberOfPixels();
  const auto    odd = std::find_if(values, end, [](float value) { return !std::isfinite(value); });
  if (odd != end)
  {
    itkGenericExceptionMacro(<< name << " has the value " << *odd << " at the index "
                             << image->ComputeIndex(odd - values) << ". All values must be finite numbers.");
  }
  if (std::all_of(values, end, [values](float value) { return value == *values; }))
  {
    itkGenericExceptionMacro(<< name << " has the value " << *values
                             << " everywhere. It must be larger inside its material than outside.");
  }
}
} // namespace

std::vector<int>
LargestFunctions(const IndicatorInputs &          inputs,
                 const std::vector<int> &         exteriorLabels,
                 const std::vector<std::string> & names)
{
  for (std::size_t n = 0; n < inputs.images.size(); ++n)
  {
    VerifyValues(inputs.images[n], names[n]);
  }
  const auto         voxels = inputs.images[0]->GetBufferedRegion().GetNumberOfPixels();
  const Functions    functions(inputs, exteriorLabels);
  std::vector<float> largest(voxels, std::numeric_limits<float>::lowest());
  std::vector<int>   labels(voxels);
  // where values are equal, exterior comes first
  for (const bool exterior : { true, false })
  {
    for (std::size_t n = 0; n < functions.values.size(); ++n)
    {
      if (IsIn(exteriorLabels, functions.labels[n]) == exterior)
      {
        const float * const values = functions.values[n];
        for (std::size_t v = 0; v < voxels; ++v)
        {
          if (values[v] > largest[v])
          {
            largest[v] = values[v];
            labels[v] = functions.labels[n];
          }
        }
      }
    }
  }
  return labels;
}

std::vector<FloatImage::Pointer>
ComputeFunctionIndicators(const IndicatorInputs &  inputs,
                          const std::vector<int> & exteriorLabels,
                          const std::vector<int> & present,
                          const LabelImage *       image,
                          Monitor &                monitor)
{
  const Functions                         functions(inputs, exteriorLabels);
  std::vector<std::vector<const float *>> ofMaterials(present.size());
  for (std::size_t n = 0; n < functions.values.size(); ++n)
  {
    const int  label = functions.labels[n];
    const bool isExterior = IsIn(exteriorLabels, label);
    const auto place = std::find_if(present.begin(), present.end(), [&](int other) {
      return other == label || (isExterior && IsIn(exteriorLabels, other));
    });
    if (place != present.end())
    {
      ofMaterials[place - present.begin()].push_back(functions.values[n]);
    }
  }

  const auto               materials = MakeMaterialImage(image, present);
  const auto               boxes = ComputeMaterialBoxes(materials);
  const FunctionIndicators indicators(materials, std::move(ofMaterials));

  std::vector<FloatImage::Pointer> images;
  for (std::size_t m = 0; m < present.size(); ++m)
  {
    const auto             block = indicators.Compute(static_cast<Material>(m), boxes[m]);
    const auto             indicator = FloatImage::New();
    FloatImage::RegionType region;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      region.SetIndex(axis, block.lower[axis]);
      region.SetSize(axis, static_cast<itk::SizeValueType>(block.size[axis]));
    }
    indicator->CopyInformation(image);
    indicator->SetRegions(region);
    indicator->Allocate();
    std::copy(block.values.begin(), block.values.end(), indicator->GetBufferPointer());
    images.push_back(indicator);
    monitor.Report(static_cast<double>(m + 1) / present.size());
  }
  return images;
}
} // namespace mmm
