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
#ifndef mmmTenTen_h
#define mmmTenTen_h

#include "electrodes/Skin.h"

#include <optional>
#include <string>
#include <vector>

namespace mmm
{
/** \brief A curve on the skin, as points that are close to each other. */
class SkinArc
{
public:
  /** The outline of the head in the plane of three points, from the first through the second to the third. */
  SkinArc(const Skin & skin, const Vector & first, const Vector & second, const Vector & last);

  /** The point that is at a fraction of its length. */
  Vector
  At(double fraction) const;

private:
  std::vector<Vector> m_Points;
  std::vector<double> m_Lengths;
};

/** \brief The places of the 10-10 system, of which the 10-20 system is a part: at tenths of arcs over the skin.
 *
 * Cz is in the middle of both arcs from nasion to inion and from ear to ear. At tenths of the former there are Fpz,
 * AFz, Fz, FCz, Cz ... Oz; at tenths of the arcs from Fpz to Oz through the tenth of the latter above each ear, T7 and
 * T8, there are Fp1, AF7, F7 ... O1 and those on the right. Others are at eighths of the arc between the two of their
 * row through that in the middle. */
class TenTen
{
public:
  /** Points near the skin, and the direction of the vertex. */
  TenTen(const Skin &   skin,
         const Vector & nasion,
         const Vector & inion,
         const Vector & left,
         const Vector & right,
         const Vector & up);

  /** Nothing where there is no such site. */
  std::optional<Vector>
  Find(const std::string & site) const;

private:
  const Skin & m_Skin;
  SkinArc      m_Sagittal;
  SkinArc      m_Left;
  SkinArc      m_Right;
};
} // namespace mmm

#endif
