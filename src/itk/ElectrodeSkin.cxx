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
#include "itk/ElectrodeSkin.h"

#include "itkImageRegionConstIteratorWithIndex.h"

namespace mmm
{
itk::ImageRegion<3>
WithExteriorAround(itk::ImageRegion<3> region)
{
  constexpr itk::SizeValueType margin = 4; // more than the band of distances
  region.PadByRadius(margin);
  return region;
}

std::unique_ptr<Skin>
MakeSkin(const LabelImage & labels, const std::vector<int> & exteriorLabels, const GridGeometry & geometry)
{
  const Grid &      grid = geometry.GetGrid();
  const auto &      first = geometry.GetRegion().GetIndex();
  const auto &      region = labels.GetLargestPossibleRegion();
  std::vector<bool> isExterior(grid.NumberOfNodes(), true);
  bool              hasExterior = false;
  for (itk::ImageRegionConstIteratorWithIndex<LabelImage> it(&labels, region); !it.IsAtEnd(); ++it)
  {
    const auto & at = it.GetIndex();
    const bool   isThere = Contains(exteriorLabels, it.Get());
    isExterior[grid.Offset(int(at[0] - first[0]), int(at[1] - first[1]), int(at[2] - first[2]))] = isThere;
    hasExterior = hasExterior || isThere;
  }
  if (!hasExterior)
  {
    itkGenericExceptionMacro("There is no skin to put electrodes on: the image has no exterior.");
  }
  return std::make_unique<Skin>(grid, isExterior);
}
} // namespace mmm
