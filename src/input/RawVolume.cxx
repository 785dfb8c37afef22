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
#include "input/RawVolume.h"

#include "input/GzipFile.h"
#include "input/ImageChecks.h"
#include "input/LabelValue.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace mmm
{
namespace
{
/** Calls body.template operator()<T>() with the type of the voxels. */
template <typename TBody>
void
WithType(VoxelType type, const TBody & body)
{
  switch (type)
  {
    case VoxelType::Int8:
      return body(std::int8_t{});
    case VoxelType::UInt8:
      return body(std::uint8_t{});
    case VoxelType::Int16:
      return body(std::int16_t{});
    case VoxelType::UInt16:
      return body(std::uint16_t{});
    case VoxelType::Int32:
      return body(std::int32_t{});
    case VoxelType::UInt32:
      return body(std::uint32_t{});
    case VoxelType::Int64:
      return body(std::int64_t{});
    case VoxelType::UInt64:
      return body(std::uint64_t{});
    case VoxelType::Float32:
      return body(float{});
    case VoxelType::Float64:
      return body(double{});
  }
}

/** Before memory is taken for what a damaged header says. */
void
CheckFileSize(const RawVolume & volume, double expected)
{
  // zlib cannot do more
  constexpr double highestCompression = 1032.0;
  std::error_code  error;
  const auto       fileSize =
    static_cast<double>(std::filesystem::file_size(std::filesystem::u8path(volume.dataName), error));
  if (!error && fileSize * highestCompression < expected)
  {
    ThrowDamaged(volume.fileName,
                 "it is too short for the " + DigitsOf(expected) + " bytes of data that its header says");
  }
}

/** Calls body(value, number) for all voxels. */
template <typename TBody>
void
ForEachVoxel(const RawVolume & volume, const TBody & body)
{
  WithType(volume.type, [&](auto example) {
    using T = decltype(example);
    const std::size_t count = volume.size[0] * volume.size[1] * volume.size[2];
    const double      expected = static_cast<double>(volume.offset) + static_cast<double>(count) * sizeof(T);
    GzipFile          file(volume.dataName);
    double            held = 0.0;
    const auto        read = [&](char * bytes, std::size_t wanted) {
      const std::size_t got = file.Read(bytes, wanted);
      held += static_cast<double>(got);
      if (file.IsBroken())
      {
        ThrowDamaged(volume.fileName, "its compressed data is broken or incomplete");
      }
      if (got < wanted)
      {
        ThrowDamaged(volume.fileName,
                     "it holds " + DigitsOf(held) + " bytes of data where its header says " + DigitsOf(expected));
      }
    };
    constexpr std::size_t pieceSize = 1 << 17;
    std::vector<char>     skipped(std::min(volume.offset, pieceSize));
    for (std::size_t at = 0; at < volume.offset; at += skipped.size())
    {
      read(skipped.data(), std::min(skipped.size(), volume.offset - at));
    }
    std::vector<T> piece(std::min(count, pieceSize));
    for (std::size_t at = 0; at < count; at += piece.size())
    {
      piece.resize(std::min(piece.size(), count - at));
      read(reinterpret_cast<char *>(piece.data()), piece.size() * sizeof(T));
      for (std::size_t i = 0; i < piece.size(); ++i)
      {
        if (volume.isSwapped)
        {
          auto * const bytes = reinterpret_cast<char *>(&piece[i]);
          std::reverse(bytes, bytes + sizeof(T));
        }
        if (volume.isScaled)
        {
          body(static_cast<double>(piece[i]) * volume.slope + volume.intercept, at + i);
        }
        else
        {
          body(piece[i], at + i);
        }
      }
    }
    // the check sum comes last
    skipped.resize(pieceSize);
    while (file.Read(skipped.data(), skipped.size()) > 0)
    {
    }
    if (file.IsBroken())
    {
      ThrowDamaged(volume.fileName, "its compressed data is broken or incomplete");
    }
  });
}

template <typename TPixel>
typename itk::Image<TPixel, 3>::Pointer
MakeImage(const RawVolume & volume)
{
  WithType(volume.type, [&](auto example) {
    CheckFileSize(volume,
                  static_cast<double>(volume.offset) + static_cast<double>(volume.size[0]) *
                                                         static_cast<double>(volume.size[1]) *
                                                         static_cast<double>(volume.size[2]) * sizeof(example));
  });
  const auto image = itk::Image<TPixel, 3>::New();
  image->SetRegions(volume.size);
  image->Allocate();
  SetAffine(volume.affine, *image);
  return image;
}
} // namespace

itk::Image<int, 3>::Pointer
ReadLabels(const RawVolume & volume)
{
  const auto image = MakeImage<int>(volume);
  int *      label = image->GetBufferPointer();
  // Programs that scale real numbers to integers round by up to half a step.
  const double tolerance = volume.isScaled
                             ? std::max(WholeNumberTolerance, std::min(0.51 * std::abs(volume.slope), 0.05))
                             : WholeNumberTolerance;
  ForEachVoxel(volume, [&](auto value, std::size_t n) {
    if (!IsLabel(value, tolerance, label[n]))
    {
      ThrowNoLabel(volume.fileName, volume.size, n, value);
    }
  });
  return image;
}

itk::Image<float, 3>::Pointer
ReadScalars(const RawVolume & volume)
{
  const auto image = MakeImage<float>(volume);
  float *    scalar = image->GetBufferPointer();
  ForEachVoxel(volume, [&](auto value, std::size_t n) { scalar[n] = static_cast<float>(value); });
  return image;
}

std::vector<itk::Image<float, 3>::Pointer>
ReadComponents(const RawVolume & volume, unsigned int count)
{
  std::vector<itk::Image<float, 3>::Pointer> images;
  RawVolume                                  component = volume;
  for (unsigned int n = 0; n < count; ++n)
  {
    images.push_back(ReadScalars(component));
    WithType(volume.type, [&](auto example) {
      component.offset += volume.size[0] * volume.size[1] * volume.size[2] * sizeof(example);
    });
  }
  return images;
}
} // namespace mmm
