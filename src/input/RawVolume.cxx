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

#include "input/ImageChecks.h"
#include "input/LabelValue.h"
#include "input/NiftiHeader.h"

#include "itkByteSwapper.h"
#include "itk_zlib.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <memory>

namespace mmm
{
namespace
{
namespace fs = std::filesystem;

/** A file, whether it is compressed or not. */
class GzipFile
{
public:
  explicit GzipFile(const std::string & fileName)
#ifdef _WIN32
    : m_File(gzopen_w(fs::u8path(fileName).c_str(), "rb"), gzclose)
#else
    : m_File(gzopen(fileName.c_str(), "rb"), gzclose)
#endif
  {}

  /** Returns how many bytes were there. */
  std::size_t
  Read(char * bytes, std::size_t count)
  {
    const int read = m_File ? gzread(m_File.get(), bytes, static_cast<unsigned int>(count)) : 0;
    return read > 0 ? static_cast<std::size_t>(read) : 0;
  }

  bool
  IsBroken() const
  {
    int error = Z_OK;
    if (m_File)
    {
      gzerror(m_File.get(), &error);
    }
    return error != Z_OK && error != Z_STREAM_END;
  }

private:
  std::unique_ptr<gzFile_s, int (*)(gzFile)> m_File;
};

std::vector<char>
FirstBytes(const std::string & fileName, std::size_t count)
{
  GzipFile          file(fileName);
  std::vector<char> bytes(count);
  bytes.resize(file.Read(bytes.data(), count));
  if (file.IsBroken())
  {
    ThrowDamaged(fileName, "its compressed data is broken or incomplete");
  }
  return bytes;
}

/** The name with another extension, if there is such a file; else empty. */
std::string
Sibling(const std::string & fileName, const std::string & extension)
{
  fs::path path = fs::u8path(fileName);
  if (path.extension() == ".gz")
  {
    path.replace_extension();
  }
  path.replace_extension(extension);
  std::error_code ignored;
  return fs::exists(path, ignored) ? path.u8string() : "";
}

std::string
FirstOf(const std::string & a, const std::string & b)
{
  return a.empty() ? b : a;
}

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
  const auto       fileSize = static_cast<double>(fs::file_size(fs::u8path(volume.dataName), error));
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

/** The names of types are those of NIfTI. */
VoxelType
NiftiType(const std::string & fileName, int type)
{
  const std::map<int, VoxelType> types{ { 2, VoxelType::UInt8 },    { 4, VoxelType::Int16 },
                                        { 8, VoxelType::Int32 },    { 16, VoxelType::Float32 },
                                        { 64, VoxelType::Float64 }, { 256, VoxelType::Int8 },
                                        { 512, VoxelType::UInt16 }, { 768, VoxelType::UInt32 },
                                        { 1024, VoxelType::Int64 }, { 1280, VoxelType::UInt64 } };
  const auto                     found = types.find(type);
  if (found != types.end())
  {
    return found->second;
  }
  const std::map<int, std::string> others{ { 1, "bits" },
                                           { 32, "complex numbers" },
                                           { 128, "colors" },
                                           { 2304, "colors" },
                                           { 1792, "complex numbers" },
                                           { 2048, "complex numbers" },
                                           { 1536, "numbers of 128 bits" } };
  const auto                       other = others.find(type);
  if (other == others.end())
  {
    ThrowDamaged(fileName, "its data type " + std::to_string(type) + " is unknown");
  }
  itkGenericExceptionMacro(<< fileName << ": the voxels are " << other->second
                           << "; an image with one number per voxel is needed");
}

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

bool
HasExtension(const std::string & fileName, const std::vector<std::string> & extensions)
{
  std::string extension = fs::u8path(fileName).extension().u8string();
  std::transform(
    extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}
} // namespace

std::optional<RawVolume>
OpenNifti(const std::string & fileName)
{
  constexpr std::size_t headerSize = 540;
  NiftiHeader           header;
  std::string           headerName = fileName;
  if (!ParseNiftiHeader(FirstBytes(fileName, headerSize), header))
  {
    // an image of a pair
    headerName =
      HasExtension(fileName, { ".img", ".gz" }) ? FirstOf(Sibling(fileName, ".hdr"), Sibling(fileName, ".hdr.gz")) : "";
    if (headerName.empty() || !ParseNiftiHeader(FirstBytes(headerName, headerSize), header) || !header.isPair)
    {
      return std::nullopt;
    }
  }
  RawVolume volume;
  volume.fileName = fileName;
  volume.dataName = fileName;
  if (header.isPair)
  {
    volume.dataName =
      headerName == fileName ? FirstOf(Sibling(fileName, ".img"), Sibling(fileName, ".img.gz")) : fileName;
    if (volume.dataName.empty())
    {
      itkGenericExceptionMacro(<< fileName << ": the file with the voxels, .img, is not beside it");
    }
  }
  volume.size = CheckDimensions(fileName, header.size);
  volume.type = NiftiType(fileName, header.dataType);
  volume.isSwapped = header.isSwapped;
  volume.isScaled = header.IsScaled();
  volume.slope = header.slope;
  volume.intercept = header.intercept;
  // what some programs leave out
  const double standard = header.isPair ? 0.0 : 352.0;
  const double offset = header.dataOffset == 0.0 ? standard : header.dataOffset;
  if (!(offset >= (header.isPair ? 0.0 : 348.0) && offset < 1e15))
  {
    ThrowDamaged(fileName, "its header says that the data begins at byte " + DigitsOf(offset) + " (vox_offset)");
  }
  volume.offset = static_cast<std::size_t>(offset);
  try
  {
    volume.affine = PlaceOf(header, volume.notes);
  }
  catch (const itk::ExceptionObject & exception)
  {
    std::string reason = exception.GetDescription();
    itkGenericExceptionMacro(<< fileName << ": the image has no place: "
                             << reason.substr(reason.find(": ") == std::string::npos ? 0 : reason.find(": ") + 2));
  }
  return volume;
}

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
} // namespace mmm
