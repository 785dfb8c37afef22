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
#ifndef mmmSideChanger_h
#define mmmSideChanger_h

#include "optimize/EdgeCollapser.h"
#include "optimize/EdgeRemover.h"

namespace mmm
{
/** \brief Gives a bad tetrahedron that lies flat on an interface to the material on its other side.
 *
 * With two faces on the interface, these go over to the two others, as if an edge were flipped. With three, the point
 * that they share leaves the interface; with one, the opposite point joins it. The shape of the tetrahedron stays:
 * other operations can take it apart then, or it is a part of the exterior, where shape does not matter. A narrow gap,
 * an exterior tetrahedron between two faces that nearly touch, is filled and its mouth pulled together. */
class SideChanger
{
public:
  explicit SideChanger(OptimizerState & state)
    : m_State(state)
    , m_EdgeRemover(state)
    , m_EdgeCollapser(state)
  {}

  bool
  GiveToOtherSide(OptimizerState::Id t);

private:
  /** The faces of a tetrahedron that lie on an interface, the others behind them, and the one material beyond. */
  struct Faces
  {
    std::array<int, 4> numbers;
    int                onInterface;
    Material           beyond;
  };
  bool
  SortFaces(OptimizerState::Id t, Faces & faces) const;
  bool
  ChangeOneFace(OptimizerState::Id t, const Faces & faces);
  bool
  ChangeTwoFaces(OptimizerState::Id t, const Faces & faces);
  bool
  ChangeThreeFaces(OptimizerState::Id t, const Faces & faces);
  bool
  Give(OptimizerState::Id t, Material material);
  template <typename TFind>
  bool
  GiveAndChange(OptimizerState::Id t, Material material, const TFind & find);
  bool
  CloseGap(OptimizerState::Id t, PointId a, PointId b, Material material);
  bool
  AllAround(OptimizerState::Id t, PointId a, PointId b, Material first, Material second);

  OptimizerState &                m_State;
  EdgeRemover                     m_EdgeRemover;
  EdgeCollapser                   m_EdgeCollapser;
  TetrahedralComplex::Ring        m_Ring;
  std::vector<OptimizerState::Id> m_Star;
};
} // namespace mmm

#endif
