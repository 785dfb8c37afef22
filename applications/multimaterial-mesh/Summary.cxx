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
#include "Summary.h"

#include "LabelCheck.h"
#include "Warnings.h"

#include <algorithm>
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
} // namespace

void
PrintSummary(std::ostream & os, const Outcome & outcome)
{
  const bool  surfaceOnly = outcome.settings.surfaceOnly;
  std::size_t islands = 0;
  std::size_t voxels = 0;
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
  os << "written: " << outcome.settings.output << '\n';
}

void
WarnOfAbsentExterior(const Settings & settings, const mmm::LabelCounts & voxels)
{
  const auto air = LabelOfAir(settings, voxels);
  for (const int label : settings.exterior)
  {
    if (voxels.count(label) == 0 && label != air)
    {
      std::ostringstream text;
      text << "no voxel has the exterior label " << label;
      // Whoever does not say what is exterior may not know that nothing is.
      if (!settings.exteriorIsListed)
      {
        text << (settings.IsFilled() ? ", so there is no air" : ", so everything is meshed")
             << "; choose by --exterior";
      }
      Warn(text.str());
    }
  }
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
} // namespace cli
