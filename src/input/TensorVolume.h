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
#ifndef mmmTensorVolume_h
#define mmmTensorVolume_h

#include "itkImage.h"
#include "itkSymmetricSecondRankTensor.h"

#include <string>
#include <vector>

namespace mmm
{
using TensorImage = itk::Image<itk::SymmetricSecondRankTensor<float, 3>, 3>;

/** Whether a voxel of the file is a symmetric tensor: NIfTI of intent 1005, or six components of another format. */
bool
HasTensors(const std::string & fileName);

/** \brief Reads symmetric tensors, turned from the axes that they are told along to those of the physical space, LPS.
 *
 * NIfTI has the lower triangle row by row (xx, xy, yy, xz, yz, zz), and does not say along which axes: right, anterior,
 * superior, or those of the voxels if `inVoxelAxes`. NRRD has xx, xy, xz, yy, yz, zz and a measurement frame; without
 * one the axes are those of its space. Other formats are as NRRD, along those of LPS. Throws itk::ExceptionObject;
 * `notes` gets what the user should know. The place is that of the header. */
TensorImage::Pointer
ReadTensors(const std::string & fileName, bool inVoxelAxes, std::vector<std::string> & notes);
} // namespace mmm

#endif
