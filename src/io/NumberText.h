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
#ifndef mmmNumberText_h
#define mmmNumberText_h

#include "itkNumberToString.h"

#include <charconv>
#include <cmath>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>

namespace mmm
{
inline bool
IsBlank(char c)
{
  return c == ' ' || c == '\n' || c == '\r' || c == '\t';
}

/** Appends the shortest text that gives the same number again, whatever the locale. What is no number is written as
 * from_chars() and VTK take it. */
template <typename T>
void
AppendNumber(std::string & text, T value)
{
  if constexpr (std::is_integral_v<T>)
  {
    char word[24];
    text.append(word, std::to_chars(word, word + sizeof word, value).ptr);
  }
  else
  {
    text += std::isnan(value)   ? "nan"
            : std::isinf(value) ? (value < 0 ? "-inf" : "inf")
                                : itk::NumberToString<T>()(value);
  }
}

/** Whether all of a word is a number, whatever the locale. */
template <typename T>
bool
ParseNumber(std::string_view word, T & value)
{
#if !defined(__cpp_lib_to_chars)
  // Some standard libraries have from_chars for integers only.
  if constexpr (std::is_floating_point_v<T>)
  {
    std::istringstream stream{ std::string(word) };
    stream.imbue(std::locale::classic());
    return static_cast<bool>(stream >> value) && stream.peek() == std::istringstream::traits_type::eof();
  }
  else
#endif
  {
    const auto parsed = std::from_chars(word.data(), word.data() + word.size(), value);
    return parsed.ec == std::errc() && parsed.ptr == word.data() + word.size();
  }
}
} // namespace mmm

#endif
