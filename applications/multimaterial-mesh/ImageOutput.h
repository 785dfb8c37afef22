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
#ifndef ImageOutput_h
#define ImageOutput_h

#include "ImageInput.h"

#include <string>

namespace cli
{
/** Throws UsageError if images are not written in the format of the name's extension. */
void
CheckImageName(const std::string & option, const std::string & fileName);

/** \brief Writes an image, compressed. Throws Error; no incomplete file is left behind. */
void
WriteImage(const ScalarImage * image, const std::string & fileName);
} // namespace cli

#endif
