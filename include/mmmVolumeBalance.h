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
#ifndef mmmVolumeBalance_h
#define mmmVolumeBalance_h

#include "mmmIndicatorSet.h"
#include "mmmMeshOptimizer.h"
#include "mmmTetrahedralComplex.h"

namespace mmm
{
class InterfaceConstraint;

/** \brief Moves the points of curved surfaces off their cell, so that the flat triangles between them lie on both sides
 * of the zero set in equal parts.
 *
 * With all corners on it, convex materials lose volume: 5 % for a ball of six voxels' radius. The constraint gives, for
 * the first points, the cell that each lies on. No tetrahedron is inverted; `exterior` ones may be part of the complex,
 * which has to be compact. */
void
BalanceVolumes(const IndicatorSet &           indicators,
               const InterfaceConstraint &    constraint,
               Material                       exterior,
               const OptimizationParameters & parameters,
               const TetrahedralComplex &     complex,
               std::vector<Vector> &          points);
} // namespace mmm

#endif
