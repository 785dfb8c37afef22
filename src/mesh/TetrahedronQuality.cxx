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
#include "mesh/TetrahedronQuality.h"

#include "itkMath.h"

namespace mmm
{
std::array<double, 6>
DihedralAngles(const Vector & a, const Vector & b, const Vector & c, const Vector & d)
{
  const detail::TetrahedronNormals n(a, b, c, d);
  const detail::Triple             cd = detail::Difference(detail::ToTriple(d), detail::ToTriple(c));
  const double                     sixVolume = std::abs(n.sixVolume);
  // |n_i x n_j| = 6V |edge|
  const auto angle = [=](const detail::Triple & edge, const detail::Triple & first, const detail::Triple & second) {
    // subtracted from 0 and not negated, because atan2(0, -0) is 180 degrees
    const double cosine = 0.0 - detail::Dot(first, second);
    return std::atan2(sixVolume * std::sqrt(detail::Dot(edge, edge)), cosine) * itk::Math::deg_per_rad;
  };
  return { { angle(n.ab, n.n2, n.n3),
             angle(n.ac, n.n1, n.n3),
             angle(n.ad, n.n1, n.n2),
             angle(n.bc, n.n0, n.n3),
             angle(n.bd, n.n0, n.n2),
             angle(cd, n.n0, n.n1) } };
}

std::array<double, EightTetrahedra::Count>
TetrahedronRadiusRatios(const EightTetrahedra & tetrahedra)
{
  std::array<double, EightTetrahedra::Count> ratios;
  for (int t = 0; t < EightTetrahedra::Count; ++t)
  {
    ratios[t] = detail::RadiusRatio(detail::TetrahedronNormals(
      tetrahedra.Corner(t, 0), tetrahedra.Corner(t, 1), tetrahedra.Corner(t, 2), tetrahedra.Corner(t, 3)));
  }
  return ratios;
}

Vector
TetrahedronRadiusRatioGradient(const Vector & a, const Vector & b, const Vector & c, const Vector & d)
{
  const Vector ab = b - a;
  const Vector ac = c - a;
  const Vector ad = d - a;
  const Vector bc = c - b;
  const Vector cd = d - c;
  const Vector db = b - d;
  const Vector n1 = ac.cross(ad);
  const Vector n2 = ad.cross(ab);
  const Vector n3 = ab.cross(ac);
  const double length1 = n1.norm();
  const double length2 = n2.norm();
  const double length3 = n3.norm();
  const double sixVolume = ab.dot(n1);
  // r_in = 6V / areas, and a + centre / 12V is the circumcentre
  const double areas = bc.cross(cd).norm() + length1 + length2 + length3;
  const Vector centre = ab.squaredNorm() * n1 + ac.squaredNorm() * n2 + ad.squaredNorm() * n3;
  const double distance = centre.norm();
  if (!(std::abs(sixVolume) * length1 * length2 * length3 * distance > 0.0))
  {
    return Vector::Zero();
  }
  // the logarithm of 6 (6V)^2 / (areas |centre|) by parts; what is divided by their values last
  const Vector ofVolume = -(n1 + n2 + n3);
  const Vector ofAreas = n1.cross(cd) / length1 + n2.cross(db) / length2 + n3.cross(bc) / length3;
  const Vector ofDistance = centre.cross(ab.squaredNorm() * cd + ac.squaredNorm() * db + ad.squaredNorm() * bc) -
                            2.0 * (centre.dot(n1) * ab + centre.dot(n2) * ac + centre.dot(n3) * ad);
  return 6.0 * sixVolume * sixVolume / (areas * distance) *
         (2.0 / sixVolume * ofVolume - ofAreas / areas - ofDistance / (distance * distance));
}
} // namespace mmm
