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
#ifndef mmmOptimizerState_h
#define mmmOptimizerState_h

#include "MultiMaterialMeshingReports.h"
#include "optimize/ComplexChange.h"
#include "optimize/InterfaceConstraint.h"
#include "optimize/OptimizationParameters.h"
#include "optimize/TetrahedralComplex.h"

namespace mmm
{
/** What the optimizer's operations work on. The exterior's tetrahedra have no quality, but must not be inverted either:
 * so the outer interface is one like the others, and parts of the mesh cannot grow into each other. */
struct OptimizerState
{
  using Id = TetrahedralComplex::Id;
  using Element = TetrahedralComplex::Element;

  /** A floor that no triangle reaches. */
  static constexpr double Unreachable = 2.0;
  /** A new interface triangle's radius ratio is at least this, or that of the worst one that it replaces: the floor is
   * lower where it is to get rid of a tetrahedron of very low quality. */
  static double
  TriangleFloor(double quality);

  /** What the worst tetrahedron has to be better than after a change for the sake of triangles, where it is `before`
   * now: what is good may get a little worse. */
  double
  EnoughBesideTriangles(double before) const;

  const InterfaceConstraint &    constraint;
  const Material                 exterior;
  const OptimizationParameters & parameters;
  const std::vector<Vector> &    points;
  TetrahedralComplex &           complex;
  OptimizationReport &           report;

  /** Makes a change, and counts it. */
  void
  Make(const ComplexChange & change);

  bool
  IsExterior(Id t) const
  {
    return complex.MaterialOf(t) == exterior;
  }
  /** The quality that a tetrahedron would have if it were not exterior. */
  double
  Shape(Id t) const;
  double
  Quality(const Tetrahedron & corners, Material material) const;
  double
  Quality(Id t) const
  {
    return this->Quality(complex.Corners(t), complex.MaterialOf(t));
  }
  double
  WorstOf(const std::vector<Id> & tetrahedra) const;

  double
  DistanceToInterface(Material a, Material b, const Vector & x, PointId corner) const
  {
    return constraint.DistanceToInterface(a, b, x, corner);
  }
};
} // namespace mmm

#endif
