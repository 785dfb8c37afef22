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
#ifndef mmmPointSmoother_h
#define mmmPointSmoother_h

#include "optimize/MovablePoints.h"

namespace mmm
{
/** \brief Moves points so that the worst tetrahedron around each gets better, or the worst triangle of an interface. */
class PointSmoother : protected MovablePoints
{
public:
  using MovablePoints::MovablePoints;

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

protected:
  bool
  MoveUphillOnAverage(PointId p, const std::function<bool(Vector &)> & admit);

private:
  class MovedStar;

  Vector
  IdealPlace(PointId p, const Tetrahedron & t) const;
  std::vector<char>
  MarkPointsOfPoor(double quality) const;
  Vector
  GradientAround(PointId p) const;
  double
  TotalAround(PointId p, MovedStar & star, const Vector & x) const;
  bool
  MoveUphill(PointId p, double quality, double tolerance);
  bool
  MoveToCell(PointId p);
  bool
  MoveForTriangles(PointId p, double radiusRatio);
  template <typename TAlong, typename TAdmit>
  bool
  SearchForTriangles(PointId p, const TAlong & along, const TAdmit & admit, double & worst);
  bool
  TryMove(PointId p, const Vector & target, double slack, double & worst);
};
} // namespace mmm

#endif
