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
#include "itk/GridGeometry.h"

#include "itkMacro.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
constexpr double Resolution = 1e6; // parts of the grid's unit

/** Further away, in units of the grid, what is left of the digits of positions is too coarse for elements. */
constexpr double Farthest = 1e8;

/** The lengths of the steps from voxel to voxel: the spacing, but for directions that scale it. */
itk::Vector<double, 3>
VoxelSizes(const GridGeometry::ImageType & image)
{
  // less is the rounding of directions
  constexpr double       tolerance = 1e-4;
  itk::Vector<double, 3> sizes = image.GetSpacing();
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const auto & direction = image.GetDirection();
    const double scale = std::hypot(direction[0][axis], direction[1][axis], direction[2][axis]);
    sizes[axis] *= std::abs(scale - 1.0) > tolerance ? scale : 1.0;
  }
  return sizes;
}

/** \throw itk::ExceptionObject if positions in the image are no numbers, or nearly all the same. */
void
CheckPlace(const GridGeometry::ImageType & image, double unit)
{
  const auto & origin = image.GetOrigin();
  if (!std::isfinite(unit) || !std::isfinite(origin[0] + origin[1] + origin[2]))
  {
    itkGenericExceptionMacro("The image has no place: its spacing is " << image.GetSpacing() << " mm, its origin "
                                                                       << origin << "; correct them first.");
  }
  const double distance = std::max({ std::abs(origin[0]), std::abs(origin[1]), std::abs(origin[2]) });
  if (distance > Farthest * unit)
  {
    itkGenericExceptionMacro("The image is too far away: its origin is "
                             << origin << " mm, where positions are not exact to a part of its voxels of " << unit
                             << " mm; correct its origin first.");
  }
}

double
Rounded(double length)
{
  return std::round(length * Resolution) / Resolution;
}
} // namespace

GridGeometry::GridGeometry(const ImageType * image, const RegionType & region)
  : m_Image(ImageType::New())
  , m_Region(region)
{
  m_Image->CopyInformation(image);
  const auto spacing = VoxelSizes(*image);
  m_Unit = std::min({ spacing[0], spacing[1], spacing[2] });
  CheckPlace(*m_Image, m_Unit);
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    m_Grid.size[axis] = static_cast<int>(region.GetSize(axis));
    m_Grid.spacing[axis] = Rounded(spacing[axis] / m_Unit);
  }
}

double
GridGeometry::ToGridUnit(double length) const
{
  const double relative = length / m_Unit;
  if (!std::isfinite(relative))
  {
    return relative;
  }
  return relative > 0.0 ? std::max(Rounded(relative), 1.0 / Resolution) : Rounded(relative);
}

GridGeometry::PointType
GridGeometry::ToPhysicalPoint(const Vector & x) const
{
  itk::ContinuousIndex<double, 3> index;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    index[axis] = static_cast<double>(m_Region.GetIndex(axis)) + x[axis] / m_Grid.spacing[axis];
  }
  PointType point;
  m_Image->TransformContinuousIndexToPhysicalPoint(index, point);
  return point;
}

Vector
GridGeometry::ToGridPoint(const PointType & point) const
{
  itk::ContinuousIndex<double, 3> index;
  // says whether it is in the image, which is of no account
  static_cast<void>(m_Image->TransformPhysicalPointToContinuousIndex(point, index));
  Vector x;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    x[axis] = (index[axis] - static_cast<double>(m_Region.GetIndex(axis))) * m_Grid.spacing[axis];
  }
  return x;
}

bool
GridGeometry::IsReflected() const
{
  const auto &    direction = m_Image->GetDirection();
  Eigen::Matrix3d matrix;
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 3; ++column)
    {
      matrix(row, column) = direction[row][column];
    }
  }
  return matrix.determinant() < 0.0;
}

void
GridGeometry::SetGridGeometry(const Grid & grid, ImageType * image)
{
  RegionType             region;
  ImageType::SpacingType spacing;
  ImageType::PointType   origin;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    region.SetSize(axis, static_cast<itk::SizeValueType>(grid.size[axis]));
    spacing[axis] = grid.spacing[axis];
    origin[axis] = 0.0;
  }
  ImageType::DirectionType direction;
  direction.SetIdentity();
  image->SetRegions(region);
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  image->SetDirection(direction);
}
} // namespace mmm
