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
#include "itk/IndicatorMeshing.h"

#include "itk/FilterMonitor.h"
#include "itk/IndicatorImages.h"
#include "itk/MeshOutput.h"
#include "itk/ReportTranslation.h"
#include "itk/SizingImage.h"
#include "itk/SizingOptions.h"
#include "pipeline/Mesher.h"
#include "sizing/MeshEstimate.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace mmm
{
namespace
{
/** Throws if a limit would be passed; `unit` is that of the sizes, in mm. */
void
VerifyEstimate(const MeshEstimator &  estimator,
               const MeshEstimate &   estimate,
               const MeshingOptions & options,
               double                 unit)
{
  const auto most = static_cast<double>(options.maximumNumberOfTetrahedra);
  const bool isTooLarge = estimate.tetrahedra > most;
  if (!isTooLarge && estimate.memory <= options.maximumMemory)
  {
    return;
  }
  std::ostringstream words;
  words << "About " << Describe(estimate) << " are to be expected, more than the limit of ";
  if (isTooLarge)
  {
    words << options.maximumNumberOfTetrahedra << " tetrahedra.";
  }
  else
  {
    words << options.maximumMemory << " GB.";
  }
  const double size = unit * estimator.SmallestSizeFor(most, options.maximumMemory);
  if (std::isfinite(size))
  {
    words << " A smallest size of " << RoundUp(size) << " mm is expected to keep to it.";
  }
  else
  {
    words << " No smallest size is expected to keep to it: the images or their thin parts take more. Larger voxels or "
             "fewer labels would help.";
  }
  itkGenericExceptionMacro(<< words.str());
}

/** \brief A number of tetrahedra that is asked for: sizes are scaled so that the mesh has a few more, and coarsening
 * takes what is too much. */
struct WantedNumber
{
  /** An estimate is hardly ever this far off; where it is, the sizes are scaled again. */
  static constexpr double Surplus = 1.1;
  static constexpr double Tolerance = 0.05;
  static constexpr int    Attempts = 3;

  std::size_t number;

  /** For sizes, at most 1. */
  double
  FirstFactor(const MeshEstimator & estimator) const
  {
    return number > 0 ? estimator.FactorFor(Surplus * double(number)) : 1.0;
  }
  bool
  IsMissed(std::size_t count) const
  {
    return double(count) < (1.0 - Tolerance) * double(number);
  }
  /** By which sizes that gave `count` have to shrink further. */
  double
  NextFactor(std::size_t count) const
  {
    return std::cbrt(double(count) / (Surplus * double(number)));
  }
  bool
  IsExceeded(std::size_t count) const
  {
    return number > 0 && double(count) > (1.0 + Tolerance) * double(number);
  }
};

/** What there will be after coarsening. */
MeshEstimate
Coarsened(MeshEstimate estimate, std::size_t number)
{
  if (number > 0 && estimate.tetrahedra > double(number))
  {
    const double share = double(number) / estimate.tetrahedra;
    estimate.tetrahedra *= share;
    estimate.points *= share;
    estimate.triangles *= std::cbrt(share * share);
  }
  return estimate;
}

MeshingParameters
ParametersOf(const MeshingInputs & inputs)
{
  MeshingParameters parameters;
  parameters.exterior = inputs.indicators.exterior;
  parameters.seed = inputs.options.seed;
  parameters.surfaceOnly = inputs.options.surfaceOnly;
  parameters.numberOfTetrahedra = inputs.options.numberOfTetrahedra;
  parameters.secondOrder = inputs.options.elementOrder == 2;
  parameters.keepTopology = inputs.keepTopology;
  parameters.compareTopology = inputs.options.compareTopology;
  return parameters;
}
} // namespace

std::string
DescribeError(const MeshingInputs & inputs)
{
  const std::string error = DescribeError(inputs.indicators);
  if (!error.empty())
  {
    return error;
  }
  if (inputs.sizing == nullptr)
  {
    return "The input \"SizingImage\" is not a three-dimensional image of float.";
  }
  auto sorted = inputs.indicators.labels;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end())
  {
    return "The label " + std::to_string(*twice) + " is given to more than one indicator image.";
  }
  return DescribeError(inputs.options);
}

std::string
DescribeGeometryError(const MeshingInputs & inputs)
{
  const auto &       images = inputs.indicators.images;
  const auto         region = UnionOfRegions(images);
  const auto         sizes = inputs.sizing->GetLargestPossibleRegion();
  std::ostringstream words;
  const auto         other = std::find_if(
    images.begin(), images.end(), [&](const FloatImage * image) { return !HaveSameGeometry(images[0], image); });
  if (other != images.end())
  {
    words << "Indicator image " << other - images.begin()
          << " differs from indicator image 0 in origin, spacing or direction.";
  }
  else if (!HaveSameGeometry(images[0], inputs.sizing))
  {
    words << "The sizing image differs from the indicator images in origin, spacing or direction.";
  }
  else if (sizes != region)
  {
    words << "The sizing image covers " << sizes << " and the indicator images together " << region
          << ". They must be the same.";
  }
  else if (inputs.reference && inputs.reference->GetLargestPossibleRegion().GetSize() != region.GetSize())
  {
    words << "The reference image has " << inputs.reference->GetLargestPossibleRegion().GetSize()
          << " voxels and the sizing image " << region.GetSize() << ". They must be the same.";
  }
  return words.str();
}

void
MeshIndicators(const MeshingInputs &         inputs,
               const std::function<void()> & releaseInputs,
               const MeshingOutputs &        outputs,
               MeshingState &                state,
               Monitor &                     monitor)
{
  monitor.BeginStage("preparation");
  const int             exterior = inputs.indicators.exterior;
  const IndicatorImages images(inputs.indicators.images);
  auto                  sizes = ReadSizingImage(inputs.sizing, images.GetGeometry());
  const IndicatorSet    indicators = images.MakeIndicatorSet();
  releaseInputs();
  const GridGeometry outputGeometry = inputs.reference
                                        ? GridGeometry(inputs.reference, inputs.reference->GetLargestPossibleRegion())
                                        : images.GetGeometry();

  const MeshEstimator estimator(
    indicators, exterior, SizingField(indicators.GetGrid(), sizes.data()), inputs.options.surfaceOnly);
  const WantedNumber wanted{ inputs.options.numberOfTetrahedra };
  const auto         scale = [&sizes](double by) {
    std::for_each(sizes.begin(), sizes.end(), [by](float & size) { size = float(by * size); });
  };
  const double factor = wanted.FirstFactor(estimator);
  scale(factor);
  state.report.estimate = Coarsened(estimator.Estimate(0.0, factor), wanted.number);
  VerifyEstimate(estimator, state.report.estimate, inputs.options, outputGeometry.GetUnit());

  MeshingResult result;
  result.report.estimate = state.report.estimate;
  const InterfaceLabels labels(inputs.indicators.labels, exterior, inputs.outsideLabel);
  const auto            tell = [&] {
    state.outsideLabel = labels.GetOutside();
    state.report = result.report;
    TranslateReport(outputGeometry, labels, state.report);
    SetSurfaceAndParticles(result, outputGeometry, labels, outputs);
  };
  try
  {
    for (int attempt = 1;; ++attempt)
    {
      const SizingField sizing(indicators.GetGrid(), sizes.data());
      BuildMesh(indicators, sizing, ParametersOf(inputs), monitor, result);
      const std::size_t count = result.tetrahedra.tetrahedra.size();
      if (attempt == WantedNumber::Attempts || !wanted.IsMissed(count))
      {
        break;
      }
      scale(wanted.NextFactor(count));
      result = MeshingResult();
      result.report.estimate = state.report.estimate;
    }
    monitor.BeginStage("output");
  }
  catch (...)
  {
    // for those who want to see where it failed
    tell();
    throw;
  }
  const std::size_t count = result.tetrahedra.tetrahedra.size();
  if (wanted.IsExceeded(count))
  {
    result.report.warnings.push_back(std::to_string(wanted.number) + " tetrahedra were asked for. The mesh has " +
                                     std::to_string(count) +
                                     ": with fewer, tetrahedra would be flatter, or labels be connected otherwise. "
                                     "Fewer labels or larger voxels would help.");
  }
  tell();
  if (!inputs.options.surfaceOnly)
  {
    outputs.setTetrahedra(TakeTetrahedra(result, outputGeometry, inputs.indicators.labels));
  }
  monitor.Report(1.0);
}

void
MeshIndicators(itk::ProcessObject *          filter,
               const MeshingInputs &         inputs,
               const std::function<void()> & releaseInputs,
               const MeshingOutputs &        outputs,
               MeshingState &                state)
{
  state.report = MeshingReport();
  // the shares are those of a head of 7 million voxels
  RunStages(filter,
            state.log,
            { { "preparation", 0.01 },
              { "seeding of particles", 0.02 },
              { "relaxation of 1-cells", 0.01 },
              { "relaxation of 2-cells", 0.13 },
              { "surface", 0.22 },
              { "topology", 0.02 },
              { "seeding of the interior", 0.02 },
              { "relaxation of the interior", 0.09 },
              { "constrained tetrahedralization", 0.08 },
              { "optimization", 0.33 },
              { "coarsening", 0.0 },
              { "fit of the interfaces", 0.06 },
              { "output", 0.01 } },
            [&](FilterMonitor & monitor) { MeshIndicators(inputs, releaseInputs, outputs, state, monitor); });
}
} // namespace mmm
