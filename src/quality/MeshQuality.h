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
#ifndef mmmMeshQuality_h
#define mmmMeshQuality_h

#include "MultiMaterialMeshingQuality.h"
#include "mesh/TetrahedronQuality.h"

#include <vector>

namespace mmm
{
/** \brief Measures a labelled tetrahedral mesh: shapes, interfaces and topology.
 *
 * The result is the same, to the last bit, for any number of threads.
 *
 * \throw std::invalid_argument if labels and tetrahedra differ in number, a tetrahedron has a point that does not exist
 * or a point is not finite (or beyond 1e50, where areas overflow). */
MeshQualityReport
ComputeMeshQuality(const std::vector<Vector> &      points,
                   const std::vector<Tetrahedron> & tetrahedra,
                   const std::vector<int> &         labels,
                   const MeshQualityOptions &       options = MeshQualityOptions());

} // namespace mmm

#endif
