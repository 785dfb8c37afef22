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
#ifndef ImageInput_h
#define ImageInput_h

#include "itkImage.h"
#include "itkImageIOBase.h"

#include <string>

namespace cli
{
using LabelImage = itk::Image<int, 3>;
using ScalarImage = itk::Image<float, 3>;

/** \brief Opens a file and checks that it is a three-dimensional image of scalars. Throws Error. */
itk::ImageIOBase::Pointer
OpenImage(const std::string & fileName);

/** \brief Reads an image of integers, whatever type they are stored as. Throws Error if values are not integers. */
LabelImage::Pointer
ReadLabelImage(const std::string & fileName);

ScalarImage::Pointer
ReadScalarImage(const std::string & fileName);
} // namespace cli

#endif
