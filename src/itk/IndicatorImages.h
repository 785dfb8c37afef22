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
#ifndef mmmIndicatorImages_h
#define mmmIndicatorImages_h

#include "indicators/IndicatorSet.h"
#include "itk/GridGeometry.h"
#include "itkIndicatorImageStages.h"

#include <string>
#include <vector>

namespace mmm
{
/** \brief The indicator images of a filter's inputs as one grid, with an indicator each.
 *
 * The grid covers the largest possible regions of all images, which have the same origin, spacing and direction. The
 * images must outlive this object. */
class IndicatorImages
{
public:
  explicit IndicatorImages(const std::vector<const FloatImage *> & images);

  const GridGeometry &
  GetGeometry() const
  {
    return m_Geometry;
  }

  /** The indicators in the grid's unit. */
  IndicatorSet
  MakeIndicatorSet() const;

private:
  std::vector<const FloatImage *> m_Images;
  GridGeometry                    m_Geometry;
};

/** What is wrong with the number of images and labels, in a sentence; empty if nothing is. */
std::string
DescribeError(const IndicatorInputs & inputs);
} // namespace mmm

#endif
