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
#include "itk/IndicatorImages.h"

#include "indicators/IndicatorSmoothing.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace mmm
{
IndicatorImages::IndicatorImages(const std::vector<const FloatImage *> & images)
  : m_Images(images)
  , m_Geometry(images.front(), UnionOfRegions(images))
{}

IndicatorSet
IndicatorImages::MakeIndicatorSet() const
{
  std::vector<IndicatorBricks> indicators;
  for (const auto * image : m_Images)
  {
    const auto &           buffered = image->GetBufferedRegion();
    BlockView<const float> view;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      view.lower[axis] = static_cast<int>(buffered.GetIndex(axis) - m_Geometry.GetRegion().GetIndex(axis));
      view.size[axis] = static_cast<int>(buffered.GetSize(axis));
    }
    view.values = image->GetBufferPointer();
    indicators.emplace_back(
      m_Geometry.GetGrid(), view, -float(IndicatorBandWidth), static_cast<float>(1.0 / m_Geometry.GetUnit()));
  }
  return IndicatorSet(m_Geometry.GetGrid(), std::move(indicators), -IndicatorBandWidth);
}

itk::ImageRegion<3>
UnionOfRegions(const std::vector<const FloatImage *> & images)
{
  auto lower = images.front()->GetLargestPossibleRegion().GetIndex();
  auto upper = images.front()->GetLargestPossibleRegion().GetUpperIndex();
  for (const auto * image : images)
  {
    const auto & region = image->GetLargestPossibleRegion();
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      lower[axis] = std::min(lower[axis], region.GetIndex(axis));
      upper[axis] = std::max(upper[axis], region.GetUpperIndex()[axis]);
    }
  }
  itk::ImageRegion<3> whole;
  whole.SetIndex(lower);
  whole.SetUpperIndex(upper);
  return whole;
}

bool
HaveSameGeometry(const itk::ImageBase<3> * a, const itk::ImageBase<3> * b)
{
  // files in single precision, such as NIfTI, are to match
  constexpr double tolerance = 1e-4;
  const double     lengthTolerance = tolerance * std::abs(a->GetSpacing()[0]);
  return a->GetOrigin().GetVnlVector().is_equal(b->GetOrigin().GetVnlVector(), lengthTolerance) &&
         a->GetSpacing().GetVnlVector().is_equal(b->GetSpacing().GetVnlVector(), lengthTolerance) &&
         a->GetDirection().GetVnlMatrix().as_ref().is_equal(b->GetDirection().GetVnlMatrix().as_ref(), tolerance);
}
std::string
DescribeError(const IndicatorInputs & inputs)
{
  const auto &       images = inputs.images;
  const auto         missing = std::find(images.begin(), images.end(), nullptr);
  std::ostringstream words;
  if (missing != images.end())
  {
    words << "Input " << missing - images.begin() << " of " << images.size() << " is missing.";
  }
  else if (inputs.labels.size() != images.size())
  {
    words << "There are " << inputs.labels.size() << " labels for " << images.size() << " indicator images.";
  }
  else if (inputs.exterior < -1 || inputs.exterior >= static_cast<int>(images.size()))
  {
    words << "ExteriorIndex is " << inputs.exterior << ", but there are " << images.size() << " indicator images.";
  }
  else if (inputs.exterior == 0 && images.size() == 1)
  {
    words << "There is nothing but exterior.";
  }
  return words.str();
}
} // namespace mmm
