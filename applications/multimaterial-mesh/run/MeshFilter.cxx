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
#include "run/MeshFilter.h"

#include "console/Errors.h"
#include "console/Interruption.h"
#include "itkErrorDrivenSizing.h"
#include "itkIndicatorImagesToTetrahedralMeshFilter.h"
#include "itkLabelMeshFileWriter.h"

#include "itkEventObject.h"
#include "itksys/SystemInformation.hxx"

#include <algorithm>
#include <limits>

namespace cli
{
namespace
{
/** OUTPUT "a/b.vtu" gives "a/b-surface-for-inspection.vtu". */
std::string
InspectionName(const std::string & output)
{
  return output.substr(0, output.rfind('.')) + "-surface-for-inspection.vtu";
}

/** Returns whether there was a surface and it is safe on disk. */
bool
KeepSurface(MeshFilter & filter, const std::string & fileName)
{
  itk::LabelInterfaceMesh::Pointer surface = filter.GetSurface();
  if (surface->GetNumberOfCells() == 0)
  {
    return false;
  }
  // The writer would start the filter again.
  surface->DisconnectPipeline();
  try
  {
    const auto writer = itk::LabelMeshFileWriter::New();
    writer->SetSurface(surface);
    writer->SetFileName(fileName);
    writer->Write();
  }
  catch (const std::exception &)
  {
    return false;
  }
  return true;
}

MeshFilter::MaskImageType::Pointer
MakeMask(const LabelImage * image)
{
  auto         mask = MeshFilter::MaskImageType::New();
  const auto & region = image->GetBufferedRegion();
  mask->CopyInformation(image);
  mask->SetRegions(region);
  mask->Allocate();
  std::transform(image->GetBufferPointer(),
                 image->GetBufferPointer() + region.GetNumberOfPixels(),
                 mask->GetBufferPointer(),
                 [](int value) { return value != 0; });
  return mask;
}

/** In GB; 0 where the system does not tell. */
double
MemoryOfMachine()
{
  itksys::SystemInformation information;
  return static_cast<double>(information.GetHostMemoryTotal()) / (1024.0 * 1024.0);
}

/** The edge lengths that the errors of a solution ask for, on the grid of an image. */
itk::ErrorDrivenSizing::ImageType::Pointer
SizesByErrors(const Settings & settings, const itk::ImageBase<3> * grid)
{
  const auto sizing = itk::ErrorDrivenSizing::New();
  if (settings.refineFactor)
  {
    sizing->SetFactor(*settings.refineFactor);
  }
  sizing->SetOrder(static_cast<unsigned int>(settings.order));
  sizing->ReadErrors(settings.refineBy);
  return sizing->Compute(grid);
}

void
Configure(MeshFilter * filter, const Settings & settings, const itk::ImageBase<3> * grid)
{
  ForEachOption([&](const Option & option) {
    if (option.target.set != nullptr)
    {
      option.target.set(*filter, settings);
    }
  });
  if (settings.expectOnly)
  {
    filter->SetMaximumNumberOfTetrahedra(std::numeric_limits<itk::SizeValueType>::max());
    filter->SetMaximumMemory(std::numeric_limits<double>::infinity());
  }
  else if (const double memory = MemoryOfMachine(); !settings.maxMemory && memory > 0.0)
  {
    filter->SetMaximumMemory(memory);
  }
  filter->SetSizingImageReplaces(settings.sizingMode == "replace");
  filter->SetCompareTopology(!settings.reports.empty());
  filter->SetKeepIntermediates(!settings.indicatorPrefix.empty() || !settings.sizingFile.empty());
  if (!settings.sizingImage.empty())
  {
    filter->SetSizingImage(ReadScalarImage(settings.sizingImage));
  }
  else if (!settings.refineBy.empty())
  {
    filter->SetSizingImage(SizesByErrors(settings, grid));
  }
  if (!settings.roi.empty())
  {
    filter->SetRegionOfInterest(MakeMask(ReadLabelImage(settings.roi)));
  }
}
} // namespace

MeshFilter::Pointer
MakeMeshFilter(const Settings & settings, const Input & input)
{
  if (input.indicators.empty())
  {
    auto filter = MeshFilter::New();
    filter->SetInput(input.labels);
    for (std::size_t n = 0; n < input.surfaces.distances.size(); ++n)
    {
      filter->SetSurfaceDistanceImage(static_cast<unsigned int>(n), input.surfaces.distances[n]);
    }
    filter->SetSurfaceLabels(input.surfaces.labels);
    filter->SetElectrodes(input.electrodes);
    Configure(filter, settings, input.labels);
    return filter;
  }
  auto filter = itk::IndicatorImagesToTetrahedralMeshFilter<ScalarImage>::New();
  for (std::size_t n = 0; n < input.indicators.size(); ++n)
  {
    filter->SetInput(static_cast<unsigned int>(n), input.indicators[n]);
  }
  filter->SetIndicatorLabels(settings.indicatorLabels);
  Configure(filter, settings, input.indicators.front());
  return filter.GetPointer();
}

void
RunMeshFilter(MeshFilter & filter, const Settings & settings, ProgressDisplay & display)
{
  bool isEstimateShown = false;
  filter.AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) {
    const mmm::MeshEstimate & estimate = filter.GetReport().estimate;
    if (!isEstimateShown && estimate.points > 0.0)
    {
      isEstimateShown = true;
      display.Note("expect about " + mmm::Describe(estimate));
    }
    display.Show(filter.GetCurrentStage(), filter.GetStageProgress(), filter.GetProgress());
    if (GetInterruption() != 0 || (isEstimateShown && settings.expectOnly))
    {
      filter.AbortGenerateDataOn();
    }
  });
  try
  {
    filter.Update();
  }
  catch (const itk::ProcessAborted &)
  {
    if (!settings.expectOnly || GetInterruption() != 0)
    {
      throw;
    }
  }
  catch (const std::exception &)
  {
    std::string reason = DescribeCurrentException();
    if (!settings.maxMemory && filter.GetReport().estimate.memory > filter.GetMaximumMemory())
    {
      reason += "; this is the machine's memory, and --max-memory sets another limit";
    }
    const std::string kept = InspectionName(settings.output);
    throw Error(KeepSurface(filter, kept) ? reason + "; the surface is kept for inspection in " + kept : reason);
  }
  display.Finish();
}
} // namespace cli
