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
#include "run/Run.h"

#include "console/StageClock.h"
#include "console/Warnings.h"
#include "options/FileNames.h"
#include "run/CellData.h"
#include "run/Electrodes.h"
#include "run/Hulls.h"
#include "run/Outcome.h"
#include "run/Output.h"
#include "run/Report.h"
#include "run/Summary.h"
#include "itkMeshReport.h"
#include "itkTetrahedralMeshQualityCalculator.h"

#include "itkMultiThreaderBase.h"

#include <algorithm>
#include <iostream>
#include <limits>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace cli
{
namespace
{
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

/** How many threads the system grants, of those that are wanted. */
std::uint64_t
CountThreads(std::uint64_t wanted)
{
  std::mutex               gate;
  std::vector<std::thread> threads;
  {
    const std::lock_guard<std::mutex> closed(gate);
    try
    {
      while (threads.size() < wanted)
      {
        threads.emplace_back([&gate] { const std::lock_guard<std::mutex> passed(gate); });
      }
    }
    catch (const std::exception &)
    {
      // a limit of the user or of memory
    }
  }
  for (std::thread & thread : threads)
  {
    thread.join();
  }
  return std::max<std::uint64_t>(threads.size(), 1);
}

/** ITK gives up where it gets fewer threads than it wants. */
void
SetThreads(const std::optional<std::uint64_t> & wanted)
{
  const std::uint64_t number = wanted.value_or(itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads());
  const std::uint64_t granted = CountThreads(number);
  if (granted < number)
  {
    Warn("the system starts only " + std::to_string(granted) + " of " + std::to_string(number) + " threads");
  }
  itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(itk::ThreadIdType(granted));
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
  if (outcome.settings.order == 2)
  {
    outcome.midNodes = outcome.filter->GetMidNodes();
    outcome.midNodes->DisconnectPipeline();
  }
}

void
MeasureQuality(Outcome & outcome)
{
  outcome.surfaceQuality = itk::ComputeSurfaceQuality(*outcome.surface);
  if (!outcome.settings.surfaceOnly)
  {
    const auto calculator = itk::TetrahedralMeshQualityCalculator<itk::LabelTetrahedralMesh>::New();
    calculator->SetMesh(outcome.tetrahedra);
    calculator->Compute();
    outcome.quality = calculator->GetReport();
  }
}

} // namespace

void
Run(Settings settings)
{
  if (!settings.expectOnly)
  {
    CheckOutputs(settings);
  }
  SetThreads(settings.threads);

  ProgressDisplay display(settings.quiet || settings.expectOnly ? ProgressDisplay::Style::None
                          : settings.slicerProgress             ? ProgressDisplay::Style::Slicer
                                                                : ProgressDisplay::Style::Text);
  StageClock      clock(display);
  Outcome         outcome;
  clock.Run("reading", 0.0, [&] {
    outcome.input = ReadInput(settings);
    CheckHullLabels(settings, outcome.input);
    ResolveLengths(settings, *outcome.input.labels);
    outcome.settings = settings;
    outcome.filter = MakeMeshFilter(settings, outcome.input);
  });
  RunMeshFilter(*outcome.filter, settings, display);
  if (settings.expectOnly)
  {
    std::cout << "expect about " << mmm::Describe(outcome.filter->GetReport().estimate) << '\n';
    return;
  }
  clock.Append(outcome.filter->GetStageRecords());
  FinishElectrodes(*outcome.filter, outcome.input);
  TakeMeshes(outcome);
  clock.Run("quality", 1.0, [&] { MeasureQuality(outcome); });
  if (settings.HasCellData())
  {
    clock.Run("sampling", 1.0, [&] { MakeCellData(outcome); });
  }
  clock.Run("writing", 1.0, [&] {
    MakeHulls(outcome);
    WriteMeshes(outcome);
    WriteImages(outcome);
  });
  outcome.stages = clock.GetRecords();
  outcome.seconds = clock.GetSeconds();
  outcome.settings.fillExterior = settings.IsFilled();
  outcome.settings.threads = itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads();
  WarnOfVanishedLabels(settings, *outcome.filter);
  WarnOfMergedIslands(*outcome.filter);
  WarnOfLargeTetrahedra(outcome);
  WarnOfFlatTriangles(settings);
  WriteReports(outcome);
  if (!settings.quiet)
  {
    PrintSummary(std::cout, outcome);
  }
}
} // namespace cli
