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
#include "base/OutOfMemory.h"

#include "base/PeakMemory.h"

#include "itkMacro.h"

#include <cmath>

namespace mmm
{
void
ThrowOutOfMemory(const std::string & who)
{
  const double used = PeakMemory();
  throw itk::MemoryAllocationError(
    __FILE__,
    __LINE__,
    who + " ran out of memory" + (used > 0.0 ? " (" + std::to_string(std::lround(used)) + " MB were used)" : "") +
      ". Ask for larger elements (MinimumSize, MaximumSize), crop or resample the image, or use a machine with more "
      "memory.",
    "");
}
} // namespace mmm
