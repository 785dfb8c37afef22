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
#ifndef mmmSkinPatch_h
#define mmmSkinPatch_h

#include "electrodes/Skin.h"

#include <array>
#include <functional>

namespace mmm
{
/** Right-handed, of unit length; the third axis is the skin's outward normal. */
struct SkinFrame
{
  Vector origin;
  Vector axes[3];

  Vector
  ToLocal(const Vector & x) const
  {
    const Vector way = x - origin;
    return { axes[0].dot(way), axes[1].dot(way), axes[2].dot(way) };
  }
  Vector
  ToGrid(const Vector & local) const
  {
    return origin + axes[0] * local[0] + axes[1] * local[1] + axes[2] * local[2];
  }
};

/** The frame at a point of the skin whose first axis goes towards another place, as far as it lies in the skin's
 * tangent plane. */
SkinFrame
MakeSkinFrame(const Skin & skin, const Vector & foot, const Vector & towards);

/** \brief The skin around a point as a function over its tangent plane: where a line along the normal meets it. */
class SkinPatch
{
public:
  /** Over a rectangle around the frame's origin. */
  SkinPatch(const Skin & skin, const SkinFrame & frame, double halfLength, double halfWidth);

  /** Over the tangent plane; beyond the rectangle, that of its border. */
  double
  Height(double u, double v) const;

  /** Whether there is skin under a part of the plane, and how low and high it is there; its area. */
  struct Extent
  {
    bool   isComplete{ true };
    double lowest{ 0.0 };
    double highest{ 0.0 };
    double area{ 0.0 };
    double flatArea{ 0.0 };
  };
  Extent
  Measure(const std::function<bool(double, double)> & isIn) const;

  /** The first derivatives of the height. */
  std::array<double, 2>
  Slope(double u, double v) const;

private:
  void
  Follow(const Skin & skin, const SkinFrame & frame, int i, int j, double guess);
  double &
  At(int i, int j)
  {
    return m_Heights[std::size_t(j + m_Half[1]) * (2 * m_Half[0] + 1) + (i + m_Half[0])];
  }
  double
  At(int i, int j) const
  {
    return m_Heights[std::size_t(j + m_Half[1]) * (2 * m_Half[0] + 1) + (i + m_Half[0])];
  }

  int m_Half[2];
  /** Not a number where the skin falls away. */
  std::vector<double> m_Heights;
};
} // namespace mmm

#endif
