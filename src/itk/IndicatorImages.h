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

#include "itk/GridGeometry.h"
#include "indicators/IndicatorSet.h"
#include "indicators/IndicatorSmoothing.h"

#include <vector>

namespace mmm
{
/** \brief The indicator images of a filter's inputs as one grid, with an indicator each.
 *
 * The grid covers the largest possible regions of all images, which have the same origin, spacing and direction. The
 * images must outlive this object. */
template <typename TIndicatorImage>
class IndicatorImages
{
public:
  explicit IndicatorImages(std::vector<const TIndicatorImage *> images)
    : m_Images(std::move(images))
    , m_Region(UnionOfRegions({ m_Images.begin(), m_Images.end() }))
    , m_Geometry(m_Images.front(), m_Region)
  {}

  const itk::ImageRegion<3> &
  GetRegion() const
  {
    return m_Region;
  }
  const GridGeometry &
  GetGeometry() const
  {
    return m_Geometry;
  }

  /** The indicators in the grid's unit. */
  IndicatorSet
  MakeIndicatorSet() const
  {
    std::vector<IndicatorBricks> indicators;
    for (const auto * image : m_Images)
    {
      const auto &           buffered = image->GetBufferedRegion();
      BlockView<const float> view;
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        view.lower[axis] = static_cast<int>(buffered.GetIndex(axis) - m_Region.GetIndex(axis));
        view.size[axis] = static_cast<int>(buffered.GetSize(axis));
      }
      view.values = image->GetBufferPointer();
      indicators.emplace_back(
        m_Geometry.GetGrid(), view, -float(IndicatorBandWidth), static_cast<float>(1.0 / m_Geometry.GetUnit()));
    }
    return IndicatorSet(m_Geometry.GetGrid(), std::move(indicators), -IndicatorBandWidth);
  }

private:
  std::vector<const TIndicatorImage *> m_Images;
  itk::ImageRegion<3>                  m_Region;
  GridGeometry                         m_Geometry;
};
} // namespace mmm

#endif
