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
#ifndef mmmVTUPoints_h
#define mmmVTUPoints_h

#include "io/vtu/VTUArrayDecoder.h"
#include "io/vtu/VTUArrayEncoder.h"
#include "io/vtu/VTUDocument.h"

#include "itkCommonEnums.h"

#include <cstddef>
#include <istream>
#include <string>

namespace mmm
{
/** Points of VTU files have three coordinates. */
constexpr unsigned int vtuDimension = 3;

/** Reads the points in LPS, as float or as double if they are anything else. */
VTUValues
ReadVTUPoints(std::istream & file, const VTUDocument & document);

/** Writes points of one to three coordinates as `<DataArray>` element, the missing coordinates being zero. */
std::string
EncodeVTUPoints(const void *         buffer,
                itk::IOComponentEnum type,
                std::size_t          numberOfPoints,
                unsigned int         dimension,
                VTUEncoding          encoding);
} // namespace mmm

#endif
