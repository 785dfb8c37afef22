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
#include "input/SegmentLayers.h"

#include "itkMetaDataObject.h"

#include <algorithm>
#include <cstdlib>
#include <locale>
#include <set>
#include <sstream>

namespace mmm
{
namespace
{
/** "0.5 0.7 0.5" */
std::optional<std::array<double, 3>>
ParseColor(const std::string & text)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  std::array<double, 3> color;
  for (double & component : color)
  {
    if (!(stream >> component))
    {
      return std::nullopt;
    }
    component = std::clamp(component, 0.0, 1.0);
  }
  return color;
}
} // namespace

std::vector<Segment>
FindSegments(const itk::ImageIOBase & io)
{
  std::vector<Segment> segments;
  std::set<int>        values;
  const auto &         fields = io.GetMetaDataDictionary();
  const auto           get = [&](const std::string & key, std::string & text) {
    return itk::ExposeMetaData<std::string>(fields, "Segment" + std::to_string(segments.size()) + '_' + key, text);
  };
  std::string value;
  std::string layer;
  while (get("LabelValue", value) && get("Layer", layer))
  {
    Segment segment;
    segment.value = std::atoi(value.c_str());
    segment.layer = static_cast<unsigned int>(std::atoi(layer.c_str()));
    segment.label = segment.value;
    get("Name", segment.name);
    std::string color;
    get("Color", color);
    segment.color = ParseColor(color);
    if (segment.layer >= io.GetNumberOfComponents())
    {
      return {};
    }
    values.insert(segment.value);
    segments.push_back(segment);
  }
  if (values.size() < segments.size())
  {
    for (std::size_t s = 0; s < segments.size(); ++s)
    {
      segments[s].label = static_cast<int>(s) + 1;
    }
  }
  return segments;
}

itk::Image<int, 3>::Pointer
Flatten(const itk::VectorImage<int, 3> & layers, const std::vector<Segment> & segments)
{
  const auto image = itk::Image<int, 3>::New();
  image->CopyInformation(&layers);
  image->SetRegions(layers.GetBufferedRegion());
  image->Allocate();
  const std::size_t count = layers.GetBufferedRegion().GetNumberOfPixels();
  const std::size_t stride = layers.GetNumberOfComponentsPerPixel();
  const int *       voxel = layers.GetBufferPointer();
  for (std::size_t n = 0; n < count; ++n, voxel += stride)
  {
    int label = 0;
    for (const Segment & segment : segments)
    {
      label = voxel[segment.layer] == segment.value ? segment.label : label;
    }
    image->GetBufferPointer()[n] = label;
  }
  return image;
}
} // namespace mmm
