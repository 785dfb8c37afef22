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
#include "report/ElectrodeSection.h"

namespace mmm
{
Json
ElectrodeSection(const std::vector<ElectrodeReport> & electrodes)
{
  Json section = Json::Array();
  for (const ElectrodeReport & electrode : electrodes)
  {
    const auto & position = electrode.position;
    section.Add(Json::Object({ { "name", electrode.name },
                               { "label", electrode.label },
                               { "position_mm", Json::Array({ position[0], position[1], position[2] }) },
                               { "projection_mm", electrode.projection },
                               { "contact_area_mm2", electrode.contactArea },
                               { "expected_area_mm2", electrode.expectedArea },
                               { "gel_contact_area_mm2", electrode.gelContactArea },
                               { "expected_gel_area_mm2", electrode.expectedGelArea },
                               { "covers", electrode.covered } }));
  }
  return section;
}
} // namespace mmm
