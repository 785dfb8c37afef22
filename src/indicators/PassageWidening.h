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
#ifndef mmmPassageWidening_h
#define mmmPassageWidening_h

#include "base/Grid.h"

#include <vector>

namespace mmm
{
/** \brief Makes what is narrow in the argmax partition of the indicators wide enough to be meshed as it is, or closes
 * it.
 *
 * Where voxels of a material touch in an edge or a corner only, the indicators are all but equal: whether there is a
 * passage is chance, and no mesh resolves it. The partition is sampled at two samples a voxel and axis.
 *
 * - A sample whose material could not yield to the second one without a change of topology, and leads by less than half
 *   a voxel, gets that lead: its material's indicator is raised at the nodes around it. That makes a passage half a
 *   voxel wide.
 * - Where two neighbouring samples of different materials interrupt a third one, whose indicator is less than half a
 *   voxel lower between them, the third one is raised and comes between them: small holes in thin sheets close. With
 *   `keepContacts`, those become half a voxel wide instead at which voxels of the two materials share a face; they take
 *   small triangles. With `keepContacts`, what is narrow between samples is found, too, by its middle, see
 *   FindCriticalPoint(): the material that leads there gets half a voxel's lead at least.
 *
 * `indicators` are blocks of the grid, one a material. Each node keeps its material. */
void
WidenPassages(const Grid & grid, bool keepContacts, std::vector<Block<float>> & indicators);
} // namespace mmm

#endif
