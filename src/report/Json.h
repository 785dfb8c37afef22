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
#ifndef mmmJson_h
#define mmmJson_h

#include <array>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace mmm
{
/** \brief A value of JSON: to be put together and written. Objects keep the order of their members. */
class Json
{
public:
  using Member = std::pair<std::string, Json>;

  /** null */
  Json() = default;
  Json(bool value);
  /** null for what is no finite number, which JSON does not have. */
  Json(double value);
  template <typename T, typename = std::enable_if_t<std::is_integral_v<T> && !std::is_same_v<T, bool>>>
  Json(T value)
    : m_Scalar(std::to_string(value))
  {}
  /** Bytes that are no UTF-8 are replaced. */
  Json(const std::string & text);
  Json(const char * text);
  template <typename T>
  Json(const std::vector<T> & values)
    : Json(Array())
  {
    for (const T & value : values)
    {
      this->Add(value);
    }
  }
  template <typename T, std::size_t N>
  Json(const std::array<T, N> & values)
    : Json(std::vector<T>(values.begin(), values.end()))
  {}

  static Json
  Array(std::vector<Json> values = {});
  static Json
  Object(std::vector<Member> members = {});

  /** Appends to an array. */
  void
  Add(Json value);

  /** Appends a member to an object. */
  void
  Add(const std::string & name, Json value);

  /** With a line for each value, and two blanks for each level. */
  std::string
  ToText(const std::string & indent = "") const;

private:
  enum class Kind
  {
    Scalar,
    Array,
    Object
  };

  Kind                     m_Kind{ Kind::Scalar };
  std::string              m_Scalar{ "null" };
  std::vector<std::string> m_Names;
  std::vector<Json>        m_Values;
};
} // namespace mmm

#endif
