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
#ifndef mmmMeshOptimizerSmoothing_h
#define mmmMeshOptimizerSmoothing_h

#include "mmmIncidence.h"
#include "mmmIndicatorSet.h"
#include "mmmInterfaceConstraint.h"
#include "mmmMeshOptimizer.h"
#include "mmmTetrahedralComplex.h"

#include <cstdint>
#include <functional>

namespace mmm
{
/** 1 for a regular tetrahedron, 0 for a flat one, negative for an inverted one; it falls off alike for small and large
 * dihedral angles. Among tetrahedra of equal angles, those that are poor by their radius ratio count by that. */
inline double
ShapeQuality(const Vector & a, const Vector & b, const Vector & c, const Vector & d)
{
  constexpr double                 RadiusRatioWeight = 0.5;
  const detail::TetrahedronNormals normals(a, b, c, d);
  if (!(normals.sixVolume > 0.0))
  {
    return -1.0;
  }
  const DihedralCosines cosines = detail::Cosines(normals);
  return std::min({ (1.0 - cosines.largest) * 1.5,
                    (1.0 + cosines.smallest) * 0.75,
                    RadiusRatioWeight * detail::RadiusRatio(normals) });
}

/** The same; the exterior's tetrahedra are as good as any, unless they are inverted. */
inline double
MaterialQuality(const Vector & a, const Vector & b, const Vector & c, const Vector & d, bool isExterior)
{
  return isExterior ? (TetrahedronVolume(a, b, c, d) > 0.0 ? 2.0 : -1.0) : ShapeQuality(a, b, c, d);
}

/** The quality of a tetrahedron whose smallest dihedral angle is this, in degrees. */
inline double
QualityOfAngle(double degrees)
{
  return (1.0 - std::cos(degrees * EIGEN_PI / 180.0)) * 1.5;
}

/** \brief Moves points, one at a time, so that the worst tetrahedron around each gets better.
 *
 * Works on a fixed connectivity, which has to be compact. Points that share no tetrahedron are moved side by side. */
class PointSmoother
{
public:
  /** A point moves freely in space, within its cell, or not at all; one at which other materials meet than its cell
   * says moves near their interfaces, and only for the sake of triangles. */
  enum class Freedom : std::uint8_t
  {
    Fixed,
    NearInterfaces,
    OnCell,
    Free
  };

  PointSmoother(const InterfaceConstraint &    constraint,
                Material                       exterior,
                const OptimizationParameters & parameters,
                std::vector<Vector> &          points,
                const TetrahedralComplex &     complex);

  /** Moves all points so that the radius ratios around them grow on average. Returns the number of moves. */
  std::size_t
  SmoothAll();
  /** Moves the points of tetrahedra below a quality, where that makes the worst one around them better. Those of nearly
   * flat tetrahedra may leave their cell by the tolerance. */
  std::size_t
  SmoothWorst(double quality, double tolerance);
  /** Moves the points of triangles below a radius ratio within their cell, or near the interfaces of the materials that
   * meet there, where that makes the worst triangle around them better and leaves tetrahedra good enough. */
  std::size_t
  SmoothTriangles(double radiusRatio);
  /** Moves points that are off their cell back to it, where tetrahedra and triangles stay good enough. */
  std::size_t
  ReturnToCells();
  /** Moves the points of curved surfaces off their cell, so that the flat triangles between them lie on both sides of
   * the zero set in equal parts: with all corners on it, convex materials lose volume. Returns the number of moves. */
  std::size_t
  BalanceVolumes(const IndicatorSet & indicators);

private:
  void
  ClassifyPoints();
  bool
  IsExterior(std::uint32_t t) const
  {
    return m_Materials[t] == m_Exterior;
  }
  std::vector<Material>
  MaterialsAround(PointId p) const;
  double
  DistanceFromInterfaces(const std::vector<Material> & materials, PointId p, const Vector & x) const;
  void
  ColourPoints();
  /** Calls move(point) for all points that are not fixed; returns how many moved. */
  std::size_t
  MoveByColour(const std::function<bool(PointId)> & move);
  Vector
  IdealPlace(PointId p, const Tetrahedron & t) const;
  std::vector<char>
  MarkPointsOfPoor(double quality) const;
  Vector
  GradientAround(PointId p) const;
  double
  TotalAround(PointId p, const Vector & x) const;
  bool
  MoveUphillOnAverage(PointId p);
  bool
  MoveUphill(PointId p, double quality, double tolerance);
  bool
  MoveToCell(PointId p);
  bool
  MoveForTriangles(PointId p, double radiusRatio);
  bool
  MoveIfGood(PointId p, const Vector & x, double angle, double triangle);
  bool
  StaysGood(PointId p, const Vector & x, double angle) const;
  double
  WorstAround(PointId p, const Vector & x, double enough) const;
  /** Brings a place for p to within `slack` of its cell, if p is on one; false where there is none nearby. */
  bool
  Admit(PointId p, Vector & x, double slack) const;
  bool
  TryMove(PointId p, const Vector & target, double slack, double & worst);
  double
  MeanGap(const IndicatorSet & indicators, PointId p) const;
  double
  WorstTriangleAround(PointId p, const Vector & x) const;

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
  Incidence                           m_Star;
  std::vector<std::uint32_t>          m_FanStart;
  std::vector<std::array<PointId, 2>> m_Fan;
  std::vector<std::vector<PointId>>   m_Colours;
};
} // namespace mmm

#endif
