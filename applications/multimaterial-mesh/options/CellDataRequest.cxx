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
#include "options/CellDataRequest.h"

#include "console/Errors.h"
#include "itkTetrahedronImageSampler.h"

#include <algorithm>

namespace cli
{
namespace
{
/** Takes a word and the colon before it from the end of a text, if they are there. */
bool
TakeEnd(std::string & text, const std::string & word)
{
  const auto colon = text.rfind(':');
  if (colon == std::string::npos || text.compare(colon + 1, std::string::npos, word) != 0)
  {
    return false;
  }
  text.erase(colon);
  return true;
}
} // namespace

CellDataRequest
ParseCellDataRequest(const std::string & option, const std::string & text)
{
  const auto &    modes = itk::TetrahedronImageSampler::GetModes();
  const auto      equals = text.find('=');
  CellDataRequest request{ text.substr(0, equals), "", modes.front() };
  if (equals != std::string::npos)
  {
    request.file = text.substr(equals + 1);
    if (TakeEnd(request.file, "voxels"))
    {
      request.inVoxelAxes = true;
    }
    const auto mode =
      std::find_if(modes.begin(), modes.end(), [&](const std::string & one) { return TakeEnd(request.file, one); });
    request.mode = mode == modes.end() ? modes.front() : *mode;
  }
  if (request.name.empty() || request.file.empty())
  {
    throw UsageError(option + " is '" + text + "'; it has to be NAME=IMAGE or NAME=IMAGE:MODE, for instance " +
                     "density=ct.nii.gz:mean; modes are mean, nearest and linear");
  }
  if (request.name == "label")
  {
    throw UsageError(option + " is '" + text + "', but 'label' is the name of the labels; choose another one");
  }
  return request;
}
} // namespace cli
