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
#ifndef mmmVTUPixels_h
#define mmmVTUPixels_h

#include "io/vtu/VTUArrayDecoder.h"
#include "io/vtu/VTUArrayEncoder.h"
#include "io/vtu/VTUDocument.h"

#include "itkCommonEnums.h"

#include <cstddef>
#include <istream>
#include <string>
#include <vector>

namespace mmm
{
/** One pixel per point or cell, component by component. */
struct VTUPixels
{
  VTUValues   values;
  std::size_t numberOfComponents{ 0 };
};

/** The arrays that make up the pixel: those with all these names; else, if there is a prefix, prefix_a, prefix_b, ...
 * as far as they go, two at least; else the array named as the prefix; else the first one. Empty if there is none.
 * Arrays are joined only if all are scalar and of one type. */
std::vector<VTUArray>
SelectPixelArrays(const std::vector<VTUArray> &    arrays,
                  const std::vector<std::string> & names,
                  const std::string &              prefix);

VTUPixels
ReadVTUPixels(std::istream &                file,
              const VTUDocument &           document,
              const std::vector<VTUArray> & arrays,
              std::uint64_t                 numberOfPixels);

/** Writes the pixels as `<DataArray>` elements: one per component if there is a name for each, else a single one. */
std::string
EncodeVTUPixels(const void *                     buffer,
                itk::IOComponentEnum             type,
                std::size_t                      numberOfPixels,
                std::size_t                      numberOfComponents,
                const std::vector<std::string> & names,
                VTUEncoding                      encoding);
} // namespace mmm

#endif
