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
#ifndef IndicatorInput_h
#define IndicatorInput_h

#include "ImageInput.h"
#include "Settings.h"
#include "itkLabelImageStages.h"

#include <vector>

namespace cli
{
/** \brief The images of --indicators and the labels that they give to the voxels. */
struct IndicatorInput
{
  std::vector<ScalarImage::Pointer> images;
  LabelImage::Pointer               labels;
};

/** \brief Reads the images. Throws an exception if they cannot be meshed together. */
IndicatorInput
ReadIndicators(const Settings & settings);

/** Images that are the largest nowhere. */
void
WarnOfAbsentIndicators(const Settings & settings, const mmm::LabelCounts & voxels);
} // namespace cli

#endif
