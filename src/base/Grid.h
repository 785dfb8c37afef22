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
#ifndef mmmGrid_h
#define mmmGrid_h

#include "itk_eigen.h"
#include ITK_EIGEN(Dense)

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace mmm
{
/** A point or vector of the geometry core. Unit: the smallest voxel spacing of the image, see Grid. */
using Vector = Eigen::Vector3d;

using Index = std::array<int, 3>;

/** \brief The axis-aligned frame that the geometry core works in.
 *
 * Voxel (i, j, k) of the image has its centre at (i, j, k) * spacing. Lengths are in units of the smallest voxel
 * spacing, so that the spacing of the finest axis is 1. Origin, direction and scale are applied to points once, at the
 * end, by the filters: the same labels give the same mesh whatever the image's geometry and unit of length.
 */
struct Grid
{
  Index  size{ { 0, 0, 0 } };
  Vector spacing{ Vector::Ones() };

  std::size_t
  NumberOfNodes() const
  {
    return std::size_t(size[0]) * size[1] * size[2];
  }
  std::size_t
  Offset(int i, int j, int k) const
  {
    return (std::size_t(k) * size[1] + j) * size[0] + i;
  }
  std::size_t
  Offset(const Index & index) const
  {
    return this->Offset(index[0], index[1], index[2]);
  }
  Index
  IndexAt(std::size_t offset) const
  {
    const auto plane = std::size_t(size[0]) * size[1];
    const auto inPlane = offset % plane;
    return { { int(inPlane % size[0]), int(inPlane / size[0]), int(offset / plane) } };
  }
  bool
  Contains(const Index & index) const
  {
    for (int a = 0; a < 3; ++a)
    {
      if (index[a] < 0 || index[a] >= size[a])
      {
        return false;
      }
    }
    return true;
  }
  /** The node of the grid that is nearest to one that may be outside. */
  Index
  Clamp(const Index & index) const
  {
    Index inside;
    for (int a = 0; a < 3; ++a)
    {
      inside[a] = std::min(std::max(index[a], 0), size[a] - 1);
    }
    return inside;
  }
  Vector
  Position(const Index & index) const
  {
    return Vector(index[0] * spacing[0], index[1] * spacing[1], index[2] * spacing[2]);
  }
  /** The faces of the image box: half a voxel outside the outermost voxel centres. */
  double
  LowerFace(int axis) const
  {
    return -0.5 * spacing[axis];
  }
  double
  UpperFace(int axis) const
  {
    return (size[axis] - 0.5) * spacing[axis];
  }
};

/** A dense array over a box of grid nodes, the first index fastest. `lower` is the grid index of its first node. */
template <typename T>
struct Block
{
  Index          lower{ { 0, 0, 0 } };
  Index          size{ { 0, 0, 0 } };
  std::vector<T> values;
};

/** The same, over memory that somebody else owns. */
template <typename T>
struct BlockView
{
  Index lower{ { 0, 0, 0 } };
  Index size{ { 0, 0, 0 } };
  T *   values{ nullptr };
};
} // namespace mmm

#endif
