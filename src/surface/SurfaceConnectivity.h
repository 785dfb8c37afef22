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
#ifndef mmmSurfaceConnectivity_h
#define mmmSurfaceConnectivity_h

#include "mesh/InterfaceMesh.h"

namespace mmm
{
/** \brief The triangles of the interfaces, with neighbours within each sheet, for flips of their edges.
 *
 * A sheet is the interface of two materials. At a junction several sheets end; a point there counts once in each. */
class SurfaceConnectivity
{
public:
  SurfaceConnectivity(const InterfaceMesh & interfaces, const std::vector<Vector> & points);

  const std::vector<Triangle> &
  Triangles() const
  {
    return m_Triangles;
  }

  /** Flips edges where that brings the numbers of triangles around points closer to those of equilateral ones: six,
   * fewer at the rim of a sheet. Returns the number of flips. */
  std::size_t
  EqualizeValences(const std::vector<Vector> & points);

private:
  using Id = std::uint32_t;
  static constexpr Id None = 0xffffffffu;

  void
  FindNeighbours(const std::vector<std::array<Material, 2>> & sides);
  void
  NumberSheetPoints(const std::vector<std::array<Material, 2>> & sides);
  void
  CountValences(const std::vector<Vector> & points);
  bool
  FlipForValence(Id t, int corner, const std::vector<Vector> & points);
  bool
  AreNeighbours(Id t, int corner, PointId other) const;
  int
  CornerAcross(Id t, Id neighbour) const;
  void
  Relink(Id t, Id from, Id to);

  std::vector<Triangle> m_Triangles;
  /** The triangle across the edge opposite each corner, or None at the rim of a sheet. */
  std::vector<std::array<Id, 3>> m_Neighbours;
  /** The point of each corner as a point of its sheet. */
  std::vector<std::array<Id, 3>> m_SheetPoints;
  /** By how many triangles each point of a sheet has too many. */
  std::vector<int> m_Excess;
};
} // namespace mmm

#endif
