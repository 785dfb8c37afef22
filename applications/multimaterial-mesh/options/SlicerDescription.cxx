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
#include "options/SlicerDescription.h"

#include "base/EscapedXML.h"
#include "options/HelpText.h"
#include "options/OptionTable.h"
#include "options/Version.h"

#include <algorithm>
#include <cctype>
#include <locale>
#include <optional>
#include <ostream>
#include <sstream>
#include <type_traits>

namespace cli
{
namespace
{
void
PrintElement(std::ostream & os, int depth, const std::string & name, const std::string & text)
{
  os << std::string(2 * depth, ' ') << '<' << name << '>' << mmm::EscapedXML(text) << "</" << name << ">\n";
}

/** "min-island" gives "Min island"; with the unit, if there is one. */
std::string
Label(const Option & option)
{
  std::string label = option.name;
  std::transform(label.begin(), label.end(), label.begin(), [](unsigned char c) {
    return c == '-' ? ' ' : static_cast<char>(std::tolower(c));
  });
  label.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(label.front())));
  return label + (option.unit.empty() ? "" : " (" + option.unit + ")");
}

/** Puts results beside the label image in Slicer's hierarchy of data. */
const std::string reference = " reference=\"LABELS\"";

/** The element's name and its attributes.
 *
 * Slicer passes every number, even one without value, but no empty text: a number that may be left out is a text. */
std::string
Element(const Option & option, std::string & attributes)
{
  switch (option.kind)
  {
    case Kind::Flag:
      attributes = option.audience == Audience::Hidden ? " hidden=\"true\"" : "";
      return "boolean";
    case Kind::Integer:
      return option.IsOptionalNumber() ? "string" : "integer";
    case Kind::Real:
      return option.IsOptionalNumber() ? "string" : "double";
    case Kind::LabelImage:
      attributes = " type=\"label\"";
      return "image";
    case Kind::ScalarImage:
      attributes = " type=\"scalar\"";
      return "image";
    case Kind::OutputImage:
      attributes = " type=\"scalar\"" + reference;
      return "image";
    case Kind::Choice:
      return "string-enumeration";
    case Kind::Mesh:
    case Kind::Surface:
    case Kind::Particles:
    case Kind::Junctions:
      attributes = " type=\"model\" fileExtensions=\".vtu\"" + reference;
      return "geometry";
    case Kind::Report:
      attributes = " fileExtensions=\".json,.html\"";
      return "file";
    default:
      return "string";
  }
}

/** The value that the program takes without the option, in the form of the command line; empty if there is none. */
std::string
DefaultValue(const Option & option)
{
  if (option.kind == Kind::Flag)
  {
    // What is hidden is there for Slicer to pass it.
    return option.audience == Audience::Hidden ? "true" : "false";
  }
  return ValueText(option, Settings{});
}

bool
IsData(const Option & option)
{
  return option.kind == Kind::LabelImage || option.kind == Kind::ScalarImage ||
         (option.IsOutput() && option.kind != Kind::FilePrefix);
}

void
PrintParameter(std::ostream & os, const Option & option, int & index)
{
  std::string       attributes;
  const std::string element = Element(option, attributes);
  os << "    <" << element << attributes << ">\n";
  PrintElement(os, 3, "name", SlicerName(option));
  PrintElement(os, 3, "label", Label(option));
  PrintElement(
    os, 3, "description", DescribeOption(option) + (option.IsOptionalNumber() ? " Leave empty for the default." : ""));
  if (option.IsPositional())
  {
    PrintElement(os, 3, "index", std::to_string(index++));
  }
  else
  {
    PrintElement(os, 3, "longflag", "--" + SlicerName(option));
  }
  if (IsData(option))
  {
    PrintElement(os, 3, "channel", option.IsOutput() ? "output" : "input");
  }
  else
  {
    PrintElement(os, 3, "default", DefaultValue(option));
  }
  for (const std::string & choice : option.choices)
  {
    PrintElement(os, 3, "element", choice);
  }
  os << "    </" << element << ">\n";
}
} // namespace

std::string
SlicerName(const Option & option)
{
  std::string name = option.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

void
PrintSlicerDescription(std::ostream & os)
{
  os << "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n"
        "<executable>\n";
  PrintElement(os, 1, "category", "Surface Models");
  PrintElement(os, 1, "title", "Multimaterial Mesh");
  PrintElement(os,
               1,
               "description",
               "Meshes a label map, such as a segmented MRI head: labelled tetrahedra that conform to all labels at "
               "once, and the triangles between the labels.");
  PrintElement(os, 1, "version", GetVersion());
  PrintElement(os, 1, "documentation-url", "");
  PrintElement(os, 1, "license", "Apache 2.0; uses TetGen, which is under the AGPL 3");
  PrintElement(os, 1, "contributor", "The authors of MultiMaterialMeshing");
  int index = 0;
  for (const OptionGroup & group : OptionTable())
  {
    os << "  <parameters" << (group.name == "Advanced" ? " advanced=\"true\"" : "") << ">\n";
    PrintElement(os, 2, "label", group.name);
    PrintElement(os, 2, "description", group.description);
    for (const Option & option : group.options)
    {
      if (option.audience != Audience::CommandLine)
      {
        PrintParameter(os, option, index);
      }
    }
    os << "  </parameters>\n";
  }
  os << "</executable>\n";
}
} // namespace cli
