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
#ifndef mmmIndicatorSmoothing_h
#define mmmIndicatorSmoothing_h

#include "image/MaterialImage.h"
#include "indicators/IndicatorSet.h"

namespace mmm
{
/** Whether a voxel belongs to no 2 x 2 x 2 block of its material. Labels are continued beyond the border. */
bool
IsThin(const MaterialImage & image, const Index & at);

/** How far interfaces have to stay from the centre of a voxel, in units of the smallest voxel spacing. A tip has at
 * most one neighbour of its material across a face. */
float
CentreMarginOf(const MaterialImage & image, const Index & at);

/** The smallest box of grid nodes that holds a material; size 0 where the image has none of it. */
struct MaterialBox
{
  Index lower{ { 0, 0, 0 } };
  Index size{ { 0, 0, 0 } };
};

std::vector<MaterialBox>
ComputeMaterialBoxes(const MaterialImage & image);

/** The nodes that the indicator of a material covers: the material's box and the band around it, as far as the grid
 * goes. */
MaterialBox
ComputeIndicatorBox(const Grid & grid, const MaterialBox & box);

/** \brief The smooth indicator function of one material: a signed distance, positive inside, of the smoothed material.
 *
 * 1. The signed distance whose zero level lies on the voxel faces.
 * 2. Anti-aliasing (Whitaker 2000): mean curvature flow under the condition that every voxel centre keeps its side.
 * 3. Tightening of radius `radius` (Williams and Rossignac 2005): within the mortar, which is what closing by a ball of
 *    that radius adds and opening takes away, the boundary moves by mean curvature to the shortest one.
 * 4. The signed distance of what results.
 *
 * Radius 0 stops after step 1. Values are cut off at +-IndicatorBandWidth. The block covers the material's box and the
 * band around it, as far as the image goes; beyond the block the material's value is -IndicatorBandWidth. */
Block<float>
ComputeSmoothIndicator(const MaterialImage & image, Material material, const MaterialBox & box, double radius);

/** Of such blocks, one a material. */
IndicatorSet
MakeIndicatorSet(const Grid & grid, const std::vector<Block<float>> & blocks);
} // namespace mmm

#endif
