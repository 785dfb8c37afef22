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
#include "run/Summary.h"

#include "console/Warnings.h"
#include "options/FileNames.h"
#include "run/Electrodes.h"

#include "vnl/vnl_det.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace cli
{
namespace
{
std::size_t
CountMeshedLabels(const Outcome & outcome)
{
  const auto & labels = outcome.filter->GetLabels();
  const auto & settings = outcome.settings;
  const auto   isMeshed = [&](int label) { return settings.IsFilled() || !settings.IsExterior(label); };
  return std::count_if(labels.begin(), labels.end(), isMeshed) - outcome.filter->GetVanishedLabels().size();
}

/** The image's volume with this label, in mm^3: after islands were merged. */
double
VolumeInImage(const Outcome & outcome, int label)
{
  const auto & image = *outcome.input.labels;
  const auto & spacing = image.GetSpacing();
  const double voxel = spacing[0] * spacing[1] * spacing[2] * std::abs(vnl_det(image.GetDirection().GetVnlMatrix()));
  return voxel * static_cast<double>(CountVoxels(outcome, label));
}

/** A line for each of the labels, the worst ones if there are many. */
void
PrintLabels(std::ostream & os, const Outcome & outcome)
{
  constexpr std::size_t most = 40;
  struct Line
  {
    int    label;
    double volume;
    double error;
  };
  std::vector<Line> lines;
  const auto        electrodes = mmm::NamesOf(outcome.input.electrodes);
  for (const auto & label : outcome.quality.labels)
  {
    // the exterior's volume is that of the box, and electrodes are shapes: neither is that of voxels
    if (!outcome.settings.IsExterior(label.label) && electrodes.count(label.label) == 0)
    {
      const auto & curved = outcome.filter->GetReport().curving.volumes;
      const auto   found = curved.find(label.label);
      const double volume = found == curved.end() ? label.tetrahedra.volume : found->second;
      lines.push_back({ label.label, volume, volume / VolumeInImage(outcome, label.label) - 1.0 });
    }
  }
  if (lines.size() > most)
  {
    std::stable_sort(
      lines.begin(), lines.end(), [](const Line & a, const Line & b) { return std::abs(a.error) > std::abs(b.error); });
    os << "the " << most << " of " << lines.size() << " labels whose volume is off the most:\n";
    lines.resize(most);
  }
  for (const Line & line : lines)
  {
    os << outcome.input.names.Describe(line.label) << ": " << std::defaultfloat << std::setprecision(6) << line.volume
       << " mm^3, " << std::fixed << std::setprecision(1) << std::showpos << 100.0 * line.error << std::noshowpos
       << " % against its voxels\n";
  }
}
} // namespace

std::size_t
CountVoxels(const Outcome & outcome, int label)
{
  const auto & records = outcome.filter->GetIslandRecords();
  const auto   record = records.find(label);
  if (record != records.end())
  {
    return record->second.voxelsAfter;
  }
  const auto voxels = outcome.input.voxels.find(label);
  return voxels == outcome.input.voxels.end() ? 0 : voxels->second;
}

void
PrintSummary(std::ostream & os, const Outcome & outcome)
{
  const auto & settings = outcome.settings;
  const bool   surfaceOnly = settings.surfaceOnly;
  std::size_t  islands = 0;
  std::size_t  voxels = 0;
  for (const auto & entry : outcome.filter->GetIslandRecords())
  {
    islands += entry.second.components;
    voxels += entry.second.voxels;
  }

  os << std::fixed << std::setprecision(3);
  os << "labels: " << CountMeshedLabels(outcome) << " meshed; islands merged: " << islands << " (" << voxels
     << " voxels)\n";
  os << "surface: " << outcome.surface->GetNumberOfPoints() << " points, " << outcome.surface->GetNumberOfCells()
     << " triangles, radius ratio " << outcome.surfaceQuality.average << " on average, "
     << outcome.surfaceQuality.minimum << " at worst\n";
  if (!surfaceOnly)
  {
    const auto & quality = outcome.quality.tetrahedra;
    os << "mesh: " << outcome.tetrahedra->GetNumberOfPoints() << " points, " << outcome.tetrahedra->GetNumberOfCells()
       << " tetrahedra, radius ratio " << quality.radiusRatio.average << " on average, " << quality.radiusRatio.minimum
       << " at worst\n";
    os << std::setprecision(1) << "dihedral angles: " << quality.smallestAngle.minimum << " to " << quality.largestAngle
       << " degrees; largest volume: " << std::defaultfloat << std::setprecision(3) << quality.largestVolume
       << " mm^3\n";
  }
  if (settings.order == 2)
  {
    const mmm::CurvingReport & curving = outcome.filter->GetReport().curving;
    os << "second order: " << outcome.midNodes->GetNumberOfPoints() << " of " << curving.edges
       << " edges on interfaces are curved; smallest Jacobian " << std::defaultfloat << std::setprecision(3)
       << curving.smallestJacobian << " of that with straight edges\n";
  }
  PrintLabels(os, outcome);
  PrintElectrodes(os, outcome.filter->GetElectrodeReports());
  os << "written:";
  for (std::size_t f = 0; f < outcome.files.size(); ++f)
  {
    os << (f == 0 ? " " : ", ") << outcome.files[f];
  }
  os << "\ntime: " << std::fixed << std::setprecision(1) << outcome.seconds << " s\n";
}

void
WarnOfVanishedLabels(const Settings & settings, const MeshFilter & filter)
{
  for (const auto & [label, voxels] : filter.GetVanishedLabels())
  {
    std::ostringstream text;
    text << "label " << label << " (" << voxels << " voxels) is too thin and not in the mesh; "
         << (settings.indicators.empty() ? "a smaller --radius or finer sizes may help" : "finer sizes may help");
    Warn(text.str());
  }
}

void
WarnOfMergedIslands(const MeshFilter & filter)
{
  constexpr double share = 0.05;
  for (const auto & [label, record] : filter.GetIslandRecords())
  {
    if (static_cast<double>(record.voxels) > share * static_cast<double>(record.voxelsBefore))
    {
      std::ostringstream text;
      text << "label " << label << " loses " << record.voxels << " of its " << record.voxelsBefore
           << " voxels as islands of fewer voxels than --min-island; --min-island 0 keeps them";
      Warn(text.str());
    }
  }
}

void
WarnOfLargeTetrahedra(const Outcome & outcome)
{
  const double largest = outcome.quality.tetrahedra.largestVolume;
  if (outcome.settings.maxVolume && largest > *outcome.settings.maxVolume)
  {
    std::ostringstream text;
    text << "the largest tetrahedron has " << largest << " mm^3, more than --max-volume; a smaller --max-volume helps";
    Warn(text.str());
  }
}

void
WarnOfFlatTriangles(const Settings & settings)
{
  std::string files;
  const auto  add = [&](const std::string & name, bool isFlat) {
    files += !isFlat || name.empty() ? "" : (files.empty() ? "" : ", ") + name;
  };
  const auto cannotCurve = [](const std::string & name) {
    const std::string extension = FindExtension(Kind::Surface, name);
    return extension != ".vtu" && extension != ".msh";
  };
  add(settings.output, cannotCurve(settings.output));
  add(settings.surface, cannotCurve(settings.surface));
  add(settings.surfacePrefix, true);
  for (const Hull & hull : settings.hulls)
  {
    add(hull.file, true);
  }
  if (settings.order == 2 && !files.empty())
  {
    Warn("the triangles in " + files + " are flat: --order 2 is for OUTPUT and --surface, as .vtu or .msh");
  }
}
} // namespace cli
