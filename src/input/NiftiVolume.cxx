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
#include "input/LabelValue.h"
#include "input/NiftiHeader.h"
#include "input/RawVolume.h"

#include <filesystem>
#include <map>

namespace mmm
{
namespace
{
namespace fs = std::filesystem;

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

bool
HasSymmetricMatrices(const NiftiHeader & header)
{
  constexpr int symmetricMatrix = 1005;
  return header.intent == symmetricMatrix && header.size.size() == 5 && header.size[3] == 1 && header.size[4] == 6;
}

/** Nothing if the file is not one of NIfTI, or not one of `tensors` where these are asked for. */
std::optional<RawVolume>
Open(const std::string & fileName, bool tensors)
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
  if (tensors)
  {
    if (!HasSymmetricMatrices(header))
    {
      return std::nullopt;
    }
    header.size.resize(3);
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
} // namespace

std::optional<RawVolume>
OpenNifti(const std::string & fileName)
{
  return Open(fileName, false);
}

std::optional<RawVolume>
OpenNiftiTensors(const std::string & fileName)
{
  return Open(fileName, true);
}
} // namespace mmm
