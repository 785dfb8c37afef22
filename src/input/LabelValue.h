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
#ifndef mmmLabelValue_h
#define mmmLabelValue_h

#include "itkMacro.h"
#include "itkNumberToString.h"
#include "itkSize.h"

#include <cmath>
#include <limits>
#include <string>
#include <type_traits>

namespace mmm
{
/** How far from a whole number a label may be in a file of real numbers: values that were scaled or resampled on the
 * way, not probabilities or intensities. */
constexpr double WholeNumberTolerance = 1e-3;

/** As many digits as tell the value. */
template <typename T>
std::string
DigitsOf(T value)
{
  if constexpr (std::is_integral_v<T>)
  {
    return std::to_string(value);
  }
  else if (!std::isfinite(value))
  {
    return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
  }
  else
  {
    const auto single = static_cast<float>(value);
    return static_cast<T>(single) == value ? itk::NumberToString<float>()(single)
                                           : itk::NumberToString<double>()(static_cast<double>(value));
  }
}

template <typename T>
[[noreturn]] void
ThrowNoLabel(const std::string & fileName, const itk::Size<3> & size, std::size_t voxel, T value)
{
  constexpr int lowest = std::numeric_limits<int>::min();
  constexpr int highest = std::numeric_limits<int>::max();
  const bool    isOutside = std::isfinite(static_cast<double>(value)) &&
                         (static_cast<double>(value) < lowest || static_cast<double>(value) > highest);
  itkGenericExceptionMacro(<< fileName << ": voxel (" << voxel % size[0] << ',' << voxel / size[0] % size[1] << ','
                           << voxel / size[0] / size[1] << ") has the value " << DigitsOf(value)
                           << (isOutside ? "; labels have to be from " + std::to_string(lowest) + " to " +
                                             std::to_string(highest)
                                         : "; a label image has integer values. Is this an intensity or probability "
                                           "image?"));
}

/** Whether a value is a label, which it is set to. */
template <typename T>
bool
IsLabel(T value, double tolerance, int & label)
{
  if constexpr (std::is_integral_v<T>)
  {
    label = static_cast<int>(value);
    return static_cast<T>(label) == value && (label < 0) == (value < T{ 0 });
  }
  else
  {
    const auto rounded = std::round(static_cast<double>(value));
    if (!(std::abs(static_cast<double>(value) - rounded) <= tolerance) || rounded < std::numeric_limits<int>::min() ||
        rounded > std::numeric_limits<int>::max())
    {
      return false;
    }
    label = static_cast<int>(rounded);
    return true;
  }
}
} // namespace mmm

#endif
