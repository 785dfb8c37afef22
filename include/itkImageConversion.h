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
#ifndef itkImageConversion_h
#define itkImageConversion_h

#include "itkImage.h"
#include "itkImageAlgorithm.h"
#include "itkImageScanlineConstIterator.h"
#include "itkImageScanlineIterator.h"

#include <cstdint>
#include <limits>
#include <type_traits>

namespace itk
{
/** \brief A copy of a label image with the pixels of which compiled code takes label images.
 *
 * \throw ExceptionObject for a label beyond the range of int
 *
 * \ingroup MultiMaterialMeshing
 */
template <typename TLabelImage>
Image<int, 3>::Pointer
CopyToIntegers(const TLabelImage * image)
{
  const auto & region = image->GetLargestPossibleRegion();
  const auto   copy = Image<int, 3>::New();
  copy->CopyInformation(image);
  copy->SetRegions(region);
  copy->Allocate();
  ImageScanlineConstIterator<TLabelImage> from(image, region);
  ImageScanlineIterator<Image<int, 3>>    to(copy, region);
  for (; !from.IsAtEnd(); from.NextLine(), to.NextLine())
  {
    for (; !from.IsAtEndOfLine(); ++from, ++to)
    {
      const auto label = static_cast<std::int64_t>(from.Get());
      if (label > std::numeric_limits<int>::max() || label < std::numeric_limits<int>::min())
      {
        itkGenericExceptionMacro("The label " << label << " is beyond the range of labels, which is "
                                              << std::numeric_limits<int>::min() << " to "
                                              << std::numeric_limits<int>::max() << '.');
      }
      to.Set(static_cast<int>(label));
    }
  }
  return copy;
}

/** A label image with those pixels: the image itself if it has them, else a copy. */
template <typename TLabelImage>
Image<int, 3>::ConstPointer
ToIntegers(const TLabelImage * image)
{
  if constexpr (std::is_same_v<TLabelImage, Image<int, 3>>)
  {
    return image;
  }
  else
  {
    return CopyToIntegers(image).GetPointer();
  }
}

/** An image of floating-point numbers as one of `float`: the image itself if it is, else a copy. */
template <typename TImage>
Image<float, 3>::ConstPointer
ToFloats(const TImage * image)
{
  if constexpr (std::is_same_v<TImage, Image<float, 3>>)
  {
    return image;
  }
  else if (image == nullptr)
  {
    return nullptr;
  }
  else
  {
    const auto & region = image->GetBufferedRegion();
    const auto   copy = Image<float, 3>::New();
    copy->CopyInformation(image);
    copy->SetBufferedRegion(region);
    copy->Allocate();
    ImageAlgorithm::Copy(image, copy.GetPointer(), region, region);
    return copy.GetPointer();
  }
}
/** Makes an image the one of `float`, with its regions. */
template <typename TImage>
void
FromFloats(Image<float, 3> * image, TImage * output)
{
  if constexpr (std::is_convertible_v<TImage *, Image<float, 3> *>)
  {
    output->Graft(image);
  }
  else
  {
    const auto & region = image->GetBufferedRegion();
    output->CopyInformation(image);
    output->SetRegions(region);
    output->Allocate();
    ImageAlgorithm::Copy(image, output, region, region);
  }
}
} // namespace itk

#endif
