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
#ifndef mmmJsonValue_h
#define mmmJsonValue_h

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace mmm
{
/** \brief A value of a JSON text, with the line that it begins in. */
struct JsonValue
{
  enum class Kind
  {
    Other,
    Number,
    Text,
    Array,
    Object
  };

  Kind        kind{ Kind::Other };
  std::size_t line{ 1 };
  /** Of a number, or a text without its escapes. */
  double                                         number{ 0.0 };
  std::string                                    text;
  std::vector<JsonValue>                         elements;
  std::vector<std::pair<std::string, JsonValue>> members;

  /** The member of an object; null if it has none of that name. */
  const JsonValue *
  Find(const std::string & name) const;
};

/** Throws itk::ExceptionObject with the name of the file, the line and what is wrong there. */
JsonValue
ParseJson(const std::string & fileName, const std::string & text);
} // namespace mmm

#endif
