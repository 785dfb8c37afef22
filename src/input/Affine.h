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
#ifndef mmmAffine_h
#define mmmAffine_h

#include "itkImageBase.h"

#include <array>
#include <string>

namespace mmm
{
/** \brief Where the voxels of an image are: from indices to points in mm, in LPS. */
struct Affine
{
  /** The steps from a voxel to the next one along each of the image's axes. */
  std::array<itk::Vector<double, 3>, 3> steps;
  /** The center of the first voxel. */
  itk::Point<double, 3> origin;

  itk::Point<double, 3>
  Apply(const itk::ContinuousIndex<double, 3> & index) const;
};

/** From right, anterior, superior to left, posterior, superior, or the other way round, and to another unit. */
Affine
FromRAS(Affine affine, double unit = 1.0);

Affine
AffineOf(const itk::ImageBase<3> & image);

/** Gives an image spacing, origin and direction. The columns of the direction have length 1; they need not be at right
 * angles. */
void
SetAffine(const Affine & affine, itk::ImageBase<3> & image);

/** What makes it useless, in words of the axes: "its second axis has no length"; empty if it is all right. */
std::string
FindFault(const Affine & affine);

/** The smallest angle between two axes, in degrees. */
double
SmallestAngle(const Affine & affine);

/** How far apart two affines put a voxel of the image at most. */
double
LargestDistance(const Affine & a, const Affine & b, const itk::Size<3> & size);
} // namespace mmm

#endif
