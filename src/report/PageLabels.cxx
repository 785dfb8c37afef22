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

#include "base/Grid.h"
#include "report/HTML.h"
#include "report/LabelLook.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mmm
{
namespace
{
constexpr double NoNumber = std::numeric_limits<double>::quiet_NaN();

double
VolumeOfVoxel(const itk::ImageBase<3> & image)
{
  Vector sides[3];
  for (int a = 0; a < 3; ++a)
  {
    for (int p = 0; p < 3; ++p)
    {
      sides[a][p] = image.GetDirection()[p][a] * image.GetSpacing()[a];
    }
  }
  return std::abs(sides[0].cross(sides[1]).dot(sides[2]));
}

const LabelQuality *
FindQuality(const itk::MeshFacts & facts, int label)
{
  if (facts.quality == nullptr)
  {
    return nullptr;
  }
  const auto & labels = facts.quality->labels;
  const auto   found =
    std::find_if(labels.begin(), labels.end(), [label](const LabelQuality & entry) { return entry.label == label; });
  return found == labels.end() ? nullptr : &*found;
}

/** "1, 0, 2" */
std::string
NumbersText(const BettiNumbers & numbers)
{
  return std::to_string(numbers[0]) + ", " + std::to_string(numbers[1]) + ", " + std::to_string(numbers[2]);
}

void
AddTopology(const MeshingReport & report, int label, std::vector<std::string> & row)
{
  const auto & labels = report.topology.labels;
  const auto   found =
    std::find_if(labels.begin(), labels.end(), [label](const LabelTopology & entry) { return entry.label == label; });
  if (found == labels.end())
  {
    row.insert(row.end(), 2, NumberHTML(NoNumber, 0));
    return;
  }
  const bool isEqual = found->mesh == found->partition;
  row.push_back(NumbersText(found->mesh));
  row.push_back((isEqual ? "" : "<strong>") + NumbersText(found->partition) + (isEqual ? "" : "</strong>"));
}
} // namespace

std::set<int>
LabelsOfPage(const itk::MeshFacts & facts)
{
  std::set<int> labels;
  for (const auto & entry : *facts.vanishedLabels)
  {
    labels.insert(entry.first);
  }
  if (facts.quality != nullptr)
  {
    for (const LabelQuality & entry : facts.quality->labels)
    {
      labels.insert(entry.label);
    }
    return labels;
  }
  for (const auto & sides : facts.surface->GetCellData()->CastToSTLConstContainer())
  {
    labels.insert({ sides[0], sides[1] });
  }
  labels.erase(facts.outsideLabel);
  return labels;
}

std::string
MakeLabelSection(const itk::MeshFacts & facts, const itk::MeshPageDetails & details)
{
  const bool                     hasTopology = !facts.meshing->topology.labels.empty();
  std::vector<HTMLTable::Column> columns{ { "Label", false },
                                          { "Voxels" },
                                          { "Volume of the voxels (mm&#179;)" },
                                          { "Volume in the mesh (mm&#179;)" },
                                          { "Error (%)" },
                                          { "Tetrahedra" },
                                          { "Parts" },
                                          { "Faces around it" } };
  if (hasTopology)
  {
    columns.push_back({ "Components, tunnels, cavities in the mesh" });
    columns.push_back({ "and in the indicators" });
  }
  HTMLTable    table("Volumes, parts and connections of the labels", columns);
  const double voxel = VolumeOfVoxel(*facts.image);
  for (const int label : LabelsOfPage(facts))
  {
    const LabelQuality * const quality = FindQuality(facts, label);
    const auto                 voxels = details.voxels.find(label);
    const bool                 hasVoxels = voxels != details.voxels.end();
    const double               wanted = hasVoxels ? voxel * double(voxels->second) : NoNumber;
    const double volume = quality != nullptr ? quality->tetrahedra.volume : facts.quality != nullptr ? 0.0 : NoNumber;
    std::vector<std::string> row{ LabelHTML(label, details.labels),
                                  hasVoxels ? CountHTML(voxels->second) : NumberHTML(NoNumber, 0),
                                  NumberHTML(wanted, 1),
                                  NumberHTML(volume, 1),
                                  SignedHTML(100.0 * (volume / wanted - 1.0), 2),
                                  CountHTML(quality != nullptr ? quality->tetrahedra.count : 0),
                                  CountHTML(quality != nullptr ? quality->components : 0),
                                  CountHTML(quality != nullptr ? quality->boundaryFaces : 0) };
    if (hasTopology)
    {
      AddTopology(*facts.meshing, label, row);
    }
    table.AddRow(row);
  }
  return SectionHTML("labels", "Labels", table.ToText());
}
} // namespace mmm
