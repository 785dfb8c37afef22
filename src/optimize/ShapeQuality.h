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
#ifndef mmmShapeQuality_h
#define mmmShapeQuality_h

#include "mesh/TetrahedronQuality.h"

#include "itkMath.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
/** Above and below those of all tetrahedra. */
constexpr double BestQuality = 2.0;
constexpr double WorstQuality = -2.0;
/** That of a tetrahedron that is inverted. */
constexpr double InvertedQuality = -1.0;

/** 1 for a regular tetrahedron, 0 for a flat one, negative for an inverted one; it falls off alike for small and large
 * dihedral angles. Among tetrahedra of equal angles, those that are poor by their radius ratio count by that. */
inline double
ShapeQuality(const Vector & a, const Vector & b, const Vector & c, const Vector & d)
{
  // the cosine of a regular tetrahedron's angles is 1/3
  constexpr double                 SmallAngleWeight = 1.5;
  constexpr double                 LargeAngleWeight = 0.75;
  constexpr double                 RadiusRatioWeight = 0.5;
  const detail::TetrahedronNormals normals(a, b, c, d);
  if (!(normals.sixVolume > 0.0))
  {
    return InvertedQuality;
  }
  const DihedralCosines cosines = detail::Cosines(normals);
  return std::min({ (1.0 - cosines.largest) * SmallAngleWeight,
                    (1.0 + cosines.smallest) * LargeAngleWeight,
                    RadiusRatioWeight * detail::RadiusRatio(normals) });
}

/** The same; the exterior's tetrahedra are as good as any, unless they are inverted. */
inline double
MaterialQuality(const Vector & a, const Vector & b, const Vector & c, const Vector & d, bool isExterior)
{
  return isExterior ? (TetrahedronVolume(a, b, c, d) > 0.0 ? BestQuality : InvertedQuality) : ShapeQuality(a, b, c, d);
}

/** The quality of a tetrahedron whose smallest dihedral angle is this, in degrees. */
inline double
QualityOfAngle(double degrees)
{
  return (1.0 - std::cos(degrees * itk::Math::pi / 180.0)) * 1.5;
}
} // namespace mmm

#endif
