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
#ifndef mmmEdgeCurving_h
#define mmmEdgeCurving_h

#include "MultiMaterialMeshingReports.h"
#include "base/Monitor.h"
#include "indicators/IndicatorSet.h"
#include "mesh/CurvedEdges.h"
#include "mesh/InterfaceMesh.h"

namespace mmm
{
/** \brief Gives the edges of a mesh's interfaces mid-nodes that lie on the interfaces too, for a second-order mesh.
 *
 * An edge of a surface gets the point of the surface that is the nearest to its middle, an edge where three materials
 * meet that of their curve. On the faces of the image's box, edges of a surface stay in the face, and all others are
 * straight. An edge is straight as well where there is no such point close to its middle, where more materials meet,
 * and where a tetrahedron beside it would be turned inside out or nearly so: where the lower bound of its Jacobian is
 * below EdgeCurvingParameters::LeastJacobian.
 *
 * `mesh` is without the exterior, whose shape does not matter: interfaces on both sides of a gap keep apart because
 * those of the indicators do. It may be empty: then there is nothing to keep valid. The report is in the frame of Grid,
 * its labels are numbers of materials. */
CurvedEdges
CurveEdges(const IndicatorSet &        indicators,
           Material                    exterior,
           const TetrahedralMesh &     mesh,
           const InterfaceMesh &       interfaces,
           const std::vector<Vector> & points,
           Monitor &                   monitor,
           CurvingReport &             report);

/** The part of CurveEdges() that keeps tetrahedra valid: leaves out of `edges`, which are sorted, as few as it can of
 * those that turn a tetrahedron inside out, or nearly. Returns how many. */
std::size_t
StraightenInvertingEdges(const std::vector<Tetrahedron> & tetrahedra,
                         const std::vector<Vector> &      points,
                         CurvedEdges &                    edges);
} // namespace mmm

#endif
