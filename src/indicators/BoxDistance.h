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
#ifndef mmmBoxDistance_h
#define mmmBoxDistance_h

#include "indicators/LevelSet.h"
#include "image/MaterialImage.h"

namespace mmm
{
/** Fills `levelSet` with the signed distance between a voxel centre and the nearest voxel *box* of the opposite kind:
 * positive in material `material`, zero on the voxel faces, exact up to the level set's width, where it is cut off.
 * Labels are continued beyond the image border. */
void
ComputeBoxDistance(const MaterialImage & image, Material material, LevelSet & levelSet);
} // namespace mmm

#endif
