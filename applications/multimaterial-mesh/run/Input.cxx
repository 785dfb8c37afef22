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
#include "run/Input.h"

#include "console/Errors.h"
#include "console/StreamCapture.h"
#include "console/Warnings.h"
#include "options/FileNames.h"
#include "run/Conductivity.h"
#include "run/Electrodes.h"
#include "run/LabelChanges.h"
#include "run/Surfaces.h"
#include "itkIndicatorImagesToLabelImageFilter.h"

#include <algorithm>
#include <set>
#include <sstream>

namespace cli
{
namespace
{
/** Libraries complain on stderr. */
template <typename TRead>
auto
ReadBy(const std::string & fileName, const TRead & read)
{
  const auto reader = itk::VolumeFileReader::New();
  reader->SetFileName(fileName);
  StreamCapture     capture;
  const auto        image = read(*reader);
  const std::string complaint = capture.Finish();
  if (!complaint.empty())
  {
    // ITK's reader of these does not fail where the end of the file is missing.
    const auto extension = fileName.substr(std::min(fileName.size(), fileName.rfind('.')));
    if (extension == ".mha" || extension == ".mhd")
    {
      throw Error(fileName + ": the image cannot be read, it may be damaged: " + ToOneLine(complaint));
    }
    Warn(fileName + ": " + ToOneLine(complaint));
  }
  return image;
}

/** Throws if the image has no two labels, or looks like intensities. */
void
CheckLabels(const std::string & fileName, const Input & input, bool isForced)
{
  if (input.voxels.size() == 1)
  {
    throw Error(fileName + ": all voxels have the value " + std::to_string(input.voxels.begin()->first) +
                "; a label image needs at least two labels");
  }
  const std::string intensities = mmm::DescribeIntensities(input.labels.GetPointer(), input.voxels);
  if (!intensities.empty() && !isForced)
  {
    throw Error(fileName + ": the image " + intensities + ", or mesh it as it is by --labels-anyway");
  }
}

/** Where indicators are equal, between voxels, is all that there is to tell an interface. */
void
WarnOfMask(const std::string & fileName, const ScalarImage & image)
{
  const float * const begin = image.GetBufferPointer();
  const float * const end = begin + image.GetBufferedRegion().GetNumberOfPixels();
  const auto [lowest, highest] = std::minmax_element(begin, end);
  const float low = *lowest;
  const float high = *highest;
  if (std::all_of(begin, end, [=](float value) { return value == low || value == high; }) && low != high)
  {
    Warn(fileName +
         ": the image has two values only, so that interfaces follow the voxels' steps; masks are smoothed if "
         "they are joined to one label image, LABELS");
  }
}

/** Warns of voxels that are far from cubes. */
void
WarnOfSpacing(const LabelImage & image)
{
  constexpr double mostRatio = 5.0;
  const auto &     spacing = image.GetSpacing();
  const double     largest = std::max({ spacing[0], spacing[1], spacing[2] });
  const double     smallest = std::min({ spacing[0], spacing[1], spacing[2] });
  if (largest > mostRatio * smallest)
  {
    std::ostringstream text;
    text << "voxels are " << largest / smallest << " times as long as wide; interfaces are uncertain along them, and "
         << "sizes follow the width; resample the image or give --min-size";
    Warn(text.str());
  }
}

Input
ReadIndicators(const Settings & settings)
{
  Input      input;
  const auto filter = itk::IndicatorImagesToLabelImageFilter<ScalarImage, LabelImage>::New();
  for (const std::string & fileName : settings.indicators)
  {
    const auto image = ReadScalarImage(fileName);
    image->SetObjectName(fileName);
    WarnOfMask(fileName, *image);
    filter->SetInput(static_cast<unsigned int>(input.indicators.size()), image);
    input.indicators.push_back(image);
  }
  filter->SetIndicatorLabels(settings.indicatorLabels);
  filter->SetExteriorLabels(settings.exterior);
  filter->Update();
  input.labels = filter->GetOutput();
  input.labels->DisconnectPipeline();
  return input;
}

/** Warns of materials that are the largest nowhere. */
void
WarnOfAbsentIndicators(const Settings & settings, const mmm::LabelCounts & voxels)
{
  for (std::size_t n = 0; n < settings.indicators.size(); ++n)
  {
    const int label = settings.indicatorLabels.empty() ? static_cast<int>(n + 1) : settings.indicatorLabels[n];
    if (voxels.count(label) == 0)
    {
      Warn(settings.indicators[n] + ": the image is the largest nowhere, so label " + std::to_string(label) +
           " is not in the mesh");
    }
  }
}

/** Warns of what has no effect. */
void
WarnOfUnusedFormat(const Settings & settings)
{
  const auto files = MeshFiles(settings);
  const auto isMsh = [](const std::string & name) { return FindExtension(Kind::Surface, name) == ".msh"; };
  if (settings.mshFormat != Settings{}.mshFormat && std::none_of(files.begin(), files.end(), isMsh))
  {
    Warn("--msh-format " + settings.mshFormat + " has no effect, as no .msh file is written");
  }
}

/** Throws if the mesh would have labels that there are not in the format of the output. */
void
CheckLabelsFit(const Settings & settings, const mmm::LabelCounts & voxels)
{
  if (settings.mshFormat != "simnibs")
  {
    return;
  }
  const auto check = [](int label, const std::string & advice) {
    if (label < 1 || label > 999)
    {
      throw Error("--msh-format simnibs: SimNIBS numbers tissues from 1 to 999, and label " + std::to_string(label) +
                  advice + ", or take another format");
    }
  };
  for (const auto & entry : voxels)
  {
    if (!settings.IsExterior(entry.first))
    {
      check(entry.first, " is to be meshed; list it in --exterior, give it another number");
    }
  }
  if (const auto air = LabelOfAir(settings, voxels))
  {
    check(*air, " is that of the air; leave out --fill-exterior and --air-margin, give it another number");
  }
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

SampledImage
ReadSampledImage(const CellDataRequest & request)
{
  return ReadBy(request.file, [&](itk::VolumeFileReader & reader) {
    reader.SetTensorsInVoxelAxes(request.inVoxelAxes);
    return reader.HasTensors() ? SampledImage{ nullptr, reader.ReadTensors() }
                               : SampledImage{ reader.ReadScalars(), nullptr };
  });
}

std::set<int>
LabelsToMesh(const Settings & settings, const mmm::LabelCounts & voxels)
{
  std::set<int> labels;
  for (const auto & entry : voxels)
  {
    if (!settings.IsExterior(entry.first))
    {
      labels.insert(entry.first);
    }
  }
  if (const auto air = LabelOfAir(settings, voxels))
  {
    labels.insert(*air);
  }
  return labels;
}
} // namespace

LabelImage::Pointer
ReadLabelImage(const std::string & fileName)
{
  return ReadBy(fileName, [](itk::VolumeFileReader & reader) { return reader.ReadLabels(); });
}

ScalarImage::Pointer
ReadScalarImage(const std::string & fileName)
{
  return ReadBy(fileName, [](itk::VolumeFileReader & reader) { return reader.ReadScalars(); });
}

Input
ReadInput(const Settings & settings)
{
  Input              input;
  std::map<int, int> changes;
  const bool         hasIndicators = !settings.indicators.empty();
  const bool         areSurfacesAlone = settings.labels.empty() && !hasIndicators;
  if (hasIndicators)
  {
    input = ReadIndicators(settings);
  }
  else if (!areSurfacesAlone)
  {
    const LabelChanges labelChanges(settings);
    input.labels = ReadLabelImage(settings.labels);
    changes = labelChanges.Apply(*input.labels);
  }
  if (!settings.surfaceLabels.empty())
  {
    AddSurfaces(settings, input);
  }
  else
  {
    input.voxels = mmm::CountLabels(input.labels.GetPointer());
  }
  if (hasIndicators)
  {
    WarnOfAbsentIndicators(settings, input.voxels);
  }
  else if (!areSurfacesAlone)
  {
    CheckLabels(settings.labels, input, settings.labelsAnyway);
  }
  if (!settings.electrodes.empty())
  {
    AddElectrodes(settings, input);
  }
  if (settings.keepSlices || hasIndicators || !settings.surfaceLabels.empty())
  {
    WarnOfSpacing(*input.labels);
  }
  WarnOfUnusedFormat(settings);
  CheckLabelsFit(settings, input.voxels);
  WarnOfAbsentExterior(settings, input.voxels);
  const auto meshed = LabelsToMesh(settings, input.voxels);
  input.names = ReadLabelNames(settings, changes, meshed, mmm::NamesOf(input.electrodes));
  if (!settings.conductivity.empty())
  {
    input.conductivity = ReadConductivity(settings.conductivity, input.names, meshed);
  }
  for (const CellDataRequest & request : settings.cellData)
  {
    input.cellData.push_back(ReadSampledImage(request));
  }
  return input;
}

std::optional<int>
LabelOfAir(const Settings & settings, const mmm::LabelCounts & voxels)
{
  if (!settings.IsFilled())
  {
    return std::nullopt;
  }
  const auto isThere = [&](int label) { return voxels.count(label) != 0; };
  const auto first = std::find_if(settings.exterior.begin(), settings.exterior.end(), isThere);
  if (first != settings.exterior.end())
  {
    return *first;
  }
  return settings.airMargin > 0.0 ? std::optional<int>(settings.exterior.front()) : std::nullopt;
}
} // namespace cli
