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

#include "image/MaterialImage.h"
#include "itkLabelImageStages.h"

#include "itkImageScanlineConstIterator.h"

#include <vector>

namespace mmm
{
/** Calls body(label, count) for the runs of equal labels of an image, in the order of its buffer. */
template <typename TBody>
void
ForEachRun(const LabelImage * image, const TBody & body)
{
  itk::ImageScanlineConstIterator<LabelImage> it(image, image->GetLargestPossibleRegion());
  for (; !it.IsAtEnd(); it.NextLine())
  {
    while (!it.IsAtEndOfLine())
    {
      const int   label = it.Get();
      std::size_t count = 0;
      for (; !it.IsAtEndOfLine() && it.Get() == label; ++it)
      {
        ++count;
      }
      body(label, count);
    }
  }
}

/** The labels of an image, sorted. Throws where there are no interfaces, or more labels than materials. */
std::vector<int>
LabelsOf(const LabelImage * image);

/** The image in the core's terms. `labels` are those of the image, sorted: a material is a place in this list. */
MaterialImage
MakeMaterialImage(const LabelImage * image, const std::vector<int> & labels);
} // namespace mmm

#endif
