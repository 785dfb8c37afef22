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
#ifndef mmmJsonFields_h
#define mmmJsonFields_h

#include "input/JsonValue.h"

#include "itkPoint.h"

#include <initializer_list>
#include <string>

namespace mmm
{
/** \brief A JSON value and its path, such as "cap.json: electrodes[3].radius", which is what messages begin with.
 *
 * What is asked for and not as it should be throws itk::ExceptionObject. */
class JsonFields
{
public:
  JsonFields(const JsonValue & value, const std::string & path)
    : m_Value(value)
    , m_Path(path)
  {}

  const std::string &
  GetPath() const
  {
    return m_Path;
  }

  /** The value has to be an object with these members at most. */
  void
  Allow(std::initializer_list<const char *> names) const;

  bool
  Has(const std::string & name) const
  {
    return m_Value.Find(name) != nullptr;
  }
  JsonFields
  operator[](const std::string & name) const;
  std::vector<JsonFields>
  Elements() const;

  std::string
  Text() const;
  double
  Number() const;
  double
  PositiveNumber() const;
  int
  Label() const;
  /** `count` numbers. */
  std::vector<double>
  Numbers(std::size_t count) const;

  [[noreturn]] void
  Fail(const std::string & problem) const;

private:
  /** That of a member. */
  std::string
  PathOf(const std::string & name) const;

  const JsonValue & m_Value;
  std::string       m_Path;
};
} // namespace mmm

#endif
