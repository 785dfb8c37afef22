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
#ifndef mmmInterfaceConstraint_h
#define mmmInterfaceConstraint_h

#include "indicators/Cell.h"
#include "mesh/TetrahedralMesh.h"

namespace mmm
{
/** \brief Where the points of interfaces may go: what the optimizer asks about them.
 *
 * The first points of the mesh have a cell that they stay on. Among a cell's materials may be pseudo-materials, such as
 * a border's plane or a crease, which stand for a material. */
class InterfaceConstraint
{
public:
  /** The distance to an interface that there is none of. */
  static constexpr double NoInterface = 1e30;

  virtual ~InterfaceConstraint() = default;

  const std::vector<Cell> &
  Cells() const
  {
    return m_Cells;
  }

  /** The material that one of a cell's materials stands for, itself as a rule. */
  virtual Material
  MaterialOf(Material m) const = 0;
  /** Brings a new place for a point to the point's cell; false where there is none nearby. */
  virtual bool
  Project(PointId p, Vector & x) const = 0;
  /** Whether a point may leave its cell, within the tolerance, for the sake of a nearly flat tetrahedron. */
  virtual bool
  MayLeaveCell(PointId p) const = 0;
  /** The part of a direction that a point at x can follow. */
  virtual Vector
  AlongCell(PointId p, const Vector & x, const Vector & direction) const = 0;
  /** How far the interface of two materials is from a point on it. `corner` is a point beside it. */
  virtual double
  DistanceToInterface(Material a, Material b, const Vector & x, PointId corner) const = 0;

protected:
  explicit InterfaceConstraint(std::vector<Cell> cells)
    : m_Cells(std::move(cells))
  {}
  std::vector<Cell> m_Cells;
};
} // namespace mmm

#endif
