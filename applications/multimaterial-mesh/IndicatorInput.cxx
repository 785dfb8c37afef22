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
#include "IndicatorInput.h"

#include "Warnings.h"
#include "itkIndicatorImagesToLabelImageFilter.h"

namespace cli
{
IndicatorInput
ReadIndicators(const Settings & settings)
{
  IndicatorInput input;
  const auto     filter = itk::IndicatorImagesToLabelImageFilter<ScalarImage, LabelImage>::New();
  for (const std::string & fileName : settings.indicators)
  {
    const auto image = ReadScalarImage(fileName);
    image->SetObjectName(fileName);
    filter->SetInput(static_cast<unsigned int>(input.images.size()), image);
    input.images.push_back(image);
  }
  filter->SetIndicatorLabels(settings.indicatorLabels);
  filter->SetExteriorLabels(settings.exterior);
  filter->Update();
  input.labels = filter->GetOutput();
  input.labels->DisconnectPipeline();
  return input;
}

void
WarnOfAbsentIndicators(const Settings & settings, const mmm::LabelCounts & voxels)
{
  for (std::size_t n = 0; n < settings.indicators.size(); ++n)
  {
    const int label = settings.indicatorLabels.empty() ? static_cast<int>(n + 1) : settings.indicatorLabels[n];
    if (voxels.count(label) == 0)
    {
      Warn(settings.indicators[n] + ": the image is the largest nowhere, so label " + std::to_string(label) +
           " is not in the mesh");
    }
  }
}
} // namespace cli
