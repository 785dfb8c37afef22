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
#ifndef mmmSkin_h
#define mmmSkin_h

#include "indicators/IndicatorSet.h"

namespace mmm
{
/** \brief The outside of a head: the smooth boundary of the exterior that reaches the image's border.
 *
 * So cavities are of the head. Points and lengths are those of the grid. */
class Skin
{
public:
  /** By node, whether it is exterior. Throws itk::ExceptionObject if none of the exterior is at the border, or if there
   * is nothing else. */
  Skin(const Grid & grid, const std::vector<bool> & isExterior);

  const Grid &
  GetGrid() const
  {
    return m_Outside.GetGrid();
  }

  /** The distance to the skin, up to IndicatorBandWidth, positive outside. */
  double
  Height(const Vector & x) const
  {
    return m_Outside.Value(0, x);
  }
  /** Outward, of unit length, near the skin. */
  Vector
  Normal(const Vector & x) const;

  /** The point of the skin that is nearest to x. */
  Vector
  Project(const Vector & x) const;

private:
  Skin(const MaterialImage & image);
  Vector
  OntoSkin(Vector x) const;

  IndicatorSet        m_Outside;
  std::vector<Vector> m_Faces;
};
} // namespace mmm

#endif
