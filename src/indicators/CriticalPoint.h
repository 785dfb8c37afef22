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
#ifndef mmmCriticalPoint_h
#define mmmCriticalPoint_h

#include "indicators/IndicatorSet.h"

namespace mmm
{
/** \brief Moves a point to a critical point of f_a - f_b near it, where the gradient vanishes: the middle of a passage,
 * of a gap or of a thin sheet. The topology of an interface changes at such points only.
 *
 * Newton's method; directions in which the difference hardly bends, as along a sheet, are left out. Returns false where
 * it does not converge within `reach` of the start, in voxels along each axis, where the difference is steep at the
 * start, as it is at interfaces with nothing near, and beyond the nodes at the border. */
bool
FindCriticalPoint(const IndicatorSet & indicators, Material a, Material b, double reach, Vector & x);
} // namespace mmm

#endif
