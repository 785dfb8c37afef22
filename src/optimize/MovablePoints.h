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
#ifndef mmmMovablePoints_h
#define mmmMovablePoints_h

#include "mesh/Incidence.h"
#include "optimize/InterfaceConstraint.h"
#include "optimize/OptimizationParameters.h"
#include "optimize/TetrahedralComplex.h"

#include <array>
#include <cstdint>
#include <functional>

namespace mmm
{
/** \brief Points of a fixed connectivity: where each may go, and what that does to what is around it.
 *
 * The connectivity has to be compact. Points that share no tetrahedron are moved side by side. */
class MovablePoints
{
public:
  /** A point moves freely in space, within its cell, or not at all; one at which other materials meet than its cell
   * says moves near their interfaces, and only where triangles or tetrahedra are very poor. */
  enum class Freedom : std::uint8_t
  {
    Fixed,
    NearInterfaces,
    OnCell,
    Free
  };

  MovablePoints(const InterfaceConstraint &    constraint,
                Material                       exterior,
                const OptimizationParameters & parameters,
                std::vector<Vector> &          points,
                const TetrahedralComplex &     complex);

protected:
  /** Calls tryStep(length, direction) for lengths from `longest`, halved down to `shortest`, along the axes and the
   * diagonals each. Returns whether one of the calls did. */
  template <typename TTry>
  static bool
  SearchAround(double longest, double shortest, const TTry & tryStep)
  {
    bool moved = false;
    for (double length = longest; length > shortest; length *= 0.5)
    {
      for (int d = 0; d < SearchDirections; ++d)
      {
        moved |= tryStep(length, SearchDirection(d));
      }
    }
    return moved;
  }
  bool
  IsExterior(std::uint32_t t) const
  {
    return m_Materials[t] == m_Exterior;
  }
  /** The corners of a tetrahedron if p were at x. */
  std::array<const Vector *, 4>
  CornersWith(std::uint32_t t, PointId p, const Vector & x) const
  {
    std::array<const Vector *, 4> corners;
    for (int c = 0; c < 4; ++c)
    {
      const PointId corner = m_Tetrahedra[t][c];
      corners[c] = corner == p ? &x : &m_Points[corner];
    }
    return corners;
  }
  bool
  IsOnInterface(PointId p) const
  {
    return m_FanStart[p] != m_FanStart[p + 1];
  }
  /** The points that have one of the tetrahedra that are marked. */
  std::vector<char>
  MarkCorners(const std::vector<char> & tetrahedra) const;
  std::vector<Material>
  MaterialsAround(PointId p) const;
  double
  DistanceFromInterfaces(const std::vector<Material> & materials, PointId p, const Vector & x) const;
  /** Calls move(point) for all points that are not fixed; returns how many moved. */
  std::size_t
  MoveByColour(const std::function<bool(PointId)> & move);
  double
  WorstAround(PointId p, const Vector & x, double enough) const;
  bool
  StaysGood(PointId p, const Vector & x, double angle) const;
  double
  WorstTriangleAround(PointId p, const Vector & x) const;
  /** Brings a place for p to within `slack` of its cell, if p is on one; false where there is none nearby. */
  bool
  Admit(PointId p, Vector & x, double slack) const;
  bool
  MoveIfGood(PointId p, const Vector & x, double angle, double triangle);

  const InterfaceConstraint &      m_Constraint;
  const OptimizationParameters     m_Parameters;
  const Material                   m_Exterior;
  const std::vector<Cell> &        m_Cells;
  std::vector<Vector> &            m_Points;
  const TetrahedralComplex &       m_Complex;
  const std::vector<Tetrahedron> & m_Tetrahedra;
  const std::vector<Material> &    m_Materials;
  std::vector<Freedom>             m_Freedom;
  /** The tetrahedra at each point. */
  Incidence m_Star;
  /** The interface triangles at each point, by their other corners. */
  std::vector<std::uint32_t>          m_FanStart;
  std::vector<std::array<PointId, 2>> m_Fan;

private:
  /** The axes, then the diagonals. */
  static constexpr int SearchDirections = 14;
  static Vector
  SearchDirection(int number);
  void
  ClassifyPoints();
  void
  ColourPoints();

  std::vector<std::vector<PointId>> m_Colours;
};
} // namespace mmm

#endif
