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
#ifndef mmmThreads_h
#define mmmThreads_h

#include "image/Islands.h"

namespace mmm
{
/** \brief Takes the mark of an island from the parts of threads: of what is one voxel thin, and whose voxels meet
 * across edges and corners.
 *
 * Islands of a label that touch each other, in whatever way, belong together. They are a thread if they are
 * `minimumSize` voxels long, and thin. Of a label that is mostly thin, as it would lose more than a twentieth of its
 * voxels, they stay as well where they are long and not thin, or link larger parts. */
void
KeepThreads(const Index &                       size,
            const std::uint32_t *               numbers,
            const std::vector<LabelComponent> & components,
            std::size_t                         minimumSize,
            std::vector<char> &                 isIsland);
} // namespace mmm

#endif
