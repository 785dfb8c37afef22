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
#include "run/Electrodes.h"

#include "console/Warnings.h"
#include "itkLabelImageToTetrahedralMeshFilter.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace cli
{
namespace
{
/** The share by which the contact area in the mesh differs from that of the shape; not a number where there is none. */
double
ErrorOf(const mmm::ElectrodeReport & electrode)
{
  return electrode.contactArea / electrode.expectedArea - 1.0;
}

void
WarnOfAreas(const std::vector<mmm::ElectrodeReport> & electrodes)
{
  constexpr double             large = 0.05;
  std::size_t                  count = 0;
  const mmm::ElectrodeReport * worst = nullptr;
  for (const mmm::ElectrodeReport & electrode : electrodes)
  {
    if (std::abs(ErrorOf(electrode)) > large)
    {
      ++count;
      worst = worst == nullptr || std::abs(ErrorOf(electrode)) > std::abs(ErrorOf(*worst)) ? &electrode : worst;
    }
  }
  if (worst != nullptr)
  {
    std::ostringstream text;
    text.precision(3);
    text << "contact areas of " << count << " electrodes differ from those of their shapes by more than "
         << 100.0 * large << " %, most that of '" << worst->name << "': " << worst->contactArea << " mm^2 for "
         << worst->expectedArea << "; they are nearer in an image of smaller voxels";
    Warn(text.str());
  }
}
} // namespace

void
AddElectrodes(const Settings & settings, Input & input)
{
  input.electrodes = mmm::ReadElectrodes(settings.electrodes);
  for (const auto & entry : mmm::NamesOf(input.electrodes))
  {
    // how many they are is known when they are placed
    input.voxels.insert({ entry.first, 0 });
  }
}

void
FinishElectrodes(const MeshFilter & filter, Input & input)
{
  for (const auto & entry : mmm::NamesOf(input.electrodes))
  {
    const auto record = filter.GetIslandRecords().find(entry.first);
    if (record != filter.GetIslandRecords().end())
    {
      input.voxels[entry.first] = record->second.voxelsBefore;
    }
  }
  const auto & reports = filter.GetElectrodeReports();
  WarnOfAreas(reports);
  for (std::size_t n = 0; n < reports.size(); ++n)
  {
    for (const std::string & covered : reports[n].covered)
    {
      Warn(input.electrodes.list[n].source + ": '" + reports[n].name + "' overlaps '" + covered +
           "', which is before it and gives way");
    }
  }
}

void
PrintElectrodes(std::ostream & os, const std::vector<mmm::ElectrodeReport> & electrodes)
{
  double farthest = 0.0;
  double worst = 0.0;
  for (const mmm::ElectrodeReport & electrode : electrodes)
  {
    farthest = std::fmax(farthest, electrode.projection);
    const double error = ErrorOf(electrode);
    worst = std::abs(error) > std::abs(worst) ? error : worst;
  }
  if (!electrodes.empty())
  {
    os << "electrodes: " << electrodes.size() << ", moved by up to " << std::fixed << std::setprecision(1) << farthest
       << " mm onto the skin; contact areas are within " << std::abs(100.0 * worst) << " % of those of their shapes\n";
  }
}
} // namespace cli
