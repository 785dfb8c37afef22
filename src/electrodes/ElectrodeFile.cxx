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
#include "electrodes/JsonFields.h"
#include "itkElectrodes.h"

#include "itkMacro.h"

#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

namespace mmm
{
namespace
{
using Point = Electrode::PointType;

/** Without what ITK puts before it. */
std::string
DescriptionOf(const itk::ExceptionObject & error)
{
  const std::string text = error.GetDescription();
  const std::string prefix = "ITK ERROR: ";
  return text.compare(0, prefix.size(), prefix) == 0 ? text.substr(prefix.size()) : text;
}

class ElectrodeParser
{
public:
  explicit ElectrodeParser(bool isInRAS)
    : m_Sign(isInRAS ? -1.0 : 1.0)
  {}

  Point
  ParsePoint(const JsonFields & fields) const
  {
    const auto numbers = fields.Numbers(3);
    Point      point;
    point[0] = m_Sign * numbers[0];
    point[1] = m_Sign * numbers[1];
    point[2] = numbers[2];
    return point;
  }

  ElectrodeFiducials
  ParseFiducials(const JsonFields & fields) const
  {
    fields.Allow({ "nasion", "inion", "left", "right" });
    return { this->ParsePoint(fields["nasion"]),
             this->ParsePoint(fields["inion"]),
             this->ParsePoint(fields["left"]),
             this->ParsePoint(fields["right"]) };
  }

  /** One, or a lead's shaft and contacts. */
  std::vector<Electrode>
  Parse(const JsonFields & fields) const
  {
    return fields["shape"].Text() == "lead" ? this->ParseLead(fields)
                                            : std::vector<Electrode>{ this->ParseElectrode(fields) };
  }

private:
  Electrode
  ParseElectrode(const JsonFields & fields) const
  {
    static const std::map<std::string, ElectrodeShape> shapes = { { "disc", ElectrodeShape::Disc },
                                                                  { "ring", ElectrodeShape::Ring },
                                                                  { "rectangle", ElectrodeShape::Rectangle },
                                                                  { "sphere", ElectrodeShape::Sphere },
                                                                  { "box", ElectrodeShape::Box },
                                                                  { "cylinder", ElectrodeShape::Cylinder } };
    const auto                                         shape = shapes.find(fields["shape"].Text());
    if (shape == shapes.end())
    {
      fields["shape"].Fail('\'' + fields["shape"].Text() +
                           "' is no shape; it can be disc, ring, rectangle, sphere, box, cylinder or lead");
    }
    Electrode electrode;
    electrode.shape = shape->second;
    electrode.source = fields.GetPath();
    if (electrode.IsOnSkin())
    {
      this->ParseOnSkin(fields, electrode);
    }
    else
    {
      this->ParseImplant(fields, electrode);
    }
    electrode.label = fields["label"].Label();
    electrode.name = fields.Has("name") ? fields["name"].Text() : electrode.site;
    return electrode;
  }

  std::vector<Electrode>
  ParseLead(const JsonFields & fields) const
  {
    fields.Allow({ "name",
                   "label",
                   "shape",
                   "tip",
                   "entry",
                   "shaft_label",
                   "model",
                   "diameter",
                   "tip_length",
                   "contacts",
                   "contact_length",
                   "spacing" });
    const auto dimensions = this->ParseDimensions(fields);
    const int  label = fields["label"].Label();
    const int  shaft = fields["shaft_label"].Label();
    if (label > std::numeric_limits<int>::max() - dimensions.contacts)
    {
      fields["label"].Fail("the contacts have the labels from this one on, which leaves no room for them");
    }
    if (label <= shaft && shaft < label + dimensions.contacts)
    {
      fields["shaft_label"].Fail("it is that of a contact: they have the labels from " + std::to_string(label) +
                                 " to " + std::to_string(label + dimensions.contacts - 1));
    }
    std::vector<Electrode> lead;
    try
    {
      lead = MakeLead(fields.Has("name") ? fields["name"].Text() : "",
                      label,
                      shaft,
                      this->ParsePoint(fields["tip"]),
                      this->ParsePoint(fields["entry"]),
                      dimensions);
    }
    catch (const itk::ExceptionObject & error)
    {
      fields["entry"].Fail(DescriptionOf(error));
    }
    for (Electrode & electrode : lead)
    {
      electrode.source = fields.GetPath();
    }
    return lead;
  }

  static LeadDimensions
  ParseDimensions(const JsonFields & fields)
  {
    if (fields.Has("model"))
    {
      for (const char * const key : { "diameter", "tip_length", "contacts", "contact_length", "spacing" })
      {
        if (fields.Has(key))
        {
          fields[key].Fail("the model says this");
        }
      }
      try
      {
        return LeadDimensionsOf(fields["model"].Text());
      }
      catch (const itk::ExceptionObject & error)
      {
        fields["model"].Fail(DescriptionOf(error));
      }
    }
    constexpr double mostContacts = 64.0;
    const double     contacts = fields["contacts"].PositiveNumber();
    if (contacts != std::floor(contacts) || contacts > mostContacts)
    {
      fields["contacts"].Fail("it has to be a whole number up to 64");
    }
    return { fields["diameter"].PositiveNumber(),
             fields["tip_length"].PositiveNumber(),
             static_cast<int>(contacts),
             fields["contact_length"].PositiveNumber(),
             fields["spacing"].PositiveNumber() };
  }

  void
  ParseOnSkin(const JsonFields & fields, Electrode & electrode) const
  {
    switch (electrode.shape)
    {
      case ElectrodeShape::Disc:
        fields.Allow({ "name", "label", "shape", "position", "site", "radius", "thickness", "gel" });
        electrode.radius = fields["radius"].PositiveNumber();
        break;
      case ElectrodeShape::Ring:
        fields.Allow({ "name", "label", "shape", "position", "site", "radius", "inner_radius", "thickness", "gel" });
        electrode.radius = fields["radius"].PositiveNumber();
        ParseInnerRadius(fields, electrode);
        break;
      default:
        fields.Allow({ "name", "label", "shape", "position", "site", "towards", "size", "thickness", "gel" });
        ParseSize(fields["size"], 2, electrode);
        if (fields.Has("towards"))
        {
          electrode.end = this->ParsePoint(fields["towards"]);
        }
    }
    electrode.thickness = fields["thickness"].PositiveNumber();
    if (fields.Has("position") == fields.Has("site"))
    {
      fields.Fail("it needs either a position, [x, y, z] in mm, or a site such as \"Cz\"");
    }
    if (fields.Has("site"))
    {
      electrode.site = fields["site"].Text();
    }
    else
    {
      electrode.position = this->ParsePoint(fields["position"]);
    }
    if (fields.Has("gel"))
    {
      const JsonFields gel = fields["gel"];
      gel.Allow({ "name", "label", "thickness" });
      electrode.gel = { gel.Has("name") ? gel["name"].Text() : "",
                        gel["label"].Label(),
                        gel["thickness"].PositiveNumber() };
      if (electrode.gel->label == fields["label"].Label())
      {
        gel["label"].Fail("the electrode itself has this label");
      }
    }
  }

  void
  ParseImplant(const JsonFields & fields, Electrode & electrode) const
  {
    switch (electrode.shape)
    {
      case ElectrodeShape::Sphere:
        fields.Allow({ "name", "label", "shape", "center", "radius" });
        electrode.position = this->ParsePoint(fields["center"]);
        electrode.radius = fields["radius"].PositiveNumber();
        break;
      case ElectrodeShape::Box:
        fields.Allow({ "name", "label", "shape", "center", "size" });
        electrode.position = this->ParsePoint(fields["center"]);
        ParseSize(fields["size"], 3, electrode);
        break;
      default:
        fields.Allow({ "name", "label", "shape", "from", "to", "radius", "inner_radius" });
        electrode.position = this->ParsePoint(fields["from"]);
        electrode.end = this->ParsePoint(fields["to"]);
        electrode.radius = fields["radius"].PositiveNumber();
        if (electrode.position == *electrode.end)
        {
          fields["to"].Fail("it is the same place as 'from'");
        }
        if (fields.Has("inner_radius"))
        {
          ParseInnerRadius(fields, electrode);
        }
    }
  }

  static void
  ParseSize(const JsonFields & fields, std::size_t count, Electrode & electrode)
  {
    const auto numbers = fields.Numbers(count);
    for (std::size_t n = 0; n < count; ++n)
    {
      electrode.size[n] = fields.Elements()[n].PositiveNumber();
    }
  }

  static void
  ParseInnerRadius(const JsonFields & fields, Electrode & electrode)
  {
    electrode.innerRadius = fields["inner_radius"].PositiveNumber();
    if (electrode.innerRadius >= electrode.radius)
    {
      fields["inner_radius"].Fail("it has to be less than the radius");
    }
  }

  double m_Sign;
};
} // namespace

Electrodes
ReadElectrodes(const std::string & fileName)
{
  std::ifstream      file(fileName, std::ios::binary);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf()))
  {
    itkGenericExceptionMacro(<< fileName << ": the file cannot be read.");
  }
  const JsonValue  value = ParseJson(fileName, text.str());
  const JsonFields root(value, fileName + ": ");
  root.Allow({ "space", "fiducials", "electrodes" });
  const std::string space = root["space"].Text();
  if (space != "LPS" && space != "RAS")
  {
    root["space"].Fail('\'' + space + "' is neither LPS nor RAS");
  }
  const ElectrodeParser parser(space == "RAS");
  Electrodes            electrodes;
  if (root.Has("fiducials"))
  {
    electrodes.fiducials = parser.ParseFiducials(root["fiducials"]);
  }
  for (const JsonFields & fields : root["electrodes"].Elements())
  {
    for (const Electrode & electrode : parser.Parse(fields))
    {
      electrodes.list.push_back(electrode);
    }
  }
  if (electrodes.list.empty())
  {
    root["electrodes"].Fail("there is none");
  }
  return electrodes;
}

LabelTable
NamesOf(const Electrodes & electrodes)
{
  LabelTable table;
  const auto add = [&](int label, const std::string & name, const char * several) {
    const auto known = table.insert({ label, { name, {} } });
    if (!known.second && known.first->second.name != name)
    {
      known.first->second.name = several;
    }
  };
  for (const Electrode & electrode : electrodes.list)
  {
    add(electrode.label, electrode.name, "electrodes");
    if (electrode.gel)
    {
      const std::string & name = electrode.gel->name;
      add(electrode.gel->label, name.empty() && !electrode.name.empty() ? electrode.name + " gel" : name, "gel");
    }
  }
  return table;
}
} // namespace mmm
