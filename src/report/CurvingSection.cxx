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
#include "report/CurvingSection.h"

namespace mmm
{
Json
CurvingSection(const CurvingReport & curving)
{
  if (curving.edges == 0)
  {
    return {};
  }
  Json volumes = Json::Array();
  for (const auto & [label, volume] : curving.volumes)
  {
    volumes.Add(Json::Object({ { "label", label }, { "volume_mm3", volume } }));
  }
  return Json::Object({ { "edges_on_interfaces", curving.edges },
                        { "straight_without_interface", curving.withoutPlace },
                        { "straight_to_keep_tetrahedra", curving.inverting },
                        { "smallest_relative_jacobian", curving.smallestJacobian },
                        { "labels", volumes } });
}
} // namespace mmm
