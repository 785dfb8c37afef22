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
#include "options/SettingsCheck.h"

#include "console/Errors.h"
#include "options/FileNames.h"
#include "itkLabelMeshFileWriter.h"

#include <algorithm>
#include <set>
#include <sstream>

namespace cli
{
namespace
{
/** Whether a file is written that can be in RAS. */
bool
HasOtherFileThanVTU(const Settings & settings)
{
  const auto files = MeshFiles(settings);
  return std::any_of(
    files.begin(), files.end(), [](const std::string & name) { return FindExtension(Kind::Surface, name) != ".vtu"; });
}

void
CheckRegion(const Settings & settings)
{
  const auto & smallest = settings.roiMinSize;
  const auto & largest = settings.roiMaxSize;
  if (settings.roi.empty() != !(smallest || largest))
  {
    throw UsageError("--roi needs --roi-min-size or --roi-max-size, and these need --roi");
  }
  if (smallest && largest && *smallest > *largest)
  {
    std::ostringstream message;
    message << "--roi-min-size is " << *smallest << " mm, but --roi-max-size is only " << *largest << " mm";
    throw UsageError(message.str());
  }
}

/** Elements of second order are wanted where there are some. */
void
CheckOrder(const Settings & settings)
{
  for (const std::string & name : { settings.output, settings.surface })
  {
    if (settings.order == 2 && FindExtension(Kind::Surface, name) == ".mesh")
    {
      throw UsageError("--order 2 is for .vtu and .msh files, and not for " + name);
    }
  }
  if (settings.order == 2 && settings.mshFormat == "simnibs")
  {
    throw UsageError("--order 2 is not for --msh-format simnibs: SimNIBS has elements of first order");
  }
}

void
CheckSurfaces(const Settings & settings)
{
  if (settings.surfaceLabels.empty())
  {
    if (settings.surfaceSpacing || settings.surfacesAreInRAS)
    {
      throw UsageError("--surface-spacing and --surface-ras need --surface-label");
    }
    return;
  }
  if (!settings.indicators.empty())
  {
    throw UsageError("--surface-label goes on top of LABELS, not of --indicators");
  }
  if (settings.labels.empty())
  {
    if (!settings.onlyLabels.empty() || !settings.merges.empty() || !settings.labelMap.empty())
    {
      throw UsageError("--labels, --merge and --map are for LABELS; --surface-label has its own");
    }
    if (!settings.sizingImage.empty() || !settings.roi.empty())
    {
      throw UsageError("--sizing-image and --roi are on the grid of LABELS; --surface-label alone has none");
    }
  }
  else if (settings.surfaceSpacing)
  {
    throw UsageError("--surface-spacing is for surfaces alone; the grid is that of LABELS");
  }
}

void
CheckHulls(const Settings & settings)
{
  for (const Hull & hull : settings.hulls)
  {
    for (const int label : hull.labels)
    {
      if (settings.IsExterior(label) && !settings.IsFilled())
      {
        throw UsageError("--hull " + hull.file + " has the label " + std::to_string(label) +
                         ", which is exterior and not meshed");
      }
    }
  }
}

void
CheckCellData(const Settings & settings)
{
  const auto & extensions = itk::LabelMeshFileWriter::GetCellDataExtensions();
  if (!settings.HasCellData())
  {
    return;
  }
  const std::string option = settings.conductivity.empty() ? "--cell-data" : "--conductivity";
  if (settings.surfaceOnly)
  {
    throw UsageError(option + " is for tetrahedra, which --surface-only leaves out");
  }
  if (itk::LabelMeshFileWriter::FindExtension(settings.output, extensions).empty())
  {
    throw UsageError(option + " is for .vtu and .msh; OUTPUT is '" + settings.output +
                     "', which cannot hold data of tetrahedra");
  }
  std::set<std::string> names;
  if (!settings.conductivity.empty())
  {
    names.insert("conductivity");
  }
  for (const CellDataRequest & request : settings.cellData)
  {
    if (!names.insert(request.name).second)
    {
      throw UsageError("there are two cell data of the name '" + request.name + "'");
    }
  }
}
} // namespace

void
CheckSettings(const Settings & settings)
{
  CheckFileFormats(settings);
  if (settings.minSize && settings.maxSize && *settings.minSize > *settings.maxSize)
  {
    std::ostringstream message;
    message << "--min-size is " << *settings.minSize << " mm, but --max-size is only " << *settings.maxSize << " mm";
    throw UsageError(message.str());
  }
  if (settings.sizingMode == "replace" && settings.sizingImage.empty())
  {
    throw UsageError("--sizing-mode replace needs --sizing-image");
  }
  if (!settings.refineBy.empty() && !settings.sizingImage.empty())
  {
    throw UsageError("--refine-by makes a sizing image of its own; leave out --sizing-image");
  }
  if (settings.refineFactor && settings.refineBy.empty())
  {
    throw UsageError("--refine-factor needs --refine-by");
  }
  CheckCellData(settings);
  CheckRegion(settings);
  CheckOrder(settings);
  CheckHulls(settings);
  CheckSurfaces(settings);
  if (!settings.electrodes.empty() && !settings.indicators.empty())
  {
    throw UsageError("--electrodes are for LABELS and surfaces, not for --indicators");
  }
  if (settings.IsFilled() && settings.exterior.empty())
  {
    throw UsageError("--fill-exterior and --air-margin need an exterior label; leave out --exterior none");
  }
  if (!settings.onlyLabels.empty() && settings.exterior.empty())
  {
    throw UsageError("--labels needs an exterior label for all others; leave out --exterior none");
  }
  if (!settings.indicators.empty() &&
      (!settings.onlyLabels.empty() || !settings.merges.empty() || !settings.labelMap.empty()))
  {
    throw UsageError("--labels, --merge and --map are for LABELS; choose among the --indicators instead");
  }
  if (settings.airMargin && !settings.indicators.empty())
  {
    throw UsageError("--air-margin is for LABELS; --fill-exterior meshes the exterior of --indicators");
  }
  if (settings.indicators.empty() && !settings.indicatorLabels.empty())
  {
    throw UsageError("--indicator-labels is for --indicators; LABELS have their own");
  }
  if (!settings.indicatorLabels.empty() && settings.indicatorLabels.size() != settings.indicators.size())
  {
    throw UsageError("--indicator-labels has " + std::to_string(settings.indicatorLabels.size()) + " labels for " +
                     std::to_string(settings.indicators.size()) + " indicators");
  }
  if (!settings.indicators.empty() && settings.radius)
  {
    throw UsageError("--radius is for LABELS; interfaces of indicators are not smoothed");
  }
  if (settings.surfaceOnly && !settings.surface.empty())
  {
    throw UsageError("with --surface-only, OUTPUT is the surface; leave out --surface");
  }
  if (settings.ras && !HasOtherFileThanVTU(settings))
  {
    throw UsageError("--ras is for other files than .vtu, whose points are always in LPS");
  }
}
} // namespace cli
