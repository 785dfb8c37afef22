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
#ifndef mmmTrimmed_h
#define mmmTrimmed_h

#include <string>

namespace mmm
{
/** A text without such characters at its ends. */
inline std::string
Trimmed(const std::string & text, const char * characters = " ")
{
  const auto first = text.find_first_not_of(characters);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(characters) + 1 - first);
}
} // namespace mmm

#endif
