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
#include "itk/SizingOptions.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace mmm
{
namespace
{
/** No tetrahedron of the mesh is larger than this part of the cube of the size that was asked for. */
constexpr double LargestVolume = 0.45;

std::string
DescribeRuleErrors(const SizingOptions & options, bool hasRegion)
{
  for (const auto & entry : options.labelSizes)
  {
    const std::string error = DescribeError(entry.second, "label " + std::to_string(entry.first));
    if (!error.empty())
    {
      return error;
    }
  }
  if (hasRegion && !options.region.IsGiven())
  {
    return "The region of interest has no smallest or largest size.";
  }
  if (!hasRegion && options.region.IsGiven())
  {
    return "There are sizes for the region of interest, but no image of that region.";
  }
  return DescribeError(options.region, "the region of interest");
}

/** Conversions between units change sizes by less than this. */
constexpr double Rounding = 1.0 + 1e-5;
} // namespace

double
SizeOfVolume(double volume)
{
  return std::cbrt(volume / LargestVolume);
}

std::string
DescribeError(const MeshingOptions & options)
{
  std::ostringstream words;
  if (!(options.maximumMemory > 0.0))
  {
    words << "The largest memory is " << options.maximumMemory << " GB. It must be positive.";
  }
  else if (options.numberOfTetrahedra > 0 && options.surfaceOnly)
  {
    words << options.numberOfTetrahedra << " tetrahedra are asked for, and the surface only. Leave out one of them.";
  }
  else if (options.elementOrder != 1 && options.elementOrder != 2)
  {
    words << "The element order is " << options.elementOrder << ". It must be 1 or 2.";
  }
  return words.str();
}

std::string
DescribeError(const SizingInputs & sizing)
{
  const SizingOptions & options = sizing.options;
  if (options.sizingImageReplaces && sizing.image.IsNull())
  {
    return "There is no sizing image to stand in place of the computed sizes.";
  }
  const struct
  {
    const char * name;
    double       value;
    const char * unit;
    bool         mayBeAutomatic;
    bool         mayBeInfinite;
  } checks[] = { { "epsilon", options.epsilon, "", false, false },
                 { "chord tolerance", options.chordTolerance, " mm", true, false },
                 { "gradient limit", options.gradientLimit, "", false, false },
                 { "smallest size", options.minimumSize, " mm", true, false },
                 { "largest size", options.maximumSize, " mm", true, true },
                 { "largest volume", options.maximumVolume, " mm^3", false, true } };

  std::ostringstream words;
  for (const auto & check : checks)
  {
    if (check.mayBeAutomatic && std::isnan(check.value))
    {
      continue;
    }
    if (!(check.value > 0.0) || (std::isinf(check.value) && !check.mayBeInfinite))
    {
      words << "The " << check.name << " is " << check.value << check.unit << ". It must be positive"
            << (check.mayBeInfinite ? "." : " and finite.");
      return words.str();
    }
  }
  if (options.minimumSize > options.maximumSize)
  {
    words << "The smallest size, " << options.minimumSize << " mm, is above the largest, " << options.maximumSize
          << " mm.";
    return words.str();
  }
  if (options.minimumSize > Rounding * SizeOfVolume(options.maximumVolume))
  {
    words << "Tetrahedra of at most " << options.maximumVolume << " mm^3 need edges of at most "
          << SizeOfVolume(options.maximumVolume) << " mm, which is below the smallest size, " << options.minimumSize
          << " mm.";
    return words.str();
  }
  return DescribeRuleErrors(options, sizing.region.IsNotNull());
}

std::string
DescribeError(const MeshingOptions & meshing, const SizingInputs & sizing)
{
  const std::string error = DescribeError(meshing);
  if (error.empty() && meshing.numberOfTetrahedra > 0 && std::isfinite(sizing.options.maximumVolume))
  {
    std::ostringstream words;
    words << meshing.numberOfTetrahedra << " tetrahedra are asked for, and none above " << sizing.options.maximumVolume
          << " mm^3. Leave out one of them.";
    return words.str();
  }
  return error.empty() ? DescribeError(sizing) : error;
}

SizeRule
ToGridUnit(const SizeRule & rule, const GridGeometry & geometry)
{
  return { rule.factor, geometry.ToGridUnit(rule.minimumSize), geometry.ToGridUnit(rule.maximumSize) };
}

LabelSizeRules
ToGridUnit(const LabelSizeRules & rules, const GridGeometry & geometry)
{
  LabelSizeRules converted;
  for (const auto & entry : rules)
  {
    converted[entry.first] = ToGridUnit(entry.second, geometry);
  }
  return converted;
}

SizingParameters
ToGridUnit(const SizingOptions & options, const GridGeometry & geometry)
{
  SizingParameters parameters;
  parameters.epsilon = options.epsilon;
  parameters.gradientLimit = options.gradientLimit;
  if (!std::isnan(options.chordTolerance))
  {
    parameters.chordTolerance = geometry.ToGridUnit(options.chordTolerance);
  }
  if (!std::isinf(options.maximumSize))
  {
    parameters.maximumSize = geometry.ToGridUnit(options.maximumSize);
  }
  if (std::isfinite(options.maximumVolume))
  {
    parameters.sizeLimit = geometry.ToGridUnit(SizeOfVolume(options.maximumVolume));
  }
  parameters.minimumSize =
    std::isnan(options.minimumSize) ? std::min(1.0, parameters.maximumSize) : geometry.ToGridUnit(options.minimumSize);
  return parameters;
}
} // namespace mmm
