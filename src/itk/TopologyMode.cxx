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
#include "MultiMaterialMeshingOptions.h"

#include "itkMacro.h"

#include <algorithm>
#include <iterator>

namespace mmm
{
namespace
{
struct NamedMode
{
  TopologyMode mode;
  const char * name;
};

constexpr NamedMode Modes[] = { { TopologyMode::Automatic, "auto" },
                                { TopologyMode::Any, "any" },
                                { TopologyMode::Keep, "keep" } };
} // namespace

std::string
ToText(TopologyMode mode)
{
  return std::find_if(
           std::begin(Modes), std::end(Modes), [mode](const NamedMode & entry) { return entry.mode == mode; })
    ->name;
}

TopologyMode
ParseTopologyMode(const std::string & text)
{
  std::string names;
  for (const NamedMode & entry : Modes)
  {
    if (text == entry.name)
    {
      return entry.mode;
    }
    names += (names.empty() ? "" : ", ") + std::string(entry.name);
  }
  itkGenericExceptionMacro("There is no topology mode '" << text << "'. It has to be one of " << names << '.');
}
} // namespace mmm
