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
#ifndef mmmInterfaceFit_h
#define mmmInterfaceFit_h

#include "indicators/IndicatorSet.h"
#include "optimize/OptimizationParameters.h"
#include "base/Monitor.h"
#include "optimize/TetrahedralComplex.h"

namespace mmm
{
class InterfaceConstraint;

/** \brief Moves the points of interfaces off their cells so that the flat triangles between them stand for the curved
 * zero sets as well as they can.
 *
 * First, those of surfaces move so that the triangles lie on both sides of the zero set in equal parts: with all
 * corners on it, convex materials lose volume, 5 % for a ball of six voxels' radius. Then points around voxel centres
 * that lie in a tetrahedron of another material than their own move so that these come to lie on their side: in thin
 * layers, triangles cut corners off. Points stay within the tolerance of their cells, or as near as they are.
 *
 * The constraint gives, for the first points, the cell that each lies on. Tetrahedra keep good angles, and triangles
 * good radius ratios; `exterior` ones may be part of the complex, which has to be compact. */
void
FitInterfaces(const IndicatorSet &           indicators,
              const InterfaceConstraint &    constraint,
              Material                       exterior,
              const OptimizationParameters & parameters,
              const TetrahedralComplex &     complex,
              std::vector<Vector> &          points,
              Monitor &                      monitor);
} // namespace mmm

#endif
