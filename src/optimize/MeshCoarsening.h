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
#ifndef mmmMeshCoarsening_h
#define mmmMeshCoarsening_h

#include "optimize/MeshOptimizer.h"

#include <functional>

namespace mmm
{
/** How many tetrahedra a mesh has that are not of a material. */
std::size_t
CountTetrahedra(const TetrahedralComplex & complex, Material exterior);

/** \brief Pulls edges together, the shortest first, until a mesh has no more tetrahedra than are wanted.
 *
 * Lengths are judged by the size that is asked for at their middle, so that the mesh keeps its gradation. Each collapse
 * keeps the topology of all interfaces, as those of OptimizeMesh() do: no label is lost, and none is cut or joined. The
 * exterior's tetrahedra do not count. Where what is left has only edges that shape, interfaces or topology keep, there
 * stay more than wanted. Takes an optimized mesh, and leaves one; the complex has to be compact, and is again
 * afterwards. What is done is added to the report. */
void
CoarsenMesh(const InterfaceConstraint &                     constraint,
            Material                                        exterior,
            const OptimizationParameters &                  parameters,
            const std::function<double(const Vector & x)> & size,
            std::size_t                                     wanted,
            std::vector<Vector> &                           points,
            TetrahedralComplex &                            complex,
            OptimizationReport &                            report,
            Monitor &                                       monitor);
} // namespace mmm

#endif
