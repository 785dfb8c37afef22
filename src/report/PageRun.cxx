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

#include <algorithm>

namespace mmm
{
namespace
{
std::string
Figure(const std::string & number, const std::string & name)
{
  return "<div><dt>" + name + "</dt><dd>" + number + "</dd></div>\n";
}

std::string
RowTable(const std::string & caption, const itk::MeshPageDetails::RowsType & rows)
{
  HTMLTable table(caption, { { "Name", false }, { "Value", false } });
  for (const auto & [name, value] : rows)
  {
    table.AddRow({ EscapedHTML(name), EscapedHTML(value) });
  }
  return table.CountRows() == 0 ? "" : table.ToText();
}

/** A bar that is as long as the share of the largest, in a cell. */
std::string
Bar(double value, double largest)
{
  const double percent = largest > 0.0 ? 100.0 * value / largest : 0.0;
  return "<span class=\"bar\" style=\"width:" + Decimal(percent, 1) + "%\"></span>";
}
} // namespace

std::string
MakeKeyFigures(const itk::MeshFacts & facts)
{
  double seconds = 0.0;
  double memory = 0.0;
  for (const StageRecord & stage : *facts.stages)
  {
    seconds += stage.seconds;
    memory = std::max(memory, stage.peakMemory);
  }
  std::string figures = "<dl class=\"figures\">\n";
  if (facts.quality != nullptr)
  {
    const TetrahedronStatistics & statistics = facts.quality->tetrahedra;
    figures += Figure(CountHTML(statistics.count), "tetrahedra") +
               Figure(CountHTML(facts.tetrahedra->GetNumberOfPoints()), "points") +
               Figure(CountHTML(facts.surface->GetNumberOfCells()), "triangles between labels") +
               Figure(NumberHTML(statistics.smallestAngle.minimum, 1) + "&#176;", "smallest dihedral angle") +
               Figure(NumberHTML(statistics.largestAngle, 1) + "&#176;", "largest") +
               Figure(NumberHTML(statistics.radiusRatio.average, 3), "average radius ratio") +
               Figure(NumberHTML(statistics.volume, 0) + " mm&#179;", "volume");
  }
  else
  {
    figures += Figure(CountHTML(facts.surface->GetNumberOfCells()), "triangles between labels") +
               Figure(CountHTML(facts.surface->GetNumberOfPoints()), "points") +
               Figure(NumberHTML(facts.surfaceQuality.average, 3), "average radius ratio");
  }
  figures += Figure(CountHTML(LabelsOfPage(facts).size() - facts.vanishedLabels->size()), "labels") +
             Figure(NumberHTML(seconds, 1) + " s", "time");
  if (memory > 0.0)
  {
    figures += Figure(NumberHTML(memory / 1024.0, 2) + " GB", "largest memory");
  }
  return figures + "</dl>\n";
}

std::string
MakeWarningSection(const itk::MeshFacts & facts, const itk::MeshPageDetails & details)
{
  std::vector<std::string> warnings = details.warnings;
  for (const std::string & warning : facts.meshing->warnings)
  {
    // a program may have told it before, in a sentence of its own
    const std::string words = warning.substr(0, warning.find_last_not_of('.') + 1);
    if (std::none_of(warnings.begin(), warnings.end(), [&](const std::string & other) {
          return other.find(words) != std::string::npos;
        }))
    {
      warnings.push_back(warning);
    }
  }
  if (warnings.empty())
  {
    return SectionHTML("warnings", "Warnings", ParagraphHTML("There were none."));
  }
  std::string list = "<ul class=\"warnings\">\n";
  for (const std::string & warning : warnings)
  {
    list += "<li>" + EscapedHTML(warning) + "</li>\n";
  }
  return SectionHTML("warnings", "Warnings", list + "</ul>\n");
}

std::string
MakeStageSection(const itk::MeshFacts & facts)
{
  double longest = 0.0;
  double largest = 0.0;
  for (const StageRecord & stage : *facts.stages)
  {
    longest = std::max(longest, stage.seconds);
    largest = std::max(largest, stage.peakMemory);
  }
  HTMLTable table("Time of each stage, and the largest memory of the process up to its end",
                  { { "Stage", false }, { "Time (s)" }, { "", false }, { "Memory (MB)" }, { "", false } });
  for (const StageRecord & stage : *facts.stages)
  {
    // systems that do not tell the memory leave 0
    table.AddRow({ EscapedHTML(stage.name),
                   NumberHTML(stage.seconds, 2),
                   Bar(stage.seconds, longest),
                   stage.peakMemory > 0.0 ? NumberHTML(stage.peakMemory, 0) : "",
                   Bar(stage.peakMemory, largest) });
  }
  return SectionHTML("stages", "Time and memory", table.ToText());
}

std::string
MakeSettingSection(const itk::MeshPageDetails & details)
{
  const std::string tables = RowTable("Input and files", details.input) + RowTable("Settings", details.settings);
  return tables.empty() ? "" : SectionHTML("settings", "Input and settings", tables);
}
} // namespace mmm
