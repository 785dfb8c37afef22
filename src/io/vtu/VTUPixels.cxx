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
#include "io/vtu/VTUPixels.h"
#include "io/vtu/VTUFormat.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

namespace mmm
{
namespace
{
const VTUArray *
Find(const std::vector<VTUArray> & arrays, const std::string & name)
{
  const auto found =
    std::find_if(arrays.begin(), arrays.end(), [&](const VTUArray & array) { return array.name == name; });
  return found == arrays.end() ? nullptr : &*found;
}

bool
CanJoin(const std::vector<VTUArray> & arrays)
{
  return std::all_of(arrays.begin(), arrays.end(), [&](const VTUArray & array) {
    return array.numberOfComponents == 1 && array.type == arrays.front().type;
  });
}
} // namespace

std::vector<VTUArray>
SelectPixelArrays(const std::vector<VTUArray> &    arrays,
                  const std::vector<std::string> & names,
                  const std::string &              prefix)
{
  std::vector<VTUArray> selected;
  for (const std::string & name : names)
  {
    if (const VTUArray * const array = Find(arrays, name))
    {
      selected.push_back(*array);
    }
  }
  if (!names.empty() && selected.size() == names.size() && (selected.size() == 1 || CanJoin(selected)))
  {
    return selected;
  }
  selected.clear();
  if (!prefix.empty())
  {
    for (char suffix = 'a'; suffix <= 'z'; ++suffix)
    {
      const VTUArray * const array = Find(arrays, prefix + '_' + suffix);
      if (array == nullptr)
      {
        break;
      }
      selected.push_back(*array);
    }
    if (selected.size() >= 2 && CanJoin(selected))
    {
      return selected;
    }
    if (const VTUArray * const array = Find(arrays, prefix))
    {
      return { *array };
    }
  }
  return { arrays.begin(), arrays.begin() + std::min<std::size_t>(arrays.size(), 1) };
}

VTUPixels
ReadVTUPixels(std::istream &                file,
              const VTUDocument &           document,
              const std::vector<VTUArray> & arrays,
              std::uint64_t                 numberOfPixels)
{
  VTUPixels pixels;
  if (arrays.size() == 1)
  {
    const std::uint64_t components = arrays[0].numberOfComponents;
    // ITK counts components by an unsigned int.
    if (components == 0 || components > std::numeric_limits<unsigned int>::max() ||
        numberOfPixels > std::numeric_limits<std::uint64_t>::max() / components)
    {
      throw MeshFileError("its array \"" + arrays[0].name + "\" has " + std::to_string(components) + " components");
    }
    pixels.values = ReadVTUArray(file, document, arrays[0], numberOfPixels * components);
    pixels.numberOfComponents = static_cast<std::size_t>(components);
    return pixels;
  }
  pixels.numberOfComponents = arrays.size();
  for (std::size_t component = 0; component < arrays.size(); ++component)
  {
    const VTUValues   values = ReadVTUArray(file, document, arrays[component], numberOfPixels);
    const std::size_t size = values.ValueSize();
    pixels.values.type = values.type;
    pixels.values.count = values.count * arrays.size();
    pixels.values.bytes.resize(pixels.values.count * size);
    for (std::size_t i = 0; i < values.count; ++i)
    {
      std::memcpy(&pixels.values.bytes[(i * arrays.size() + component) * size], &values.bytes[i * size], size);
    }
  }
  return pixels;
}

std::string
EncodeVTUPixels(const void *                     buffer,
                itk::IOComponentEnum             type,
                std::size_t                      numberOfPixels,
                std::size_t                      numberOfComponents,
                const std::vector<std::string> & names,
                VTUEncoding                      encoding)
{
  return VisitComponentType(type, [&](auto zero) {
    using T = decltype(zero);
    using Stored = std::conditional_t<std::is_same_v<T, long double>, double, T>;
    const auto * const values = static_cast<const T *>(buffer);
    const std::size_t  perArray = names.size() == numberOfComponents ? 1 : numberOfComponents;
    std::string        elements;
    for (std::size_t first = 0; first < numberOfComponents; first += perArray)
    {
      VTUArrayEncoder encoder(encoding, numberOfPixels * perArray * sizeof(Stored));
      for (std::size_t i = 0; i < numberOfPixels; ++i)
      {
        for (std::size_t component = first; component < first + perArray; ++component)
        {
          encoder.Push(static_cast<Stored>(values[i * numberOfComponents + component]));
        }
      }
      elements += VTUArrayElement(VTUTypeName(type), names[first], perArray, encoding, encoder.Finish());
    }
    return elements;
  });
}
} // namespace mmm
