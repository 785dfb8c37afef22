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
#ifndef mmmMeshOptimizer_h
#define mmmMeshOptimizer_h

#include "MultiMaterialMeshingReports.h"
#include "base/Monitor.h"
#include "optimize/OptimizationParameters.h"
#include "optimize/TetrahedralComplex.h"

namespace mmm
{
class InterfaceConstraint;

/** \brief Improves the worst tetrahedra first: no change of the connectivity lowers the local worst quality.
 *
 * The quality of a tetrahedron is that of its extreme dihedral angles. All points move so that the radius ratios around
 * them grow on average, those of poor tetrahedra so that the worst one gets better. Points of the interior move freely;
 * points of an interface slide on their own cell by its projection. Edges are removed, on interfaces too (the surface's
 * edge is flipped) where the new one stays near the zero set; faces are flipped, edges collapsed, and a flat
 * tetrahedron on an interface goes to the other side. No step changes the topology of an interface.
 *
 * The constraint gives, for the first points of `points`, the cell that each lies on; all others are free. The complex
 * has to be compact, and is again afterwards. */
OptimizationReport
OptimizeMesh(const InterfaceConstraint &    constraint,
             Material                       exterior,
             const OptimizationParameters & parameters,
             std::vector<Vector> &          points,
             TetrahedralComplex &           complex,
             Monitor &                      monitor);
} // namespace mmm

#endif
