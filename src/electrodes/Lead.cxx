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
#include "itkElectrodes.h"

#include "itkMacro.h"

#include <map>

namespace mmm
{
LeadDimensions
LeadDimensionsOf(const std::string & model)
{
  static const std::map<std::string, LeadDimensions> models{ { "Medtronic 3387", { 1.27, 1.5, 4, 1.5, 1.5 } },
                                                             { "Medtronic 3389", { 1.27, 1.5, 4, 1.5, 0.5 } },
                                                             { "Medtronic 3391", { 1.27, 1.5, 4, 3.0, 4.0 } },
                                                             { "Boston Scientific DB-2201",
                                                               { 1.3, 1.1, 8, 1.5, 0.5 } } };
  const auto                                         found = models.find(model);
  if (found == models.end())
  {
    std::string known;
    for (const auto & entry : models)
    {
      known += (known.empty() ? "" : ", ") + entry.first;
    }
    itkGenericExceptionMacro("'" << model << "' is no lead that is known; known are " << known);
  }
  return found->second;
}

std::vector<Electrode>
MakeLead(const std::string &          name,
         int                          firstLabel,
         int                          shaftLabel,
         const Electrode::PointType & tip,
         const Electrode::PointType & entry,
         const LeadDimensions &       dimensions)
{
  const auto   way = entry - tip;
  const double length = way.GetNorm();
  const double step = dimensions.contactLength + dimensions.spacing;
  const double reach = dimensions.tipLength + dimensions.contacts * step - dimensions.spacing;
  if (!(length > reach))
  {
    itkGenericExceptionMacro("it is " << length << " mm from the tip, and the contacts reach up to " << reach << " mm");
  }
  const auto at = [&](double distance) { return tip + way * (distance / length); };

  Electrode shaft;
  shaft.name = name;
  shaft.label = shaftLabel;
  shaft.shape = ElectrodeShape::Cylinder;
  shaft.position = tip;
  shaft.end = entry;
  shaft.radius = 0.5 * dimensions.diameter;
  shaft.isRounded = true;
  std::vector<Electrode> lead{ shaft };
  for (int n = 0; n < dimensions.contacts; ++n)
  {
    Electrode contact = shaft;
    contact.name = (name.empty() ? "" : name + ' ') + "contact " + std::to_string(n + 1);
    contact.label = firstLabel + n;
    contact.position = at(dimensions.tipLength + n * step);
    contact.end = at(dimensions.tipLength + n * step + dimensions.contactLength);
    contact.isRounded = false;
    contact.bodyLabel = shaftLabel;
    lead.push_back(contact);
  }
  return lead;
}
} // namespace mmm
