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
#ifndef mmmTestFiles_h
#define mmmTestFiles_h

#include <fstream>
#include <sstream>
#include <string>

/** Files as a whole. */
namespace mmmtest
{
inline std::string
Content(const std::string & name)
{
  std::ifstream     file(name, std::ios::binary);
  std::stringstream content;
  content << file.rdbuf();
  return content.str();
}

inline void
Save(const std::string & name, const std::string & content)
{
  std::ofstream(name, std::ios::binary) << content;
}
} // namespace mmmtest

#endif
