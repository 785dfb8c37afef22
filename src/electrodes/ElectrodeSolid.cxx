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
#include "electrodes/ElectrodeSolid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mmm
{
namespace
{
/** How far an electrode goes below the skin. In voxels. */
constexpr double Depth = 2.0;
/** How far a gel reaches beyond the electrode that it is in, whose sides are its sides. */
constexpr double GelMargin = 1.0;
/** How far a part of a body reaches beyond that, whose surface is its surface. */
constexpr double BodyMargin = 2.0;

/** The distance to where |x| = half, positive where it is less. */
double
Within(double half, double x)
{
  return 0.5 * (half * half - x * x) / half;
}

double
Within(double radius, double innerRadius, double squaredDistance)
{
  const double inside = 0.5 * (radius * radius - squaredDistance) / radius;
  return innerRadius > 0.0 ? std::min(inside, 0.5 * (squaredDistance - innerRadius * innerRadius) / innerRadius)
                           : inside;
}

double
WithinCorners(const ElectrodeLengths & lengths, double squaredDistance)
{
  return Within(lengths.ToCorners(lengths.radius),
                lengths.innerRadius > 0.0 ? lengths.ToCorners(lengths.innerRadius) : 0.0,
                squaredDistance);
}

/** Sets the bounds around a box in a frame. */
void
Enclose(const SkinFrame & frame, const Vector & lower, const Vector & upper, ElectrodeSolid & solid)
{
  solid.lower.setConstant(std::numeric_limits<double>::infinity());
  solid.upper = -solid.lower;
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vector x = frame.ToGrid(
      { (corner & 1 ? upper : lower)[0], (corner & 2 ? upper : lower)[1], (corner & 4 ? upper : lower)[2] });
    solid.lower = solid.lower.cwiseMin(x);
    solid.upper = solid.upper.cwiseMax(x);
  }
}
} // namespace

ElectrodeOnSkin::ElectrodeOnSkin(const ElectrodeLengths & lengths, const Skin & skin, const SkinFrame & frame)
  : m_Lengths(lengths)
  , m_Frame(frame)
  , m_Half{ this->IsFlat() ? lengths.radius : 0.5 * lengths.size[0],
            this->IsFlat() ? lengths.radius : 0.5 * lengths.size[1] }
  , m_Patch(skin, frame, m_Half[0] + IndicatorBandWidth, m_Half[1] + IndicatorBandWidth)
  , m_Extent(m_Patch.Measure([this](double u, double v) { return this->ToOutline(u, v) > 0.0; }))
{}

double
ElectrodeOnSkin::ToOutline(double u, double v) const
{
  return this->IsFlat() ? Within(m_Lengths.radius, m_Lengths.innerRadius, u * u + v * v)
                        : std::min(Within(m_Half[0], u), Within(m_Half[1], v));
}

double
ElectrodeOnSkin::ToCorners(double u, double v) const
{
  return this->IsFlat() ? WithinCorners(m_Lengths, u * u + v * v) : this->ToOutline(u, v);
}

double
ElectrodeOnSkin::Elevation(const Vector & local) const
{
  if (this->IsFlat())
  {
    return local[2];
  }
  const double height = m_Patch.Height(local[0], local[1]);
  const auto   slope = m_Patch.Slope(local[0], local[1]);
  const double elevation = (local[2] - height) / std::sqrt(1.0 + slope[0] * slope[0] + slope[1] * slope[1]);
  return std::isnan(elevation) ? local[2] : elevation;
}

double
ElectrodeOnSkin::LeastThickness() const
{
  return this->IsFlat() && m_Lengths.gelThickness == 0.0 ? m_Lengths.thickness - m_Extent.highest : m_Lengths.thickness;
}

double
ElectrodeOnSkin::LeastGelThickness() const
{
  return m_Lengths.gelThickness - (this->IsFlat() ? m_Extent.highest : 0.0);
}

ElectrodeSolid
ElectrodeOnSkin::MakeSolid(double top, double margin, double area) const
{
  ElectrodeSolid solid;
  solid.area = area;
  const double bottom = (this->IsFlat() ? m_Extent.lowest : 0.0) - Depth;
  solid.distance = [self = *this, top, bottom, margin](const Vector & x) {
    const Vector local = self.m_Frame.ToLocal(x);
    const double elevation = self.Elevation(local);
    return std::min({ self.ToCorners(local[0], local[1]) + margin, top - elevation, elevation - bottom });
  };
  Enclose(m_Frame,
          { -m_Half[0] - margin, -m_Half[1] - margin, m_Extent.lowest - Depth },
          { m_Half[0] + margin, m_Half[1] + margin, top + (this->IsFlat() ? 0.0 : m_Extent.highest) },
          solid);
  return solid;
}

ElectrodeSolid
ElectrodeOnSkin::Body() const
{
  // between an electrode that follows the skin and its gel there is as much as on the skin, but for the thickness
  const bool isOnGel = m_Lengths.gelThickness > 0.0;
  return this->MakeSolid(
    m_Lengths.gelThickness + m_Lengths.thickness, 0.0, isOnGel && this->IsFlat() ? m_Extent.flatArea : m_Extent.area);
}

ElectrodeSolid
ElectrodeOnSkin::Gel() const
{
  return this->MakeSolid(m_Lengths.gelThickness, GelMargin, m_Extent.area);
}

ElectrodeSolid
MakeImplant(const ElectrodeLengths & lengths, const SkinFrame & frame)
{
  ElectrodeSolid solid;
  Vector         half = Vector::Constant(lengths.radius);
  switch (lengths.shape)
  {
    case ElectrodeShape::Sphere:
      solid.distance = [frame, radius = lengths.radius](const Vector & x) {
        return Within(radius, 0.0, (x - frame.origin).squaredNorm());
      };
      solid.area = 4.0 * EIGEN_PI * lengths.radius * lengths.radius;
      break;
    case ElectrodeShape::Cylinder:
    {
      half[0] = 0.5 * lengths.size[0];
      if (lengths.isPartOfBody)
      {
        half[1] = half[2] = lengths.radius + BodyMargin;
        solid.distance = [frame, half](const Vector & x) {
          const Vector local = frame.ToLocal(x);
          return std::min(Within(half[0], local[0]), Within(half[1], std::hypot(local[1], local[2])));
        };
        solid.area = 2.0 * EIGEN_PI * lengths.radius * lengths.size[0];
        break;
      }
      solid.distance = [frame, lengths, end = half[0]](const Vector & x) {
        const Vector local = frame.ToLocal(x);
        const double around = local[1] * local[1] + local[2] * local[2];
        const double along = local[0] + end - lengths.radius;
        if (lengths.isRounded && along < 0.0)
        {
          return Within(lengths.radius, lengths.innerRadius, around + along * along);
        }
        const double fromEnd = lengths.isRounded ? end - local[0] : Within(end, local[0]);
        return std::min(fromEnd, Within(lengths.radius, lengths.innerRadius, around));
      };
      const double radii = lengths.radius + lengths.innerRadius;
      solid.area = 2.0 * EIGEN_PI * radii * (lengths.size[0] + lengths.radius - lengths.innerRadius);
      if (lengths.isRounded)
      {
        // half a sphere in place of a disc and a part of the side
        solid.area -= EIGEN_PI * lengths.radius * lengths.radius;
      }
      break;
    }
    default:
      half = 0.5 * Vector(lengths.size);
      solid.distance = [frame, half](const Vector & x) {
        const Vector local = frame.ToLocal(x);
        return std::min({ Within(half[0], local[0]), Within(half[1], local[1]), Within(half[2], local[2]) });
      };
      solid.area = 8.0 * (half[0] * half[1] + half[1] * half[2] + half[2] * half[0]);
  }
  Enclose(frame, -half, half, solid);
  return solid;
}
} // namespace mmm
