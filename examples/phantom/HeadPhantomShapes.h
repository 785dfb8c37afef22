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
#ifndef mmmHeadPhantomShapes_h
#define mmmHeadPhantomShapes_h

#include "phantom/HeadPhantom.h"

#include <algorithm>
#include <cmath>

/** Signed distance bounds, in mm, negative inside. None changes much faster than the distance itself: a layer between
 * two levels of one function is about as thick as the levels say. */
namespace mmm::phantom
{
/** The union, its crease rounded where the two are within `blend` of each other. */
inline double
SmoothUnion(double a, double b, double blend)
{
  const double overlap = std::max(blend - std::abs(a - b), 0.0) / blend;
  return std::min(a, b) - 0.25 * overlap * overlap * blend;
}

inline double
SmoothIntersection(double a, double b, double blend)
{
  return -SmoothUnion(-a, -b, blend);
}

inline double
Ellipsoid(const Vector & point, const Vector & center, const Vector & radii)
{
  const Vector scaled = (point - center).cwiseQuotient(radii);
  const double level = scaled.norm();
  const double slope = scaled.cwiseQuotient(radii).norm();
  return slope > 1e-9 ? level * (level - 1.0) / slope : -radii.minCoeff();
}

/** A rod with round ends whose radius goes from `radiusA` at `a` to `radiusB` at `b`. */
inline double
Rod(const Vector & point, const Vector & a, double radiusA, const Vector & b, double radiusB)
{
  const Vector axis = b - a;
  const double along = std::min(std::max((point - a).dot(axis) / axis.squaredNorm(), 0.0), 1.0);
  return (point - a - along * axis).norm() - (radiusA + along * (radiusB - radiusA));
}

/** 1 at the centre, 0 from about two widths on. */
inline double
Bump(const Vector & point, const Vector & center, double width)
{
  return std::exp(-(point - center).squaredNorm() / (width * width));
}

/** 0 below `from`, 1 above `to`, smooth in between. */
inline double
SmoothStep(double from, double to, double value)
{
  const double t = std::min(std::max((value - from) / (to - from), 0.0), 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/** The part of `value` above zero: distances to bounded sheets are the hypot() of it and the distance to their plane.
 */
inline double
Excess(double value)
{
  return std::max(value, 0.0);
}

/** Paired organs are modelled on the left only. */
inline Vector
MirrorToLeft(const Vector & point)
{
  return Vector(std::abs(point[0]), point[1], point[2]);
}
} // namespace mmm::phantom

#endif
