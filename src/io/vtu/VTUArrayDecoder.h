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
#ifndef mmmVTUArrayDecoder_h
#define mmmVTUArrayDecoder_h

#include "io/vtu/VTUDocument.h"
#include "io/vtu/VTUFormat.h"

#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <vector>

namespace mmm
{
/** The values of an array in the machine's byte order. */
struct VTUValues
{
  itk::IOComponentEnum       type{ itk::IOComponentEnum::UNKNOWNCOMPONENTTYPE };
  std::size_t                count{ 0 };
  std::vector<unsigned char> bytes;

  std::size_t
  ValueSize() const
  {
    return count == 0 ? 0 : bytes.size() / count;
  }

  /** A value as integer; -1 if it is larger than the largest one. Throws if the values are no integers. */
  std::int64_t
  IntegerAt(std::size_t index) const;
};

/** Reads the values of an array. Throws MeshFileError if they are damaged, or if there are not as many as expected,
 * which is found before memory is allocated for them. Without expectation as many are read as the array announces and
 * has. */
VTUValues
ReadVTUArray(std::istream &               file,
             const VTUDocument &          document,
             const VTUArray &             array,
             std::optional<std::uint64_t> expected);

/** The text of a string array. */
std::string
ReadVTUString(std::istream & file, const VTUDocument & document, const VTUArray & array);
} // namespace mmm

#endif
