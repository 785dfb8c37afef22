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

namespace mmm
{
namespace
{
constexpr TopologyMode Modes[] = { TopologyMode::Automatic, TopologyMode::Any, TopologyMode::Keep };
} // namespace

std::string
ToText(TopologyMode mode)
{
  return mode == TopologyMode::Automatic ? "auto" : mode == TopologyMode::Any ? "any" : "keep";
}

TopologyMode
ParseTopologyMode(const std::string & text)
{
  for (const TopologyMode mode : Modes)
  {
    if (text == ToText(mode))
    {
      return mode;
    }
  }
  itkGenericExceptionMacro("There is no topology mode '" << text << "'. It has to be one of auto, any, keep.");
}
} // namespace mmm
