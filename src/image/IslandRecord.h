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
#ifndef mmmIslandRecord_h
#define mmmIslandRecord_h

#include <cstddef>
#include <map>

namespace mmm
{
/** What became of the voxels of a label when islands were merged. */
struct IslandRecord
{
  /** Components that went to other labels, and how many voxels they had. */
  std::size_t components{ 0 };
  std::size_t voxels{ 0 };
  /** Where those voxels went: voxels by label. */
  std::map<int, std::size_t> destinations;
  /** Voxels of the label in the input and in the output. */
  std::size_t voxelsBefore{ 0 };
  std::size_t voxelsAfter{ 0 };
};
} // namespace mmm

#endif
