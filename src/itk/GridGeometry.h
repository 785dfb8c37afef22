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
#ifndef mmmGridGeometry_h
#define mmmGridGeometry_h

#include "base/Grid.h"

#include "itkImageBase.h"

namespace mmm
{
/** \brief Where a Grid is in an image's physical space.
 *
 * The grid is a region of the image, its node 0 the region's first voxel and its unit of length the smallest voxel
 * spacing. Spacings and lengths in that unit are rounded to 1e-6, so that a grid and everything computed on it do not
 * depend on the image's origin, direction and unit of length. */
class GridGeometry
{
public:
  using ImageType = itk::ImageBase<3>;
  using RegionType = ImageType::RegionType;
  using PointType = itk::Point<double, 3>;

  GridGeometry(const ImageType * image, const RegionType & region);

  const Grid &
  GetGrid() const
  {
    return m_Grid;
  }

  const RegionType &
  GetRegion() const
  {
    return m_Region;
  }

  /** The grid's unit of length in the image's unit, usually mm. */
  double
  GetUnit() const
  {
    return m_Unit;
  }

  /** A length in the grid's unit, from one in the image's unit. A positive length stays positive. */
  double
  ToGridUnit(double length) const;

  /** The physical place of a point of the grid. */
  PointType
  ToPhysicalPoint(const Vector & x) const;

  /** The inverse. */
  Vector
  ToGridPoint(const PointType & point) const;

  /** Whether the way from the grid to physical space turns right-handed frames into left-handed ones. */
  bool
  IsReflected() const;

  /** An image without pixels, of the grid's size and geometry: origin 0, no rotation, the grid's unit of length. */
  static void
  SetGridGeometry(const Grid & grid, ImageType * image);

private:
  ImageType::Pointer m_Image;
  RegionType         m_Region;
  Grid               m_Grid;
  double             m_Unit{ 1.0 };
};
} // namespace mmm

#endif
