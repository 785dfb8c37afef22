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
#ifndef mmmLocalRecovery_h
#define mmmLocalRecovery_h

#include "mesh/TetrahedralMesh.h"

#include <vector>

namespace mmm
{
/** \brief Tetrahedralizes anew around missing triangles, so that these are faces as well.
 *
 * Tetrahedra that touch the corners of a missing triangle, and those that touch them, are replaced by those of a
 * constrained tetrahedralization, which keeps their outer faces and the triangles between them. Points may be added at
 * the end. \throw TetGenFailure where that is not possible */
void
RecoverLocally(const std::vector<Triangle> & triangles,
               const std::vector<char> &     isMissing,
               std::vector<Vector> &         points,
               std::vector<Tetrahedron> &    tetrahedra);
} // namespace mmm

#endif
