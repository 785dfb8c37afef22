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
#ifndef mmmEdgeCollapser_h
#define mmmEdgeCollapser_h

#include "optimize/ComplexChange.h"
#include "optimize/OptimizerState.h"

namespace mmm
{
/** \brief Finds edges of which one end may be pulled into the other. */
class EdgeCollapser
{
public:
  explicit EdgeCollapser(const OptimizerState & state)
    : m_State(state)
  {}

  /** Whether any corner of a tetrahedron may be pulled into another one, so that the worst tetrahedron around it gets
   * better. A point of the interior may go anywhere; one of a surface or a curve along it, by the link condition. */
  bool
  FindAny(OptimizerState::Id t, ComplexChange & change);
  /** Whether any of some corners of a tetrahedron, which lie on an interface, may be pulled into another of them, so
   * that all triangles of interfaces around it get better than a radius ratio. New tetrahedra are better than
   * `quality`, and no worse than may be for the sake of triangles. */
  bool
  FindForTriangles(OptimizerState::Id           t,
                   const std::vector<PointId> & corners,
                   double                       radiusRatio,
                   double                       quality,
                   ComplexChange &              change);
  /** Whether corner u of a tetrahedron may be pulled into corner v, so that new tetrahedra are better than `quality`
   * and new triangles of interfaces have radius ratios of `radiusRatio`, or as they are if that is less. */
  bool
  FindForEdge(OptimizerState::Id t, PointId u, PointId v, double radiusRatio, double quality, ComplexChange & change);

private:
  /** A triangle of an interface at some point, by its other corners, and the materials beside it. */
  struct FanTriangle
  {
    PointId  b;
    PointId  c;
    Material own;
    Material beyond;
  };

  bool
  LookAround(PointId u);
  bool
  MayCollapse(OptimizerState::Id t, PointId u, PointId v, double floor);
  bool
  CollapseStar(OptimizerState::Id t, PointId u, PointId v, double enough, ComplexChange & change);
  std::size_t
  CountMaterialsAround(PointId u) const;
  bool
  LinksMeetInRing(OptimizerState::Id t, PointId u, PointId v);
  bool
  IsOnCellOf(PointId u, PointId v) const;
  bool
  MayBeOnCellOf(PointId u, PointId v) const;
  std::vector<FanTriangle>
  FanOf(PointId p, const std::vector<OptimizerState::Id> & star) const;
  static std::vector<PointId>
  EndsOf(const std::vector<FanTriangle> & fan, bool onCurves);
  bool
  MayCollapseOnInterface(OptimizerState::Id t, PointId u, PointId v, double floor);

  const OptimizerState &   m_State;
  TetrahedralComplex::Ring m_Ring;
  /** What is around u: tetrahedra, materials, and triangles of interfaces. */
  std::vector<OptimizerState::Id> m_Star;
  std::size_t                     m_NumberOfMaterials{ 0 };
  std::vector<FanTriangle>        m_Fan;
  std::vector<OptimizerState::Id> m_OtherStar;
};
} // namespace mmm

#endif
