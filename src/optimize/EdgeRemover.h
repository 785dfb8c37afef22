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
#ifndef mmmEdgeRemover_h
#define mmmEdgeRemover_h

#include "optimize/ComplexChange.h"
#include "optimize/OptimizerState.h"

namespace mmm
{
/** \brief Finds edges and faces to take out of the mesh, and the tetrahedra that come in the place of those around
 * them.
 *
 * An edge of an interface of two materials is flipped: the surface has the other diagonal then. */
class EdgeRemover
{
public:
  explicit EdgeRemover(const OptimizerState & state)
    : m_State(state)
  {}

  /** Whether taking the edge ab of tetrahedron t out makes the worst tetrahedron around it better. */
  bool
  FindForEdge(OptimizerState::Id t, PointId a, PointId b, ComplexChange & change);
  /** Whether flipping the edge ab of an interface makes the worse one of its two triangles better. */
  bool
  FindForTriangles(OptimizerState::Id t, PointId a, PointId b, ComplexChange & change);
  /** Whether any edge or face of a tetrahedron is to be taken out. */
  bool
  FindAny(OptimizerState::Id t, ComplexChange & change);

private:
  /** Takes a face out: two tetrahedra of one material become three around a new edge. */
  bool
  FindForFace(OptimizerState::Id t, int face, ComplexChange & change) const;
  bool
  ReplaceRing(PointId a, PointId b, double enough, double floor, ComplexChange & change);
  double
  TriangulateLink(const std::vector<PointId> & polygon,
                  PointId                      a,
                  PointId                      b,
                  Material                     material,
                  double                       enough,
                  std::vector<Triangle> &      triangles) const;
  bool
  AreNeighbours(PointId p, PointId q);
  bool
  MayFlip(PointId a, PointId b, PointId c, PointId d, Material one, Material two, double floor) const;

  const OptimizerState &          m_State;
  TetrahedralComplex::Ring        m_Ring;
  std::vector<OptimizerState::Id> m_Star;
};
} // namespace mmm

#endif
