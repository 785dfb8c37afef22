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
#include "itk/LabelDomain.h"
#include "itk/SizingOptions.h"
#include "itkLabelMeshing.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace mmm
{
namespace
{
/** What is wrong with the place of an image; empty if nothing is, or there is none. */
std::string
DescribePlace(const itk::ImageBase<3> * labels, const itk::ImageBase<3> * image, const std::string & name)
{
  std::ostringstream words;
  if (image == nullptr)
  {
    return std::string();
  }
  if (!HaveSameGeometry(labels, image))
  {
    words << "The " << name << " differs from the label image in origin, spacing or direction.";
  }
  else if (labels->GetLargestPossibleRegion() != image->GetLargestPossibleRegion())
  {
    words << "The " << name << " has " << image->GetLargestPossibleRegion().GetSize() << " voxels and the label image "
          << labels->GetLargestPossibleRegion().GetSize() << ". They must be on the same grid.";
  }
  return words.str();
}
} // namespace

std::string
DescribeError(const LabelMeshingInputs & inputs)
{
  const LabelOptions & options = inputs.options;
  std::ostringstream   words;
  if (options.radius < 0.0 || std::isinf(options.radius))
  {
    words << "The radius is " << options.radius << " mm. It must be finite and not negative.";
  }
  else if (options.airMargin < 0.0 || std::isinf(options.airMargin))
  {
    words << "The air margin is " << options.airMargin << " mm. It must be finite and not negative.";
  }
  else if (IsFilled(options) && options.exteriorLabels.empty())
  {
    words << "The exterior is to be filled, but no label is exterior.";
  }
  else if (options.exteriorLabels.empty() &&
           std::any_of(inputs.electrodes.list.begin(), inputs.electrodes.list.end(), [](const Electrode & electrode) {
             return electrode.IsOnSkin();
           }))
  {
    words << "Electrodes stand on the skin, where exterior begins, but no label is exterior.";
  }
  else
  {
    const std::string error = DescribeError(inputs.surfaces);
    words << (error.empty() ? DescribeError(inputs.meshing, inputs.sizing) : error);
  }
  return words.str();
}

std::string
DescribeGeometryError(const itk::ImageBase<3> * labels, const SizingInputs & sizing)
{
  const std::string error = DescribePlace(labels, sizing.image, "sizing image");
  return error.empty() ? DescribePlace(labels, sizing.region, "region of interest") : error;
}

std::string
DescribeGeometryError(const itk::ImageBase<3> * labels, const SurfaceInputs & surfaces)
{
  for (std::size_t k = 0; k < surfaces.distances.size(); ++k)
  {
    const std::string error =
      DescribePlace(labels, surfaces.distances[k], "surface distance image " + std::to_string(k));
    if (!error.empty())
    {
      return error;
    }
  }
  return "";
}
} // namespace mmm
