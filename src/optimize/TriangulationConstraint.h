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
#ifndef mmmTriangulationConstraint_h
#define mmmTriangulationConstraint_h

#include "optimize/InterfaceConstraint.h"
#include "optimize/OptimizationParameters.h"
#include "mesh/InterfaceMesh.h"
#include "optimize/SmoothPatches.h"
#include "distance/TriangleTree.h"

#include <memory>

namespace mmm
{
/** \brief Points stay on the interfaces that a mesh has at first.
 *
 * Points slide on the triangles around them up to the next crease, and along creases and junctions of three materials;
 * other points of interfaces do not move. Triangles and edges are taken as chords of what is curved: a point between
 * their corners lies off them as the normals there say (Phong tessellation), by the tolerance at most. Without that,
 * what is convex would shrink. A crease is an edge where the normals differ by more than `featureAngle`, in degrees.
 *
 * Distances to interfaces are in units of the tolerance there. */
class TriangulationConstraint : public InterfaceConstraint
{
public:
  /** Materials are below `outside`, which stands for what is beyond the mesh. The tolerance is automatic if it is not a
   * number. */
  TriangulationConstraint(const std::vector<Vector> & points,
                          const TetrahedralMesh &     mesh,
                          Material                    outside,
                          double                      tolerance,
                          double                      featureAngle);

  Material
  MaterialOf(Material m) const override
  {
    return m <= m_Outside ? m : Material(m - m_Outside - 1);
  }
  bool
  Project(PointId p, Vector & x) const override;
  bool
  MayLeaveCell(PointId p) const override;
  Vector
  AlongCell(PointId p, const Vector & x, const Vector & direction) const override;
  double
  DistanceToInterface(Material a, Material b, const Vector & x, PointId corner) const override;

  double
  LargestTolerance() const
  {
    return m_LargestTolerance;
  }

private:
  /** Where a point on a surface or a curve was at first, the normal or the tangent there, the patch of triangles or the
   * curve that it slides on, and how far. */
  struct Home
  {
    Vector        place{ Vector::Zero() };
    Vector        direction{ Vector::Zero() };
    std::uint32_t part{ 0 };
    double        reach{ 0.0 };
  };

  /** The crease of a material: a pseudo-material that stands for it. */
  Material
  CreaseOf(Material m) const
  {
    return Material(m_Outside + 1 + m);
  }
  void
  MeasureTriangles();
  void
  GiveCells(const TetrahedralMesh & mesh);
  void
  ClassifyPoints();
  void
  FindCornerNormals(const std::uint32_t * begin, const std::uint32_t * end, PointId p);
  bool
  IsSurrounded(PointId p, const std::uint32_t * begin, const std::uint32_t * end) const;
  void
  FindCurves();
  void
  Fix(PointId p);
  Vector
  OnCurvedTriangle(std::uint32_t triangle, const Vector & x) const;
  Vector
  OnCurvedSeam(std::uint32_t seam, const Vector & x) const;
  double
  ToleranceAt(double edgeLength) const;

  const Material            m_Outside;
  const double              m_Tolerance;
  const double              m_LeastCosine;
  double                    m_LargestTolerance{ 0.0 };
  const std::vector<Vector> m_Points;
  InterfaceMesh             m_Interfaces;
  SmoothPatches             m_Patches;
  /** At the corners of each triangle, those of its patch. */
  std::vector<std::array<Vector, 3>> m_CornerNormals;
  /** Of triangles. */
  std::vector<double>           m_Tolerances;
  std::vector<std::uint32_t>    m_Curves;
  std::vector<Home>             m_Homes;
  std::unique_ptr<TriangleTree> m_TriangleTree;
  std::unique_ptr<TriangleTree> m_SeamTree;
};
} // namespace mmm

#endif
