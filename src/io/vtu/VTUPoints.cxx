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
#include "io/vtu/VTUPoints.h"
#include "io/vtu/VTUFormat.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

namespace mmm
{
namespace
{
VTUValues
IntegersToDoubles(const VTUValues & integers)
{
  VTUValues doubles{ itk::IOComponentEnum::DOUBLE, integers.count, {} };
  doubles.bytes.resize(integers.count * sizeof(double));
  for (std::size_t i = 0; i < integers.count; ++i)
  {
    const auto value = static_cast<double>(integers.IntegerAt(i));
    std::memcpy(&doubles.bytes[i * sizeof value], &value, sizeof value);
  }
  return doubles;
}

bool
IsRAS(std::istream & file, const VTUDocument & document)
{
  return std::any_of(document.fieldData.begin(), document.fieldData.end(), [&](const VTUArray & array) {
    return array.name == "SPACE" && array.type == "String" && ReadVTUString(file, document, array) == "RAS";
  });
}

void
ConvertRASToLPS(VTUValues & points)
{
  VisitComponentType(points.type, [&](auto value) {
    for (std::size_t i = 0; i < points.count; ++i)
    {
      if (i % vtuDimension != 2)
      {
        std::memcpy(&value, &points.bytes[i * sizeof value], sizeof value);
        value = -value;
        std::memcpy(&points.bytes[i * sizeof value], &value, sizeof value);
      }
    }
  });
}
} // namespace

VTUValues
ReadVTUPoints(std::istream & file, const VTUDocument & document)
{
  if (document.numberOfPoints == 0)
  {
    return { itk::IOComponentEnum::FLOAT, 0, {} };
  }
  if (document.points.empty() || document.points[0].numberOfComponents != vtuDimension)
  {
    throw MeshFileError("its points must be an array of three components");
  }
  if (document.numberOfPoints > std::numeric_limits<std::uint64_t>::max() / vtuDimension)
  {
    throw MeshFileError("it announces more points than there can be");
  }
  VTUValues points = ReadVTUArray(file, document, document.points[0], document.numberOfPoints * vtuDimension);
  if (points.type != itk::IOComponentEnum::FLOAT && points.type != itk::IOComponentEnum::DOUBLE)
  {
    points = IntegersToDoubles(points);
  }
  if (IsRAS(file, document))
  {
    ConvertRASToLPS(points);
  }
  return points;
}

std::string
EncodeVTUPoints(const void *         buffer,
                itk::IOComponentEnum type,
                std::size_t          numberOfPoints,
                unsigned int         dimension,
                VTUEncoding          encoding)
{
  if (dimension < 1 || dimension > vtuDimension)
  {
    throw MeshFileError("its points have " + std::to_string(dimension) + " coordinates; .vtu files have three");
  }
  return VisitComponentType(type, [&](auto zero) {
    using T = decltype(zero);
    using Stored = std::conditional_t<std::is_floating_point_v<T> && (sizeof(T) > sizeof(float)), double, float>;
    const auto *    values = static_cast<const T *>(buffer);
    VTUArrayEncoder encoder(encoding, numberOfPoints * vtuDimension * sizeof(Stored));
    for (std::size_t i = 0; i < numberOfPoints; ++i)
    {
      for (unsigned int axis = 0; axis < vtuDimension; ++axis)
      {
        encoder.Push(axis < dimension ? static_cast<Stored>(*values++) : Stored{ 0 });
      }
    }
    const char * const typeName = std::is_same_v<Stored, double> ? "Float64" : "Float32";
    return VTUArrayElement(typeName, "Points", vtuDimension, encoding, encoder.Finish());
  });
}
} // namespace mmm
