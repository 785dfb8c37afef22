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
#ifndef mmmImageChecks_h
#define mmmImageChecks_h

#include "itkSize.h"

#include <cstdint>
#include <string>
#include <vector>

namespace mmm
{
[[noreturn]] void
ThrowDamaged(const std::string & fileName, const std::string & reason);

/** Throws if there is no file that can be opened. */
void
CheckFile(const std::string & fileName);

/** The size of an image of three dimensions, with others of one voxel left out. Throws if it has more or less. */
itk::Size<3>
CheckDimensions(const std::string & fileName, const std::vector<std::int64_t> & size);
} // namespace mmm

#endif
