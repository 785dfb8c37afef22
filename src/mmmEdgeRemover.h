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

#include "mmmOptimizerState.h"

namespace mmm
{
/** \brief Takes edges and faces out of the mesh by replacing the tetrahedra around them.
 *
 * An edge of an interface of two materials is flipped: the surface has the other diagonal then. */
class EdgeRemover
{
public:
  explicit EdgeRemover(OptimizerState & state)
    : m_State(state)
  {}

  /** Takes the edge ab of tetrahedron t out, if that makes the worst tetrahedron around it better. */
  bool
  RemoveEdge(OptimizerState::Id t, PointId a, PointId b);
  /** Flips the edge ab of an interface if that makes the worse one of its two triangles better. */
  bool
  FlipForTriangles(OptimizerState::Id t, PointId a, PointId b);
  /** Takes a face out: two tetrahedra of one material become three around a new edge. */
  bool
  RemoveFace(OptimizerState::Id t, int face);
  /** Takes any edge or face of a tetrahedron out. */
  bool
  RemoveAny(OptimizerState::Id t);

private:
  static constexpr int LongestRing = 9;

  bool
  ReplaceRing(PointId a, PointId b, double enough, double floor);
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

  OptimizerState &                m_State;
  TetrahedralComplex::Ring        m_Ring;
  std::vector<OptimizerState::Id> m_Star;
  std::vector<OptimizerState::Id> m_Ids;
};
} // namespace mmm

#endif
