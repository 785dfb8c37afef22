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
#ifndef mmmMedialAxis_h
#define mmmMedialAxis_h

#include "sizing/InterfaceSamples.h"

namespace mmm
{
/** \brief Points of the medial axes of all materials, found by foot points.
 *
 * A point belongs to the axis of the material it lies in if it has two feet, closest points of that material's
 * boundary, which lie apart and are seen under a wide angle (90 degrees). Two searches find them:
 *
 * - on the grid: neighbouring nodes at least a voxel inside, whose feet are more than 1.5 voxels apart (under 120
 *   degrees for neighbours across a diagonal);
 * - along the normals, where a layer is thinner than 3 voxels: from each interface sample across the material to the
 *   interface on the other side; the axis point lies halfway.
 *
 * The feet are sub-voxel points: samples, moved in the tangential plane of their interface. The axis point is the
 * centre of the ball that touches the interfaces there.
 *
 * Every convex wedge's axis runs into the junction that it ends on, and would pull the local feature size to zero
 * there: feet on two interfaces that meet within 2.5 voxels in a junction of those three materials do not count. */
std::vector<Vector>
ComputeMedialAxis(const IndicatorSet & indicators, const std::vector<InterfaceSample> & samples);
} // namespace mmm

#endif
