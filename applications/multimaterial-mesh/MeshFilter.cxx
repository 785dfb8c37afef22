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
#include "MeshFilter.h"

#include "Errors.h"
#include "Interruption.h"
#include "MeshOutput.h"
#include "itkIndicatorImagesToTetrahedralMeshFilter.h"

#include "itkEventObject.h"

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
    WriteSurface(surface, fileName, MeshStyle{});
  }
  catch (const std::exception &)
  {
    return false;
  }
  return true;
}

void
Configure(MeshFilter * filter, const Settings & settings)
{
  filter->SetExteriorLabels(settings.exterior);
  filter->SetMinimumIslandSize(settings.minIsland);
  filter->SetRadius(settings.radius.value_or(MeshFilter::Automatic));
  filter->SetEpsilon(settings.epsilon);
  filter->SetChordTolerance(settings.tolerance.value_or(MeshFilter::Automatic));
  filter->SetGradientLimit(settings.gradientLimit);
  filter->SetMinimumSize(settings.minSize.value_or(MeshFilter::Automatic));
  filter->SetMaximumSize(settings.maxSize.value_or(std::numeric_limits<double>::infinity()));
  filter->SetSeed(settings.seed);
  filter->SetSurfaceOnly(settings.surfaceOnly);
  filter->SetKeepIntermediates(!settings.indicatorPrefix.empty() || !settings.sizingFile.empty());
  if (!settings.sizingImage.empty())
  {
    filter->SetSizingImage(ReadScalarImage(settings.sizingImage));
  }
}
} // namespace

MeshFilter::Pointer
MakeMeshFilter(const Settings & settings, const LabelImage * labels)
{
  auto filter = MeshFilter::New();
  filter->SetInput(labels);
  Configure(filter, settings);
  return filter;
}

MeshFilter::Pointer
MakeMeshFilter(const Settings & settings, const std::vector<ScalarImage::Pointer> & indicators)
{
  auto filter = itk::IndicatorImagesToTetrahedralMeshFilter<ScalarImage>::New();
  for (std::size_t n = 0; n < indicators.size(); ++n)
  {
    filter->SetInput(static_cast<unsigned int>(n), indicators[n]);
  }
  filter->SetIndicatorLabels(settings.indicatorLabels);
  Configure(filter, settings);
  return filter.GetPointer();
}

void
RunMeshFilter(MeshFilter & filter, const Settings & settings, ProgressDisplay & display)
{
  filter.AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) {
    display.Show(filter.GetCurrentStage(), filter.GetStageProgress(), filter.GetProgress());
    if (GetInterruption() != 0)
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
    throw;
  }
  catch (const std::exception &)
  {
    const std::string reason = DescribeCurrentException();
    const std::string kept = InspectionName(settings.output);
    throw Error(KeepSurface(filter, kept) ? reason + "; the surface is kept for inspection in " + kept : reason);
  }
  display.Finish();
}
} // namespace cli
