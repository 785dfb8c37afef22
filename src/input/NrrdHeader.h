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
#ifndef mmmNrrdHeader_h
#define mmmNrrdHeader_h

#include "input/Affine.h"

#include "itkMatrix.h"

#include <optional>
#include <string>
#include <vector>

namespace mmm
{
/** \brief Where the header of an NRRD file puts the voxels, if it has three directions in a space that it names.
 *
 * Others are left to ITK. So is the whole file: ITK knows fewer spaces than there are. Throws itk::ExceptionObject for
 * directions that are of no use. `notes` gets what the user should know. */
std::optional<Affine>
ReadNrrdPlace(const std::string & fileName, std::vector<std::string> & notes);

/** From the axes that the components of vectors and tensors are told along to those of LPS: the measurement frame, or
 * the axes of the space without one. The identity for other files. */
itk::Matrix<double, 3, 3>
ReadNrrdFrame(const std::string & fileName);
} // namespace mmm

#endif
