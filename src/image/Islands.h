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
#ifndef mmmIslands_h
#define mmmIslands_h

#include "base/Grid.h"

#include <cstdint>
#include <vector>

namespace mmm
{
/** A connected component of equal labels. */
struct LabelComponent
{
  int         label{ 0 };
  std::size_t voxels{ 0 };
};

/** \brief Decides which label each component gets when small ones are merged into their neighbours.
 *
 * `numbers` holds a component's number per voxel of an image of that size; numbers without voxels are allowed. A
 * component with fewer voxels than `minimumSize`, unless it is a part of a thread, see KeepThreads(), gets the label
 * that most of its voxels' faces touch, the lowest of equals. The largest component of a label keeps it, of equals the
 * one with the first voxel, and so does a component that touches no other label. */
std::vector<int>
MergeIslands(const Index &                       size,
             const std::uint32_t *               numbers,
             const std::vector<LabelComponent> & components,
             std::size_t                         minimumSize);
} // namespace mmm

#endif
