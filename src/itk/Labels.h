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
#ifndef mmmLabels_h
#define mmmLabels_h

#include "MultiMaterialMeshingReports.h"
#include "itk/GridGeometry.h"
#include "image/MaterialImage.h"

#include "itkImageScanlineConstIterator.h"
#include "itkNumericTraits.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace mmm
{
/** Calls body(label, count) for the runs of equal labels of an image, in the order of its buffer. Throws
 * itk::ExceptionObject for a label beyond the range of int. */
template <typename TLabelImage, typename TBody>
void
ForEachRun(const TLabelImage * image, const TBody & body)
{
  using PixelType = typename TLabelImage::PixelType;
  itk::ImageScanlineConstIterator<TLabelImage> it(image, image->GetLargestPossibleRegion());
  for (; !it.IsAtEnd(); it.NextLine())
  {
    while (!it.IsAtEndOfLine())
    {
      const PixelType pixel = it.Get();
      std::size_t     count = 0;
      for (; !it.IsAtEndOfLine() && it.Get() == pixel; ++it)
      {
        ++count;
      }
      const auto value = static_cast<std::int64_t>(pixel);
      if (value > std::numeric_limits<int>::max() || value < std::numeric_limits<int>::min())
      {
        itkGenericExceptionMacro("The label " << value << " is beyond the range of labels, which is "
                                              << std::numeric_limits<int>::min() << " to "
                                              << std::numeric_limits<int>::max() << '.');
      }
      body(static_cast<int>(value), count);
    }
  }
}

/** How many voxels each label of an image has. */
template <typename TLabelImage>
LabelCounts
CountLabels(const TLabelImage * image)
{
  LabelCounts counts;
  auto        last = counts.end();
  ForEachRun(image, [&](int label, std::size_t count) {
    if (last == counts.end() || last->first != label)
    {
      last = counts.insert({ label, 0 }).first;
    }
    last->second += count;
  });
  return counts;
}

/** The image in the core's terms. `labels` are those of the image, sorted: a material is a place in this list. */
template <typename TLabelImage>
MaterialImage
MakeMaterialImage(const TLabelImage * image, const std::vector<int> & labels)
{
  MaterialImage materials;
  materials.grid = GridGeometry(image, image->GetLargestPossibleRegion()).GetGrid();
  materials.numberOfMaterials = labels.size();
  materials.materials.reserve(materials.grid.NumberOfNodes());
  ForEachRun(image, [&](int label, std::size_t count) {
    const auto place = std::lower_bound(labels.begin(), labels.end(), label) - labels.begin();
    materials.materials.insert(materials.materials.end(), count, static_cast<Material>(place));
  });
  return materials;
}
} // namespace mmm

#endif
