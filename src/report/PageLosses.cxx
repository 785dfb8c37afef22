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

#include <functional>

namespace mmm
{
namespace
{
/** The JSON that is in the page has more. */
constexpr std::size_t MostPlaces = 100;

/** "1 skull, 5" as HTML */
std::string
LabelList(const std::vector<int> & labels, const LabelTable & table)
{
  std::string list;
  for (const int label : labels)
  {
    list += (list.empty() ? "" : " ") + ("<span class=\"label\">" + LabelHTML(label, table) + "</span>");
  }
  return list;
}

/** What is said of places of one kind: a heading with their number, and a table of them. */
struct PlaceList
{
  /** In the plural. */
  const char * what;
  const char * none;
  /** Of a column besides labels and position, or null. */
  const char * more;
};

std::string
MakePlaces(const PlaceList &                                        list,
           std::size_t                                              count,
           const std::function<const MeshingPlace &(std::size_t)> & placeOf,
           const std::function<std::string(std::size_t)> &          moreOf,
           const LabelTable &                                       labels)
{
  if (count == 0)
  {
    return ParagraphHTML(list.none);
  }
  std::vector<HTMLTable::Column> columns{ { "Labels", false }, { "x (mm)" }, { "y (mm)" }, { "z (mm)" } };
  if (list.more != nullptr)
  {
    columns.push_back({ list.more });
  }
  HTMLTable table(list.what, columns);
  for (std::size_t p = 0; p < count && p < MostPlaces; ++p)
  {
    const MeshingPlace &     place = placeOf(p);
    std::vector<std::string> row{ LabelList(place.labels, labels),
                                  NumberHTML(place.position[0], 2),
                                  NumberHTML(place.position[1], 2),
                                  NumberHTML(place.position[2], 2) };
    if (list.more != nullptr)
    {
      row.push_back(moreOf(p));
    }
    table.AddRow(row);
  }
  const std::string cut = count > MostPlaces ? ", the first " + std::to_string(MostPlaces) : "";
  return DetailsHTML(std::to_string(count) + ' ' + list.what + cut, table.ToText());
}

std::string
MakePlaces(const PlaceList & list, const std::vector<MeshingPlace> & places, const LabelTable & labels)
{
  return MakePlaces(
    list, places.size(), [&](std::size_t p) -> const MeshingPlace & { return places[p]; }, nullptr, labels);
}

std::string
MakeDifferences(const std::vector<TopologyPlace> & differences, const LabelTable & labels)
{
  const auto changes = [&](std::size_t p) {
    std::string text;
    for (const std::ptrdiff_t change : differences[p].changes)
    {
      text += (text.empty() ? "" : ", ") + std::string(change > 0 ? "+" : "") + std::to_string(change);
    }
    return text;
  };
  return MakePlaces(
    { "places where the mesh is connected in another way than the indicators",
      "Nowhere is the mesh found to be connected in another way than the indicators.",
      "Euler characteristic, by label" },
    differences.size(),
    [&](std::size_t p) -> const MeshingPlace & { return differences[p].place; },
    changes,
    labels);
}

std::string
MakeIslands(const std::map<int, IslandRecord> & islands, const LabelTable & labels)
{
  HTMLTable table("Islands that went to other labels",
                  { { "Label", false },
                    { "Islands" },
                    { "Voxels" },
                    { "of the label before" },
                    { "and after" },
                    { "Voxels went to", false } });
  for (const auto & [label, record] : islands)
  {
    if (record.components == 0)
    {
      continue;
    }
    std::string destinations;
    for (const auto & [destination, voxels] : record.destinations)
    {
      destinations += "<span class=\"label\">" + LabelHTML(destination, labels) + ": " + CountHTML(voxels) + "</span> ";
    }
    table.AddRow({ LabelHTML(label, labels),
                   CountHTML(record.components),
                   CountHTML(record.voxels),
                   CountHTML(record.voxelsBefore),
                   CountHTML(record.voxelsAfter),
                   destinations });
  }
  return table.CountRows() == 0 ? ParagraphHTML("No islands were merged.") : table.ToText();
}

std::string
MakeVanished(const LabelCounts & vanished, const LabelTable & labels)
{
  HTMLTable table("Labels that are not in the mesh, as they are too thin", { { "Label", false }, { "Voxels" } });
  for (const auto & [label, voxels] : vanished)
  {
    table.AddRow({ LabelHTML(label, labels), CountHTML(voxels) });
  }
  return table.CountRows() == 0 ? ParagraphHTML("All labels are in the mesh.") : table.ToText();
}

std::string
MakeRepairTable(const MeshingReport & report)
{
  HTMLTable table("What was mended, dropped or added", { { "What", false }, { "Number" } });
  table.AddRow({ "edges where labels did not meet as on a surface, found", CountHTML(report.links.edges) });
  table.AddRow({ "points where they did not, found", CountHTML(report.links.points) });
  table.AddRow({ "tetrahedra that got another label to mend them", CountHTML(report.links.relabelled) });
  table.AddRow({ "particles without triangle, dropped", CountHTML(report.unusedParticles) });
  table.AddRow({ "interior points left out beside interfaces", CountHTML(report.pointsLeftOut) });
  table.AddRow({ "points added by TetGen", CountHTML(report.steinerPoints) });
  const OptimizationReport & optimization = report.optimization;
  table.AddRow({ "rounds of the optimizer", CountHTML(std::size_t(optimization.rounds)) });
  table.AddRow({ "its moves of points", CountHTML(optimization.moves) });
  table.AddRow({ "its flips", CountHTML(optimization.flips) });
  table.AddRow({ "its flips on interfaces", CountHTML(optimization.interfaceFlips) });
  table.AddRow({ "its collapses of edges", CountHTML(optimization.collapses) });
  table.AddRow({ "its tetrahedra that got another label", CountHTML(optimization.relabelled) });
  return table.ToText();
}
} // namespace

std::string
MakeLossSection(const itk::MeshFacts & facts, const itk::MeshPageDetails & details)
{
  const MeshingReport & report = *facts.meshing;
  const LabelTable &    labels = details.labels;
  std::string           content = MakeIslands(*facts.islands, labels) + MakeVanished(*facts.vanishedLabels, labels);
  if (!facts.absentExteriorLabels.empty())
  {
    content += "<p>Exterior labels that the image lacks: " + LabelList(facts.absentExteriorLabels, labels) + "</p>\n";
  }
  content +=
    MakePlaces({ "places where labels do not meet as on a surface", "Labels meet as on surfaces everywhere.", nullptr },
               report.links.left,
               labels);
  content += MakePlaces({ "triangles with a corner that is not where their labels meet",
                          "All triangles have their corners where their labels meet.",
                          nullptr },
                        report.inconsistentTriangles,
                        labels);
  if (!report.topology.labels.empty())
  {
    content += MakeDifferences(report.topology.differences, labels);
    content += MakePlaces(
      { "places where such differences side by side cancel out", "Nowhere do such differences cancel out.", nullptr },
      report.topology.cancelling,
      labels);
  }
  return SectionHTML("losses", "Merged, lost, left", content + MakeRepairTable(report));
}
} // namespace mmm
