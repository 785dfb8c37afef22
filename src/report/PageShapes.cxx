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
#include "report/Histogram.h"
#include "report/LabelLook.h"

namespace mmm
{
namespace
{
/** The JSON that is in the page has more. */
constexpr std::size_t MostWorst = 50;

Histogram
AngleHistogram(const TetrahedronStatistics & statistics, const std::string & whose)
{
  const auto & counts = statistics.dihedralAngleHistogram;
  return { { counts.begin(), counts.end() }, 0.0, 180.0, "Dihedral angles of " + whose, " degrees", 0, 6 };
}

Histogram
RatioHistogram(const TetrahedronStatistics & statistics, const std::string & whose)
{
  const auto & counts = statistics.radiusRatioHistogram;
  return { { counts.begin(), counts.end() }, 0.0, 1.0, "Radius ratios of the tetrahedra of " + whose, "", 2, 5 };
}

void
AddShapes(HTMLTable &                   table,
          const std::string &           name,
          const TetrahedronStatistics & statistics,
          const std::string &           whose)
{
  table.AddRow({ name,
                 CountHTML(statistics.count),
                 DrawSmall(AngleHistogram(statistics, whose)),
                 NumberHTML(statistics.smallestAngle.minimum, 2),
                 NumberHTML(statistics.smallestAngle.firstPercentile, 1),
                 NumberHTML(statistics.smallestAngle.average, 1),
                 NumberHTML(statistics.largestAngle, 2),
                 CountHTML(statistics.below[1]),
                 CountHTML(statistics.above[0]),
                 DrawSmall(RatioHistogram(statistics, whose)),
                 NumberHTML(statistics.radiusRatio.minimum, 3),
                 NumberHTML(statistics.radiusRatio.firstPercentile, 3),
                 NumberHTML(statistics.radiusRatio.average, 3),
                 NumberHTML(statistics.largestVolume, 2) });
}

std::string
MakeShapeTable(const MeshQualityReport & quality, const LabelTable & labels)
{
  HTMLTable table("Dihedral angles in degrees, and radius ratios: 1 is the best, 0 is flat",
                  { { "Label", false },
                    { "Tetrahedra" },
                    { "Angles from 0 to 180", false },
                    { "Smallest" },
                    { "Smallest of each: first percentile" },
                    { "average" },
                    { "Largest" },
                    { "Tetrahedra below 10" },
                    { "Tetrahedra above 165" },
                    { "Radius ratios from 0 to 1", false },
                    { "Smallest" },
                    { "First percentile" },
                    { "Average" },
                    { "Largest volume (mm&#179;)" } });
  AddShapes(table, "all", quality.tetrahedra, "the mesh");
  for (const LabelQuality & label : quality.labels)
  {
    AddShapes(table, LabelHTML(label.label, labels), label.tetrahedra, "label " + LabelText(label.label, labels));
  }
  return table.ToText();
}

/** Counts of what is to be 0. */
std::string
MakeDefectTable(const MeshQualityReport & quality)
{
  HTMLTable table("What a mesh should have none of", { { "Defect", false }, { "Number" } });
  table.AddRow({ "flat or turned tetrahedra", CountHTML(quality.tetrahedra.nonPositive) });
  table.AddRow({ "points without tetrahedron", CountHTML(quality.unusedPoints) });
  table.AddRow({ "points in the place of another", CountHTML(quality.duplicatePoints) });
  table.AddRow({ "faces of more than two tetrahedra", CountHTML(quality.overusedFaces) });
  table.AddRow({ "edges where a label is open", CountHTML(quality.openEdges) });
  table.AddRow({ "edges where a label touches itself", CountHTML(quality.nonManifoldEdges) });
  return table.ToText();
}

std::string
MakeWorstTable(const MeshQualityReport & quality, const LabelTable & labels)
{
  if (quality.poorest.empty())
  {
    return ParagraphHTML("No tetrahedron has a dihedral angle below 10 or above 165 degrees.");
  }
  HTMLTable table("The worst tetrahedra",
                  { { "Tetrahedron" },
                    { "Label", false },
                    { "Smallest angle" },
                    { "Largest angle" },
                    { "Where", false },
                    { "x (mm)" },
                    { "y (mm)" },
                    { "z (mm)" } });
  for (const PoorTetrahedron & tetrahedron : quality.poorest)
  {
    table.AddRow({ CountHTML(tetrahedron.index),
                   LabelHTML(tetrahedron.label, labels),
                   NumberHTML(tetrahedron.smallestAngle, 2),
                   NumberHTML(tetrahedron.largestAngle, 2),
                   ToString(tetrahedron.GetPlace()),
                   NumberHTML(tetrahedron.center[0], 2),
                   NumberHTML(tetrahedron.center[1], 2),
                   NumberHTML(tetrahedron.center[2], 2) });
    if (table.CountRows() == MostWorst)
    {
      break;
    }
  }
  return DetailsHTML(std::to_string(quality.poorTetrahedra) +
                       " tetrahedra have a dihedral angle below 10 or above 165 degrees: the worst " +
                       std::to_string(table.CountRows()),
                     table.ToText());
}
} // namespace

std::string
MakeShapeSection(const itk::MeshFacts & facts, const itk::MeshPageDetails & details)
{
  HTMLTable triangles("Radius ratios of the triangles between labels: 1 is the best, 0 is flat",
                      { { "Triangles" }, { "Smallest" }, { "First percentile" }, { "Average" } });
  triangles.AddRow({ CountHTML(facts.surface->GetNumberOfCells()),
                     NumberHTML(facts.surfaceQuality.minimum, 3),
                     NumberHTML(facts.surfaceQuality.firstPercentile, 3),
                     NumberHTML(facts.surfaceQuality.average, 3) });
  std::string content;
  if (facts.quality != nullptr)
  {
    const MeshQualityReport & quality = *facts.quality;
    content = "<div class=\"pair\">\n" + DrawLarge(AngleHistogram(quality.tetrahedra, "the mesh, in degrees")) +
              DrawLarge(RatioHistogram(quality.tetrahedra, "the mesh")) + "</div>\n" +
              MakeShapeTable(quality, details.labels) + MakeWorstTable(quality, details.labels) +
              MakeDefectTable(quality);
  }
  return SectionHTML("shapes", "Shapes", content + triangles.ToText());
}
} // namespace mmm
