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
#include "input/GzipFile.h"
#include "input/ImageChecks.h"
#include "input/RawVolume.h"

#include "itkByteSwapper.h"

#include <cstring>
#include <map>

namespace mmm
{
namespace
{
/** Numbers of FreeSurfer's files, which begin with the most significant byte. */
template <typename T>
T
GetBigEndian(const std::vector<char> & bytes, std::size_t offset)
{
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  itk::ByteSwapper<T>::SwapFromSystemToBigEndian(&value);
  return value;
}
} // namespace

std::optional<RawVolume>
OpenMGH(const std::string & fileName)
{
  constexpr std::size_t headerSize = 284;
  const auto            bytes = FirstBytes(fileName, headerSize);
  if (!HasExtension(fileName, { ".mgh", ".mgz", ".gz" }) || bytes.size() < headerSize ||
      GetBigEndian<std::int32_t>(bytes, 0) != 1)
  {
    return std::nullopt;
  }
  RawVolume volume;
  volume.fileName = fileName;
  volume.dataName = fileName;
  volume.offset = headerSize;
  const auto                integer = [&](std::size_t n) { return GetBigEndian<std::int32_t>(bytes, 4 * n); };
  std::vector<std::int64_t> size{ integer(1), integer(2), integer(3), integer(4) };
  volume.size = CheckDimensions(fileName, size);
  const std::map<int, VoxelType> types{
    { 0, VoxelType::UInt8 }, { 1, VoxelType::Int32 }, { 3, VoxelType::Float32 }, { 4, VoxelType::Int16 }
  };
  const auto type = types.find(integer(5));
  if (type == types.end())
  {
    ThrowDamaged(fileName, "its data type " + std::to_string(integer(5)) + " is unknown");
  }
  volume.type = type->second;
  std::uint16_t one = 1;
  volume.isSwapped = *reinterpret_cast<const char *>(&one) == 1;
  // spacing, three columns of directions and the center, all in RAS; without them, FreeSurfer's coronal slices of 1 mm
  float numbers[15] = { 1, 1, 1, -1, 0, 0, 0, 0, -1, 0, 1, 0, 0, 0, 0 };
  if (GetBigEndian<std::int16_t>(bytes, 28) > 0)
  {
    for (std::size_t n = 0; n < 15; ++n)
    {
      numbers[n] = GetBigEndian<float>(bytes, 30 + 4 * n);
    }
  }
  Affine affine;
  for (unsigned int row = 0; row < 3; ++row)
  {
    affine.origin[row] = numbers[12 + row];
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      affine.steps[axis][row] = numbers[3 + 3 * axis + row] * numbers[axis];
      // FreeSurfer's center is voxel n/2
      affine.origin[row] -= affine.steps[axis][row] * 0.5 * static_cast<double>(volume.size[axis]);
    }
  }
  const std::string fault = FindFault(affine);
  if (!fault.empty())
  {
    itkGenericExceptionMacro(<< fileName << ": the image has no place: " << fault << "; correct the header first");
  }
  volume.affine = FromRAS(affine);
  return volume;
}
} // namespace mmm
