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
#ifndef mmmSizingImage_h
#define mmmSizingImage_h

#include "itk/GridGeometry.h"
#include "sizing/SizingControl.h"

#include "itkImageRegionConstIterator.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace mmm
{
/** The pixels of a sizing image in the grid's unit, a value per node of the grid. Throws itk::ExceptionObject where one
 * is not positive. The image covers the grid. */
template <typename TSizingImage>
std::vector<float>
ReadSizingImage(const TSizingImage * image, const GridGeometry & geometry)
{
  constexpr double largest = SizingControl::NoLimit; // infinity would spread as not-a-number

  std::vector<float>                          sizes;
  const auto &                                region = image->GetLargestPossibleRegion();
  itk::ImageRegionConstIterator<TSizingImage> it(image, region);
  sizes.reserve(region.GetNumberOfPixels());
  for (; !it.IsAtEnd(); ++it)
  {
    const auto size = static_cast<double>(it.Get());
    if (!(size > 0.0))
    {
      itkGenericExceptionMacro("The sizing image has the value " << size << " at " << it.GetIndex()
                                                                 << ". All its values must be positive.");
    }
    sizes.push_back(static_cast<float>(std::min(geometry.ToGridUnit(size), largest)));
  }
  return sizes;
}

/** Whether each pixel of a mask is not 0. */
template <typename TMaskImage>
std::vector<std::uint8_t>
ReadMask(const TMaskImage * image)
{
  std::vector<std::uint8_t>                 mask;
  const auto &                              region = image->GetLargestPossibleRegion();
  itk::ImageRegionConstIterator<TMaskImage> it(image, region);
  mask.reserve(region.GetNumberOfPixels());
  for (; !it.IsAtEnd(); ++it)
  {
    mask.push_back(it.Get() != 0);
  }
  return mask;
}
} // namespace mmm

#endif
