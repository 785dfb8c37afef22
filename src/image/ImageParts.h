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
#ifndef mmmImageParts_h
#define mmmImageParts_h

#include "image/MaterialImage.h"

#include <cstdint>
#include <vector>

namespace mmm
{
/** Voxels of one material that are connected by faces. */
struct ImagePart
{
  Material    material{ 0 };
  std::size_t voxels{ 0 };
};

/** \brief The connected parts of all materials, in the order of their first voxels. */
struct ImageParts
{
  std::vector<ImagePart>     parts;
  std::vector<std::uint32_t> numbers; // per voxel its part
};

ImageParts
FindImageParts(const MaterialImage & image);
} // namespace mmm

#endif
