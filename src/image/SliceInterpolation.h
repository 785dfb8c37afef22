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
#ifndef mmmSliceInterpolation_h
#define mmmSliceInterpolation_h

#include "image/MaterialImage.h"

namespace mmm
{
/** \brief Divides the slices of an image into thinner ones, with shapes that change evenly from slice to slice, see
 * SliceGap.
 *
 * Slices lie across an axis, and each becomes `parts` of them. The image stays in its box: beyond the middles of the
 * first and the last slice, nothing changes. A middle of a thinner slice that is one of a slice has its materials. */
MaterialImage
InterpolateSlices(const MaterialImage & image, int axis, int parts);
} // namespace mmm

#endif
