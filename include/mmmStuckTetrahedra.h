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
#ifndef mmmStuckTetrahedra_h
#define mmmStuckTetrahedra_h

#include "MultiMaterialMeshingExport.h"
#include "mmmIndicatorSet.h"
#include "mmmTetrahedronAdjacency.h"

namespace mmm
{
/** \brief The tetrahedra that are of another material than their centre, and that hold something together or apart.
 *
 * Tetrahedra go to the material that the indicators have at their centre one by one, as long as the materials around
 * their corners stay one part each, see FindLinkDefects(). Returns those that cannot, ascending: the thin sheets and
 * passages of the mesh that the indicators do not have. `exterior` is what is outside of the box. */
MultiMaterialMeshing_EXPORT std::vector<std::uint32_t>
                            FindStuckTetrahedra(const IndicatorSet &         indicators,
                                                const std::vector<Vector> &  points,
                                                const TetrahedronAdjacency & adjacency,
                                                Material                     exterior,
                                                TetrahedralMesh              mesh);
} // namespace mmm

#endif
