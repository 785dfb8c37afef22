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
#include "Run.h"

#include "Errors.h"
#include "IndicatorInput.h"
#include "ImageOutput.h"
#include "LabelSurface.h"
#include "MeshOutput.h"
#include "Outcome.h"
#include "OutputFile.h"
#include "Report.h"
#include "StageClock.h"
#include "Summary.h"
#include "SurfaceQuality.h"
#include "itkTetrahedralMeshQualityCalculator.h"

#include "itkMultiThreaderBase.h"

#include <algorithm>
#include <iostream>
#include <limits>
#include <utility>

namespace cli
{
namespace
{
std::string
IndicatorName(const Settings & settings, int label)
{
  return settings.indicatorPrefix + std::to_string(label) + ".nrrd";
}

/** A file and the option that it stands for. */
using NamedFile = std::pair<std::string, std::string>;

void
AddFile(std::vector<NamedFile> & files, const std::string & option, const std::string & name)
{
  if (!name.empty())
  {
    files.emplace_back(option, name);
  }
}

std::vector<NamedFile>
InputFiles(const Settings & settings)
{
  std::vector<NamedFile> files;
  AddFile(files, "LABELS", settings.labels);
  for (const std::string & indicator : settings.indicators)
  {
    AddFile(files, "--indicators", indicator);
  }
  AddFile(files, "--sizing-image", settings.sizingImage);
  AddFile(files, "--roi", settings.roi);
  return files;
}

/** Those that are not named by label. */
std::vector<NamedFile>
OutputFiles(const Settings & settings)
{
  std::vector<NamedFile> files;
  AddFile(files, "OUTPUT", settings.output);
  AddFile(files, "--surface", settings.surface);
  AddFile(files, "--particles", settings.particles);
  AddFile(files, "--junctions", settings.junctions);
  AddFile(files, "--report", settings.report);
  AddFile(files, "--save-sizing", settings.sizingFile);
  return files;
}

/** The outputs that are named by a prefix and label 0. */
std::vector<NamedFile>
OutputFilesForZero(const Settings & settings)
{
  std::vector<NamedFile> files;
  if (!settings.indicatorPrefix.empty())
  {
    AddFile(files, "--save-indicators", IndicatorName(settings, 0));
  }
  if (!settings.surfacePrefix.empty())
  {
    AddFile(files, "--surface-per-label", NameForLabel(settings.surfacePrefix, 0));
  }
  return files;
}

std::vector<NamedFile>
Joined(std::vector<NamedFile> files, const std::vector<NamedFile> & others)
{
  files.insert(files.end(), others.begin(), others.end());
  return files;
}

/** Hours of work shall not be lost to a misspelled folder. */
void
CheckOutputs(const Settings & settings)
{
  if (!settings.sizingFile.empty())
  {
    CheckImageName("--save-sizing", settings.sizingFile);
  }
  auto others = InputFiles(settings);
  for (const NamedFile & output : Joined(OutputFiles(settings), OutputFilesForZero(settings)))
  {
    for (const NamedFile & other : others)
    {
      if (IsSameFile(output.second, other.second))
      {
        throw UsageError(other.first + " and " + output.first + " are the same file, " + output.second);
      }
    }
    CheckWritable(output.second);
    others.push_back(output);
  }
}

/** Whether a name is a prefix, a label and a suffix. */
bool
IsNameForLabel(const std::string & name, const std::string & prefix, const std::string & suffix)
{
  if (name.size() <= prefix.size() + suffix.size() || name.compare(0, prefix.size(), prefix) != 0 ||
      name.compare(name.size() - suffix.size(), suffix.size(), suffix) != 0)
  {
    return false;
  }
  const auto digits = name.substr(prefix.size(), name.size() - prefix.size() - suffix.size());
  return digits.find_first_not_of("-0123456789") == std::string::npos;
}

/** Names that are made of a prefix and a label must not be those of other files. */
void
CheckPrefixes(const Settings & settings)
{
  const auto others = Joined(InputFiles(settings), OutputFiles(settings));
  for (const auto & [option, forZero] : OutputFilesForZero(settings))
  {
    const auto stem = forZero.substr(0, forZero.rfind("0."));
    const auto suffix = forZero.substr(stem.size() + 1);
    for (const NamedFile & other : others)
    {
      if (IsNameForLabel(other.second, stem, suffix))
      {
        throw UsageError(option + " could write to " + other.second + ", which is the file of " + other.first +
                         "; choose another prefix");
      }
    }
  }
}

/** Fills in the lengths that follow from the image, so that they can be reported. */
void
ResolveLengths(Settings & settings, const LabelImage & labels)
{
  const auto & spacing = labels.GetSpacing();
  const double smallest = std::min({ spacing[0], spacing[1], spacing[2] });
  if (settings.indicators.empty())
  {
    settings.radius = settings.radius.value_or(0.5 * smallest);
  }
  settings.tolerance = settings.tolerance.value_or(0.1 * smallest);
  const double infinity = std::numeric_limits<double>::infinity();
  settings.minSize = settings.minSize.value_or(std::min(
    { smallest, settings.maxSize.value_or(infinity), mmm::SizeOfVolume(settings.maxVolume.value_or(infinity)) }));
}

void
TakeMeshes(Outcome & outcome)
{
  outcome.tetrahedra = outcome.filter->GetOutput();
  outcome.surface = outcome.filter->GetSurface();
  outcome.particles = outcome.filter->GetParticles();
  outcome.junctions = outcome.filter->GetJunctions();
  // Writers would ask the filter to run again.
  outcome.tetrahedra->DisconnectPipeline();
  outcome.surface->DisconnectPipeline();
  outcome.particles->DisconnectPipeline();
  outcome.junctions->DisconnectPipeline();
}

void
MeasureQuality(Outcome & outcome)
{
  outcome.surfaceQuality = ComputeSurfaceQuality(*outcome.surface);
  if (!outcome.settings.surfaceOnly)
  {
    const auto calculator = itk::TetrahedralMeshQualityCalculator<itk::LabelTetrahedralMesh>::New();
    calculator->SetMesh(outcome.tetrahedra);
    calculator->Compute();
    outcome.quality = calculator->GetReport();
  }
}

void
WriteMeshes(const Outcome & outcome)
{
  const Settings & settings = outcome.settings;
  const int        outside = outcome.filter->GetOutsideLabel();
  const MeshStyle  style = StyleOf(settings, outside);
  if (settings.surfaceOnly)
  {
    WriteSurface(outcome.surface, settings.output, style);
  }
  else
  {
    WriteVolume(outcome.tetrahedra, outcome.surface, settings.output, style);
  }
  if (!settings.surface.empty())
  {
    WriteSurface(outcome.surface, settings.surface, style);
  }
  if (!settings.surfacePrefix.empty())
  {
    for (const int label : EnclosedLabels(outcome.surface, outside))
    {
      WriteSurface(ExtractLabelSurface(outcome.surface, label), NameForLabel(settings.surfacePrefix, label), style);
    }
  }
  if (!settings.particles.empty())
  {
    WriteParticles(outcome.particles, settings.particles);
  }
  if (!settings.junctions.empty())
  {
    WriteJunctions(outcome.junctions, settings.junctions);
  }
}

void
WriteImages(const Outcome & outcome)
{
  const Settings & settings = outcome.settings;
  if (!settings.sizingFile.empty())
  {
    WriteImage(outcome.filter->GetComputedSizingImage(), settings.sizingFile);
  }
  if (!settings.indicatorPrefix.empty())
  {
    for (const int label : outcome.filter->GetLabels())
    {
      WriteImage(outcome.filter->GetIndicatorImage(label), IndicatorName(settings, label));
    }
  }
}
} // namespace

void
Run(Settings settings)
{
  CheckOutputs(settings);
  CheckPrefixes(settings);
  if (settings.threads)
  {
    itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(itk::ThreadIdType(*settings.threads));
  }

  ProgressDisplay display(settings.quiet            ? ProgressDisplay::Style::None
                          : settings.slicerProgress ? ProgressDisplay::Style::Slicer
                                                    : ProgressDisplay::Style::Text);
  StageClock      clock(display);
  Outcome         outcome;
  clock.Run("reading", 0.0, [&] {
    IndicatorInput indicators;
    if (settings.indicators.empty())
    {
      outcome.labels = ReadLabelImage(settings.labels);
      outcome.voxels = CheckLabels(settings.labels, *outcome.labels);
    }
    else
    {
      indicators = ReadIndicators(settings);
      outcome.labels = indicators.labels;
      outcome.voxels = mmm::CountLabels(outcome.labels.GetPointer());
      WarnOfAbsentIndicators(settings, outcome.voxels);
    }
    CheckLabelsFit(settings, outcome.voxels);
    WarnOfAbsentExterior(settings, outcome.voxels);
    ResolveLengths(settings, *outcome.labels);
    outcome.settings = settings;
    outcome.filter = settings.indicators.empty() ? MakeMeshFilter(settings, outcome.labels)
                                                 : MakeMeshFilter(settings, indicators.images);
  });
  RunMeshFilter(*outcome.filter, settings, display);
  clock.Append(outcome.filter->GetStageRecords());
  TakeMeshes(outcome);
  clock.Run("quality", 1.0, [&] { MeasureQuality(outcome); });
  clock.Run("writing", 1.0, [&] {
    WriteMeshes(outcome);
    WriteImages(outcome);
  });
  outcome.stages = clock.GetRecords();
  if (!settings.report.empty())
  {
    WriteTextFile(settings.report, MakeReport(outcome));
  }
  WarnOfVanishedLabels(settings, *outcome.filter);
  WarnOfLargeTetrahedra(outcome);
  if (!settings.quiet)
  {
    PrintSummary(std::cout, outcome);
  }
}
} // namespace cli
