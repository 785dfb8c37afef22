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
#ifndef mmmMetaImageData_h
#define mmmMetaImageData_h

#include <string>

namespace mmm
{
/** \brief Throws where the header of a MetaImage (.mha, .mhd) says of no sensible number how many dimensions there are:
 * ITK does not end reading numbers for that many. */
void
CheckMetaImageHeader(const std::string & fileName);

/** \brief Throws where a MetaImage (.mha, .mhd) has less data than it should, or data that cannot be uncompressed.
 *
 * ITK reads such a file without an exception, and leaves the rest of the voxels as memory had them. */
void
CheckMetaImageData(const std::string & fileName, double bytes);
} // namespace mmm

#endif
