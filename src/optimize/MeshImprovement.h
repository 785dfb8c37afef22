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
#ifndef mmmMeshImprovement_h
#define mmmMeshImprovement_h

#include "optimize/MeshOptimizer.h"

#include <limits>

namespace mmm
{
/** Each material needs a number for its creases. */
constexpr std::size_t MostMaterialsToImprove = 30000;

struct ImprovementParameters
{
  /** How far an interface may leave the place that it has at first, in the points' unit; automatic if it is not a
   * number: 0.07 of the edge length there. */
  double tolerance{ std::numeric_limits<double>::quiet_NaN() };
  /** Edges of interfaces at which the normals differ by more, in degrees, are creases, which stay. */
  double featureAngle{ 40.0 };
  int    rounds{ 10 };
};

/** \brief Improves a labelled mesh of which no more is known: interfaces stay where they are, within a tolerance.
 *
 * Materials are below `outside`, which stands for what is beyond the mesh. Tetrahedra are turned to positive
 * orientation first. Points that no tetrahedron uses, at first or any more, are dropped; all others keep their order.
 * Returns what was done; `parameters.tolerance` becomes the largest one that was used. */
OptimizationReport
ImproveMesh(Material                outside,
            ImprovementParameters & parameters,
            std::vector<Vector> &   points,
            TetrahedralMesh &       mesh,
            Monitor &               monitor);
} // namespace mmm

#endif
