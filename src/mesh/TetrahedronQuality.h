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
#ifndef mmmTetrahedronQuality_h
#define mmmTetrahedronQuality_h

#include "base/Grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace mmm
{
/** The four points of a tetrahedron, by index. It is positive when the first three turn counter-clockwise as seen
 * from the fourth, det[b - a, c - a, d - a] > 0: the orientation of ITK and VTK. */
using Tetrahedron = std::array<std::uint32_t, 4>;

/** The face opposite each point, counter-clockwise as seen from outside a positive tetrahedron. */
constexpr int TetrahedronFaces[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };

/** The six edges, in the order of DihedralAngles(). */
constexpr int TetrahedronEdges[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };

/** \brief What decides whether a tetrahedron is acceptable, got without trigonometric functions.
 *
 * Cosines fall as angles grow: the *largest* cosine belongs to the *smallest* dihedral angle. They do not depend on the
 * orientation. Where a face has no area they are 1 and -1. Angles below 1e-6 degrees cannot be told from 0. */
struct DihedralCosines
{
  double largest{ 1.0 };
  double smallest{ -1.0 };
};

namespace detail
{
/** A vector of three named numbers: compilers keep them in registers, which makes what follows two to three times as
 * fast as with an array. */
struct Triple
{
  double x;
  double y;
  double z;
};

inline Triple
ToTriple(const Vector & a)
{
  return { a[0], a[1], a[2] };
}

inline Triple
Difference(const Triple & a, const Triple & b)
{
  return { a.x - b.x, a.y - b.y, a.z - b.z };
}

inline Triple
Cross(const Triple & a, const Triple & b)
{
  return { a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
}

inline double
Dot(const Triple & a, const Triple & b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/** The normals of the four faces, as long as twice the face's area and pointing inward for a positive tetrahedron. */
struct TetrahedronNormals
{
  TetrahedronNormals(const Vector & a, const Vector & b, const Vector & c, const Vector & d)
    : TetrahedronNormals(ToTriple(a), ToTriple(b), ToTriple(c), ToTriple(d))
  {}

  TetrahedronNormals(const Triple & a, const Triple & b, const Triple & c, const Triple & d)
    : ab(Difference(b, a))
    , ac(Difference(c, a))
    , ad(Difference(d, a))
    , bc(Difference(c, b))
    , bd(Difference(d, b))
    , n0(Cross(bd, bc))
    , n1(Cross(ac, ad))
    , n2(Cross(ad, ab))
    , n3(Cross(ab, ac))
    , square0(Dot(n0, n0))
    , square1(Dot(n1, n1))
    , square2(Dot(n2, n2))
    , square3(Dot(n3, n3))
    , sixVolume(Dot(ab, n1))
  {}

  Triple ab;
  Triple ac;
  Triple ad;
  Triple bc;
  Triple bd;
  Triple n0;
  Triple n1;
  Triple n2;
  Triple n3;
  double square0;
  double square1;
  double square2;
  double square3;
  double sixVolume;
};

inline double
RadiusRatio(const TetrahedronNormals & n)
{
  // r_in = 6V / areas, and a + (x, y, z) / 12V is the circumcentre
  const double areas = std::sqrt(n.square0) + std::sqrt(n.square1) + std::sqrt(n.square2) + std::sqrt(n.square3);
  const double ab = Dot(n.ab, n.ab);
  const double ac = Dot(n.ac, n.ac);
  const double ad = Dot(n.ad, n.ad);
  const double x = ab * n.n1.x + ac * n.n2.x + ad * n.n3.x;
  const double y = ab * n.n1.y + ac * n.n2.y + ad * n.n3.y;
  const double z = ab * n.n1.z + ac * n.n2.z + ad * n.n3.z;
  const double denominator = areas * std::sqrt(x * x + y * y + z * z);
  return denominator > 0.0 ? 6.0 * n.sixVolume * n.sixVolume / denominator : 0.0;
}

inline DihedralCosines
Cosines(const TetrahedronNormals & n)
{
  DihedralCosines result;
  if (!(std::min(std::min(n.square0, n.square1), std::min(n.square2, n.square3)) > 0.0))
  {
    return result;
  }
  const double r0 = 1.0 / std::sqrt(n.square0);
  const double r1 = 1.0 / std::sqrt(n.square1);
  const double r2 = 1.0 / std::sqrt(n.square2);
  const double r3 = 1.0 / std::sqrt(n.square3);
  const double c01 = -Dot(n.n0, n.n1) * (r0 * r1);
  const double c02 = -Dot(n.n0, n.n2) * (r0 * r2);
  const double c03 = -Dot(n.n0, n.n3) * (r0 * r3);
  const double c12 = -Dot(n.n1, n.n2) * (r1 * r2);
  const double c13 = -Dot(n.n1, n.n3) * (r1 * r3);
  const double c23 = -Dot(n.n2, n.n3) * (r2 * r3);
  result.largest = std::min(1.0, std::max(std::max(std::max(c01, c02), std::max(c03, c12)), std::max(c13, c23)));
  result.smallest = std::max(-1.0, std::min(std::min(std::min(c01, c02), std::min(c03, c12)), std::min(c13, c23)));
  return result;
}
} // namespace detail

/** Twice the inscribed circle's radius over the circumscribed one's: 1 for an equilateral triangle, 0 for a flat one.
 */
inline double
TriangleRadiusRatio(const Vector & a, const Vector & b, const Vector & c)
{
  const double u = (c - b).norm();
  const double v = (c - a).norm();
  const double w = (b - a).norm();
  const double denominator = (u + v + w) * u * v * w;
  return denominator > 0.0 ? 4.0 * (b - a).cross(c - a).squaredNorm() / denominator : 0.0;
}

/** The gradient of TriangleRadiusRatio() by its first argument; 0 for a flat triangle. */
inline Vector
TriangleRadiusRatioGradient(const Vector & a, const Vector & b, const Vector & c)
{
  const Vector ab = b - a;
  const Vector ac = c - a;
  const Vector bc = c - b;
  const Vector normal = ab.cross(ac);
  const double square = normal.squaredNorm();
  if (!(square > 0.0))
  {
    return Vector::Zero();
  }
  // the logarithm of 4 |n|^2 / ((u + v + w) u v w) by parts
  const double u = bc.norm();
  const double v = ac.norm();
  const double w = ab.norm();
  const double sum = u + v + w;
  const Vector logarithmic =
    (2.0 / square) * normal.cross(bc) + (1.0 / sum + 1.0 / v) / v * ac + (1.0 / sum + 1.0 / w) / w * ab;
  return 4.0 * square / (sum * u * v * w) * logarithmic;
}

/** The volume, negative when the orientation is. */
inline double
TetrahedronVolume(const Vector & a, const Vector & b, const Vector & c, const Vector & d)
{
  return (b - a).dot((c - a).cross(d - a)) / 6.0;
}

/** Three times the inscribed sphere's radius over the circumscribed one's: 1 for a regular tetrahedron, 0 for a flat
 * one, whatever the orientation. */
inline double
TetrahedronRadiusRatio(const Vector & a, const Vector & b, const Vector & c, const Vector & d)
{
  return detail::RadiusRatio(detail::TetrahedronNormals(a, b, c, d));
}

/** Eight tetrahedra, coordinate by coordinate: compilers compute several side by side, which takes half the time. */
struct EightTetrahedra
{
  static constexpr int Count = 8;

  void
  SetCorner(int tetrahedron, int corner, const Vector & x)
  {
    for (int a = 0; a < 3; ++a)
    {
      corners[corner][a][tetrahedron] = x[a];
    }
  }
  detail::Triple
  Corner(int tetrahedron, int corner) const
  {
    return { corners[corner][0][tetrahedron], corners[corner][1][tetrahedron], corners[corner][2][tetrahedron] };
  }

  double corners[4][3][Count]{};
};

/** The radius ratios of eight tetrahedra, those of TetrahedronRadiusRatio() to the last bit. */
std::array<double, EightTetrahedra::Count>
TetrahedronRadiusRatios(const EightTetrahedra & tetrahedra);

/** The gradient of TetrahedronRadiusRatio() by its first argument; 0 for a flat tetrahedron. */
Vector
TetrahedronRadiusRatioGradient(const Vector & a, const Vector & b, const Vector & c, const Vector & d);

/** The six dihedral angles in degrees, at TetrahedronEdges, whatever the orientation. They are accurate down to the
 * flattest tetrahedra, where they are 0 and 180. At the edges of a face without area the angle is 0. */
std::array<double, 6>
DihedralAngles(const Vector & a, const Vector & b, const Vector & c, const Vector & d);
} // namespace mmm

#endif
