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
#ifndef LabelCheck_h
#define LabelCheck_h

#include "ImageInput.h"
#include "Settings.h"
#include "itkLabelImageStages.h"

#include <optional>
#include <string>

namespace cli
{
/** \brief The labels of an image and their numbers of voxels.
 *
 * Throws Error if it does not look like a label image: one value only, or very many, or values that change from voxel
 * to voxel. */
mmm::LabelCounts
CheckLabels(const std::string & fileName, const LabelImage & image);

/** \brief The label of the exterior where it is meshed; none if it is not, or if there is none to mesh. */
std::optional<int>
LabelOfAir(const Settings & settings, const mmm::LabelCounts & voxels);
} // namespace cli

#endif
