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
#include "report/PageSections.h"

#include "report/HTML.h"
#include "report/LabelLook.h"

namespace mmm
{
std::string
MakeElectrodeSection(const itk::MeshFacts & facts, const itk::MeshPageDetails & details)
{
  if (facts.electrodes == nullptr || facts.electrodes->empty())
  {
    return "";
  }
  HTMLTable table("Contact areas in the mesh against those of the shapes, and how far places were from the skin",
                  { { "Electrode", false },
                    { "x (mm)" },
                    { "y (mm)" },
                    { "z (mm)" },
                    { "Moved (mm)" },
                    { "Area (mm<sup>2</sup>)" },
                    { "Of the shape" },
                    { "Error (%)" },
                    { "Of the gel" },
                    { "Covers", false } });
  for (const ElectrodeReport & electrode : *facts.electrodes)
  {
    std::string covered;
    for (const std::string & name : electrode.covered)
    {
      covered += (covered.empty() ? "" : ", ") + EscapedHTML(name);
    }
    const std::string label = LabelHTML(electrode.label, details.labels);
    table.AddRow({ electrode.name.empty() ? label : label + " " + EscapedHTML(electrode.name),
                   NumberHTML(electrode.position[0], 1),
                   NumberHTML(electrode.position[1], 1),
                   NumberHTML(electrode.position[2], 1),
                   NumberHTML(electrode.projection, 1),
                   NumberHTML(electrode.contactArea, 2),
                   NumberHTML(electrode.expectedArea, 2),
                   SignedHTML(100.0 * (electrode.contactArea / electrode.expectedArea - 1.0), 2),
                   NumberHTML(electrode.gelContactArea, 2),
                   covered });
  }
  return SectionHTML("electrodes", "Electrodes", table.ToText());
}
} // namespace mmm
