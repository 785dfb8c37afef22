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
#ifndef mmmBoxPlanes_h
#define mmmBoxPlanes_h

#include "image/MaterialImage.h"

namespace mmm
{
/** \brief The six faces of the image box as pseudo-materials, which own all that is outside the box.
 *
 * Their numbers follow those of the materials, two an axis, the lower face first. */
class BoxPlanes
{
public:
  static constexpr int Count = 6;

  BoxPlanes(const Grid & grid, std::size_t numberOfMaterials)
    : m_First(numberOfMaterials)
  {
    for (int a = 0; a < 3; ++a)
    {
      m_Faces[2 * a] = grid.LowerFace(a);
      m_Faces[2 * a + 1] = grid.UpperFace(a);
    }
  }

  bool
  Has(Material m) const
  {
    return m >= m_First;
  }
  Material
  At(int number) const
  {
    return Material(m_First + number);
  }
  /** The signed distance to a plane, positive outside the box. */
  double
  Value(Material plane, const Vector & x) const
  {
    const auto number = plane - m_First;
    return number % 2 ? x[number / 2] - m_Faces[number] : m_Faces[number] - x[number / 2];
  }
  Vector
  Gradient(Material plane) const
  {
    const auto number = plane - m_First;
    return Vector::Unit(number / 2) * (number % 2 ? 1.0 : -1.0);
  }
  /** Moves a point onto a plane exactly: particles of a cut are to be coplanar. */
  void
  Snap(Material plane, Vector & x) const
  {
    const auto number = plane - m_First;
    x[number / 2] = m_Faces[number];
  }

private:
  std::size_t m_First;
  double      m_Faces[Count];
};
} // namespace mmm

#endif
