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
#ifndef mmmRawVolume_h
#define mmmRawVolume_h

#include "input/Affine.h"

#include "itkImage.h"

#include <optional>
#include <string>
#include <vector>

namespace mmm
{
enum class VoxelType
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Int64,
  UInt64,
  Float32,
  Float64
};

/** \brief A file of voxels one after the other behind a header, which may be compressed by gzip. */
struct RawVolume
{
  /** As the user knows it. */
  std::string fileName;
  /** Where the voxels are. */
  std::string              dataName;
  std::size_t              offset{ 0 };
  itk::Size<3>             size{ { 0, 0, 0 } };
  VoxelType                type{ VoxelType::UInt8 };
  bool                     isSwapped{ false };
  bool                     isScaled{ false };
  double                   slope{ 1.0 };
  double                   intercept{ 0.0 };
  Affine                   affine;
  std::vector<std::string> notes;
};

/** Nothing if the file is another one than of NIfTI (.nii, .hdr and .img) or of FreeSurfer (.mgh, .mgz). Throw
 * itk::ExceptionObject if the header is of no use. */
std::optional<RawVolume>
OpenNifti(const std::string & fileName);
std::optional<RawVolume>
OpenMGH(const std::string & fileName);

/** Nothing if the file is not one of NIfTI that has a symmetric matrix in each voxel (intent 1005, a size of x, y, z,
 * 1, 6). It is that of the first of the six components. */
std::optional<RawVolume>
OpenNiftiTensors(const std::string & fileName);

/** Read the voxels, a piece at a time. Throw itk::ExceptionObject if the file is damaged, or has no labels. */
itk::Image<int, 3>::Pointer
ReadLabels(const RawVolume & volume);
itk::Image<float, 3>::Pointer
ReadScalars(const RawVolume & volume);

/** Those of a voxel that are one after the other in the file, each as an image of its own. */
std::vector<itk::Image<float, 3>::Pointer>
ReadComponents(const RawVolume & volume, unsigned int count);
} // namespace mmm

#endif
