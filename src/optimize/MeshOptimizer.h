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
#include "optimize/TetrahedralComplex.h"

namespace mmm
{
class InterfaceConstraint;

struct OptimizationParameters
{
  /** Tetrahedra with a dihedral angle below this, in degrees, are poor: all is done to improve them, on interfaces too.
   * Large angles count alike: quality falls off at both ends. */
  double poorAngle{ 26.0 };
  /** Below this, edges and faces within a material are flipped. */
  double flipAngle{ 32.0 };
  /** Triangles of interfaces with a radius ratio below this are poor. */
  double poorTriangle{ 0.87 };
  /** Points of triangles below this radius ratio move for the sake of the worst triangle around them alone. */
  double lowTriangle{ 0.77 };
  /** Below this, they leave their cells for it, within the tolerance, one by one or together. */
  double flatTriangle{ 0.4 };
  /** Where all tetrahedra around a point have larger dihedral angles than this, in degrees, the worst may lose a little
   * when the point moves; and down to the second one when an edge or a point changes for the sake of triangles, or when
   * a point returns to its cell. */
  double angleToKeep{ 30.0 };
  double angleToKeepBesideTriangles{ 15.0 };
  /** How much the average radius ratio of tetrahedra counts when points move; 0 leaves it to that of triangles. */
  double tetrahedronWeight{ 1.0 };
  /** Rounds of local changes and smoothing; fewer if nothing is changed any more. */
  int rounds{ 6 };
  /** An interface may leave the zero set by this much, in units of the smallest voxel spacing. */
  double interfaceTolerance{ 0.25 };
};

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
