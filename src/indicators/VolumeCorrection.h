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
#ifndef mmmVolumeCorrection_h
#define mmmVolumeCorrection_h

#include "image/MaterialImage.h"

#include <vector>

namespace mmm
{
/** \brief Gives each connected part of each material the volume of its voxels, within half a percent.
 *
 * `indicators` are those of ComputeSmoothIndicator(), one a material. Smoothing takes from small parts, or gives to
 * them; here each part's indicator is offset, by as much as what all parts lack and the areas that they share ask for:
 * where two indicators are equal, the interface moves by half the difference of their offsets. The largest part takes
 * what is left over. Interfaces that move stay as far from voxel centres as those of smoothing. */
void
CorrectVolumes(const MaterialImage & image, std::vector<Block<float>> & indicators);
} // namespace mmm

#endif
