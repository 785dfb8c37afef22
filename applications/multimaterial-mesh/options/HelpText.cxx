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
#include "options/HelpText.h"

#include "options/OptionTable.h"

#include <ostream>
#include <sstream>

namespace cli
{
namespace
{
constexpr std::size_t HelpColumn = 28;
constexpr std::size_t LineWidth = 100;

void
PrintEntry(std::ostream & os, const std::string & name, const std::string & text)
{
  std::string line = "  " + name;
  if (line.size() + 2 > HelpColumn)
  {
    os << line << '\n';
    line.clear();
  }
  line.resize(HelpColumn, ' ');

  std::istringstream words(text);
  std::string        word;
  while (words >> word)
  {
    if (line.size() + word.size() > LineWidth)
    {
      os << line.substr(0, line.find_last_not_of(' ') + 1) << '\n';
      line.assign(HelpColumn, ' ');
    }
    line += word + ' ';
  }
  os << line.substr(0, line.find_last_not_of(' ') + 1) << '\n';
}

/** For instance "in mm; default: no limit". */
std::string
Remark(const Option & option)
{
  std::string       remark = option.unit.empty() ? "" : "in " + option.unit;
  const std::string value = DefaultText(option);
  if (!value.empty())
  {
    remark += (remark.empty() ? "" : "; ") + ("default: " + value);
  }
  return remark.empty() ? "" : " (" + remark + ")";
}
} // namespace

std::string
DescribeOption(const Option & option)
{
  return option.help + Remark(option);
}

void
PrintHelp(std::ostream & os)
{
  os << "usage: multimaterial-mesh LABELS OUTPUT.{vtu,msh,mesh} [options]\n"
        "       multimaterial-mesh --indicators FILE... OUTPUT.{vtu,msh,mesh} [options]\n"
        "       multimaterial-mesh --surface-label L=FILE... [LABELS] OUTPUT.{vtu,msh,mesh} [options]\n\n"
        "Meshes a label image, such as a segmented MRI head: labelled, conforming tetrahedra and the\n"
        "interfaces between the labels. Points are in ITK's physical coordinates (LPS).\n";

  for (const OptionGroup & group : OptionTable())
  {
    os << '\n' << group.name << '\n';
    for (const Option & option : group.options)
    {
      PrintEntry(
        os, NameOf(option) + (option.placeholder.empty() ? "" : ' ' + option.placeholder), DescribeOption(option));
    }
  }
  os << "\nOther\n";
  PrintEntry(os, "--xml", "Print the description that 3D Slicer makes its panel from.");
  PrintEntry(os, "--logo", "Print nothing; Slicer asks for it.");
  PrintEntry(os, "--version", "Print the version.");
  PrintEntry(os, "-h, --help", "Print this help.");
}
} // namespace cli
