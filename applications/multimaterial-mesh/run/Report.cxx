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
#include "run/Report.h"

#include "console/Warnings.h"
#include "options/OptionTable.h"
#include "options/Version.h"
#include "run/Summary.h"
#include "itkMeshPage.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>

namespace cli
{
namespace
{
using Json = nlohmann::ordered_json;

/** File names need not be UTF-8, JSON has to be. */
std::string
ToText(const Json & json, int indent = -1)
{
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

Json
Number(double value)
{
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

/** An object for each label: {"label": 1, <name>: <value>}. */
template <typename TCounts>
Json
PerLabel(const TCounts & counts, const char * name)
{
  Json list = Json::array();
  for (const auto & [label, count] : counts)
  {
    list.push_back({ { "label", label }, { name, count } });
  }
  return list;
}

template <typename TVector>
Json
Triple(const TVector & values)
{
  return { Number(values[0]), Number(values[1]), Number(values[2]) };
}

Json
ToJson(const std::vector<SurfaceLabel> & surfaces)
{
  Json list = Json::array();
  for (const SurfaceLabel & surface : surfaces)
  {
    list.push_back({ { "label", surface.label }, { "file", surface.file } });
  }
  return list;
}

Json
InputSection(const Outcome & outcome)
{
  const auto size = outcome.input.labels->GetLargestPossibleRegion().GetSize();
  Json       section;
  if (outcome.settings.indicators.empty())
  {
    section["file"] = outcome.settings.labels.empty() ? Json(nullptr) : Json(outcome.settings.labels);
  }
  else
  {
    section["indicators"] = outcome.settings.indicators;
    section["indicator_labels"] = outcome.settings.indicatorLabels;
  }
  if (!outcome.settings.surfaceLabels.empty())
  {
    section["surfaces"] = ToJson(outcome.settings.surfaceLabels);
  }
  if (!outcome.settings.electrodes.empty())
  {
    section["electrodes"] = outcome.settings.electrodes;
  }
  section["size"] = { size[0], size[1], size[2] };
  section["spacing_mm"] = Triple(outcome.input.labels->GetSpacing());
  section["origin_mm"] = Triple(outcome.input.labels->GetOrigin());
  // from voxel indices to points in LPS
  section["affine_mm"] = Json::array();
  for (unsigned int row = 0; row < 3; ++row)
  {
    const auto & direction = outcome.input.labels->GetDirection();
    const auto & spacing = outcome.input.labels->GetSpacing();
    section["affine_mm"].push_back({ Number(direction[row][0] * spacing[0]),
                                     Number(direction[row][1] * spacing[1]),
                                     Number(direction[row][2] * spacing[2]),
                                     Number(outcome.input.labels->GetOrigin()[row]) });
  }
  section["labels"] = PerLabel(outcome.input.voxels, "voxels");
  return section;
}

/** Of the labels that are meshed: the file, and what it says of each of them. */
Json
NameSection(const Outcome & outcome)
{
  Json list = Json::array();
  for (const int label : outcome.filter->GetLabels())
  {
    const auto entry = outcome.input.names.table.find(label);
    if (entry != outcome.input.names.table.end())
    {
      list.push_back({ { "label", label },
                       { "name", entry->second.name },
                       { "color", entry->second.color ? Triple(*entry->second.color) : Json(nullptr) } });
    }
  }
  const std::string & file = outcome.input.names.file;
  return { { "file", file.empty() ? Json(nullptr) : Json(file) }, { "labels", list } };
}

/** The image, where there is one, and the numbers' range without what is no number. */
Json
CellDataSection(const Outcome & outcome)
{
  Json         list = Json::array();
  const auto & requests = outcome.settings.cellData;
  for (const CellDataRecord & record : outcome.cellData)
  {
    const auto request = std::find_if(
      requests.begin(), requests.end(), [&](const CellDataRequest & one) { return one.name == record.name; });
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    for (const double value : record.values)
    {
      lowest = std::fmin(lowest, value);
      highest = std::fmax(highest, value);
    }
    list.push_back({ { "name", record.name },
                     { "file", request == requests.end() ? outcome.settings.conductivity : request->file },
                     { "mode", request == requests.end() ? Json(nullptr) : Json(request->mode) },
                     { "minimum", Number(lowest) },
                     { "maximum", Number(highest) },
                     { "tetrahedra_outside", record.outside },
                     { "tetrahedra_partly_outside", record.partlyOutside } });
  }
  return list;
}

/** "max-volume" gives "max_volume_mm3". */
std::string
KeyOf(const Option & option)
{
  std::string key = option.name + (option.unit.empty() ? "" : "_" + option.unit);
  std::replace(key.begin(), key.end(), '-', '_');
  key.erase(std::remove(key.begin(), key.end(), '^'), key.end());
  std::transform(key.begin(), key.end(), key.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return key;
}

Json
ToJson(double value)
{
  return Number(value);
}

Json
ToJson(const std::string & text)
{
  return text.empty() ? Json(nullptr) : Json(text);
}

Json
ToJson(const std::vector<Hull> & hulls)
{
  Json list = Json::array();
  for (const Hull & hull : hulls)
  {
    list.push_back({ { "file", hull.file }, { "labels", hull.labels } });
  }
  return list;
}

Json
ToJson(const std::vector<CellDataRequest> & requests)
{
  Json list = Json::array();
  for (const CellDataRequest & request : requests)
  {
    list.push_back({ { "name", request.name }, { "file", request.file }, { "mode", request.mode } });
  }
  return list;
}

Json
ToJson(const mmm::LabelSizeRules & rules)
{
  return mmm::ToText(rules);
}

template <typename T>
Json
ToJson(const T & value)
{
  return value;
}

template <typename T>
Json
ToJson(const std::optional<T> & value)
{
  return value ? ToJson(*value) : Json(nullptr);
}

Json
ParameterSection(const Settings & settings)
{
  Json section;
  ForEachOption([&](const Option & option) {
    // the input's section has the others
    if (!option.IsPositional() && !option.IsOutput() && option.audience == Audience::All)
    {
      section[KeyOf(option)] = std::visit([&](auto field) { return ToJson(settings.*field); }, option.target.field);
    }
  });
  return section;
}

Json
HullSection(const Outcome & outcome)
{
  Json section = ToJson(outcome.settings.hulls);
  for (std::size_t h = 0; h < section.size(); ++h)
  {
    itk::LabelHullMeshFilter & filter = *outcome.hulls[h];
    section[h]["points"] = filter.GetOutput()->GetNumberOfPoints();
    section[h]["triangles"] = filter.GetOutput()->GetNumberOfCells();
    section[h]["other_parts"] = filter.GetNumberOfOtherParts();
    section[h]["pinched_edges"] = filter.GetNumberOfPinchedEdges();
    section[h]["pinched_points"] = filter.GetNumberOfPinchedPoints();
    section[h]["handles"] = filter.GetNumberOfHandles();
  }
  return section;
}

itk::MeshFacts
FactsOf(const Outcome & outcome)
{
  const MeshFilter & filter = *outcome.filter;
  itk::MeshFacts     facts;
  facts.meshing = &filter.GetReport();
  facts.islands = &filter.GetIslandRecords();
  facts.vanishedLabels = &filter.GetVanishedLabels();
  facts.stages = &outcome.stages;
  facts.electrodes = &filter.GetElectrodeReports();
  facts.absentExteriorLabels = filter.GetAbsentExteriorLabels();
  facts.outsideLabel = filter.GetOutsideLabel();
  facts.tetrahedra = outcome.tetrahedra;
  facts.surface = outcome.surface;
  facts.image = outcome.input.labels;
  facts.meshedRegion = filter.GetMeshedRegion();
  facts.quality = outcome.settings.surfaceOnly ? nullptr : &outcome.quality;
  facts.surfaceQuality = outcome.surfaceQuality;
  return facts;
}

/** The run as JSON text. Numbers that are not finite are null. */
std::string
MakeReport(const Outcome & outcome, const itk::MeshFacts & facts)
{
  Json report;
  report["program"] = "multimaterial-mesh";
  report["version"] = GetVersion();
  report["input"] = InputSection(outcome);
  report["output"] = outcome.settings.output;
  report["files"] = outcome.files;
  if (!outcome.hulls.empty())
  {
    report["hulls"] = HullSection(outcome);
  }
  if (!outcome.input.names.table.empty())
  {
    report["label_names"] = NameSection(outcome);
  }
  if (!outcome.cellData.empty())
  {
    report["cell_data"] = CellDataSection(outcome);
  }
  report["seconds"] = Number(outcome.seconds);
  report["parameters"] = ParameterSection(outcome.settings);
  const std::string own = ToText(report, 2);
  // one object of both: without the last brace and the first one
  return own.substr(0, own.size() - 2) + "," + itk::MakeMeshReport(facts).substr(1);
}

/** A row of a table for each member of an object but the lists by label, which have tables of their own. */
void
AddRows(const Json & object, itk::MeshPageDetails::RowsType & rows)
{
  for (const auto & [name, value] : object.items())
  {
    if (name != "labels")
    {
      rows.emplace_back(name, value.is_string() ? value.get<std::string>() : value.is_null() ? "" : ToText(value));
    }
  }
}

itk::MeshPageDetails
DetailsOf(const Outcome & outcome)
{
  const Settings &     settings = outcome.settings;
  itk::MeshPageDetails details;
  details.title = settings.indicators.empty() ? std::filesystem::path(settings.labels).filename().string()
                                              : std::to_string(settings.indicators.size()) + " indicators";
  details.input.emplace_back("program", "multimaterial-mesh " + GetVersion());
  AddRows(InputSection(outcome), details.input);
  for (const std::string & file : outcome.files)
  {
    details.input.emplace_back("written", file);
  }
  details.input.emplace_back("seconds", ToText(Number(outcome.seconds)));
  AddRows(ParameterSection(settings), details.settings);
  details.warnings = GetWarnings();
  details.labels = outcome.input.names.table;
  for (const auto & entry : outcome.quality.labels)
  {
    // the exterior's volume is that of the box, not of its voxels
    if (!settings.IsExterior(entry.label))
    {
      details.voxels[entry.label] = CountVoxels(outcome, entry.label);
    }
  }
  details.labelAt = [&image = *outcome.input.labels](const itk::Index<3> & index) { return image.GetPixel(index); };
  return details;
}
} // namespace

void
WriteReports(Outcome & outcome)
{
  const auto & names = outcome.settings.reports;
  if (names.empty())
  {
    return;
  }
  outcome.files.insert(outcome.files.end(), names.begin(), names.end());
  const itk::MeshFacts facts = FactsOf(outcome);
  itk::MeshPageDetails details = DetailsOf(outcome);
  details.json = MakeReport(outcome, facts);
  for (const std::string & name : names)
  {
    itk::WriteMeshReport(name, facts, details);
  }
}
} // namespace cli
