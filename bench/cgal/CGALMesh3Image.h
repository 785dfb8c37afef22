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
#ifndef CGALMesh3Image_h
#define CGALMesh3Image_h

#include "itkImage.h"

#include <CGAL/Image_3.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>

using LabelImage = itk::Image<std::int32_t, 3>;

template <typename TWord>
CGAL::Image_3
CopyToCGAL(const LabelImage & image)
{
  const auto & size = image.GetBufferedRegion().GetSize();
  const auto & spacing = image.GetSpacing();
  _image *     copy = _createImage(
    size[0], size[1], size[2], 1, spacing[0], spacing[1], spacing[2], sizeof(TWord), WK_FIXED, SGN_UNSIGNED);
  const auto * begin = image.GetBufferPointer();
  std::copy(begin, begin + image.GetBufferedRegion().GetNumberOfPixels(), static_cast<TWord *>(copy->data));
  return CGAL::Image_3(copy);
}

/** The voxels and their spacing: CGAL knows no direction, so the mesh is moved to its place afterwards. */
inline CGAL::Image_3
ToCGALImage(const LabelImage & image)
{
  const auto * begin = image.GetBufferPointer();
  const auto   range = std::minmax_element(begin, begin + image.GetBufferedRegion().GetNumberOfPixels());
  if (*range.first < 0 || *range.second > 65535)
  {
    throw std::range_error("labels must be from 0 to 65535");
  }
  return *range.second < 256 ? CopyToCGAL<std::uint8_t>(image) : CopyToCGAL<std::uint16_t>(image);
}

#endif
