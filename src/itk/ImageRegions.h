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
#ifndef mmmImageRegions_h
#define mmmImageRegions_h

#include "itkImageAlgorithm.h"
#include "itkImageRegionConstIteratorWithIndex.h"
#include "itkZeroFluxNeumannPadImageFilter.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
/** The smallest region that holds all pixels of which isIn(pixel) is true. There must be one. */
template <typename TImage, typename TFunction>
typename TImage::RegionType
BoxOf(const TImage * image, const TFunction & isIn)
{
  const auto & whole = image->GetLargestPossibleRegion();
  auto         lower = whole.GetUpperIndex();
  auto         upper = whole.GetIndex();
  for (itk::ImageRegionConstIteratorWithIndex<TImage> it(image, whole); !it.IsAtEnd(); ++it)
  {
    if (isIn(it.Get()))
    {
      for (unsigned int axis = 0; axis < TImage::ImageDimension; ++axis)
      {
        lower[axis] = std::min(lower[axis], it.GetIndex()[axis]);
        upper[axis] = std::max(upper[axis], it.GetIndex()[axis]);
      }
    }
  }
  typename TImage::RegionType box;
  box.SetIndex(lower);
  box.SetUpperIndex(upper);
  return box;
}

/** A region with as many voxels more on each side as reach over a margin. Throws itk::ExceptionObject where they are
 * too many for any memory. */
template <typename TRegion, typename TSpacing>
TRegion
GrowRegion(const TRegion & region, const TSpacing & spacing, double margin)
{
  constexpr double most = 1e5;

  auto lower = region.GetIndex();
  auto upper = region.GetUpperIndex();
  for (unsigned int axis = 0; axis < TRegion::ImageDimension; ++axis)
  {
    const double voxels = std::ceil(margin / spacing[axis] - 1e-6);
    if (voxels > most)
    {
      itkGenericExceptionMacro("A margin of " << margin << " mm is " << voxels << " voxels wide, which is too much.");
    }
    lower[axis] -= static_cast<itk::IndexValueType>(voxels);
    upper[axis] += static_cast<itk::IndexValueType>(voxels);
  }
  TRegion grown;
  grown.SetIndex(lower);
  grown.SetUpperIndex(upper);
  return grown;
}

/** The part of an image that is in a region, in the same place; pixels beyond the image have the value `beyond`. It is
 * the image itself if the region is that of the image. */
template <typename TImage>
typename TImage::ConstPointer
CopyRegion(const TImage * image, const typename TImage::RegionType & region, const typename TImage::PixelType & beyond)
{
  if (region == image->GetLargestPossibleRegion())
  {
    return image;
  }
  const auto copy = TImage::New();
  copy->CopyInformation(image);
  copy->SetRegions(region);
  copy->Allocate();
  copy->FillBuffer(beyond);
  auto common = region;
  if (common.Crop(image->GetLargestPossibleRegion()))
  {
    itk::ImageAlgorithm::Copy(image, copy.GetPointer(), common, common);
  }
  return copy.GetPointer();
}

/** The image in a larger region, with the values of the nearest pixels in what that has more. */
template <typename TImage>
typename TImage::Pointer
ExtendRegion(TImage * image, const typename TImage::RegionType & region)
{
  const auto &              own = image->GetLargestPossibleRegion();
  typename TImage::SizeType before;
  typename TImage::SizeType behind;
  for (unsigned int axis = 0; axis < TImage::ImageDimension; ++axis)
  {
    before[axis] = static_cast<itk::SizeValueType>(own.GetIndex(axis) - region.GetIndex(axis));
    behind[axis] = static_cast<itk::SizeValueType>(region.GetUpperIndex()[axis] - own.GetUpperIndex()[axis]);
  }
  const auto filter = itk::ZeroFluxNeumannPadImageFilter<TImage, TImage>::New();
  filter->SetInput(image);
  filter->SetPadLowerBound(before);
  filter->SetPadUpperBound(behind);
  filter->Update();
  return filter->GetOutput();
}
} // namespace mmm

#endif
