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
#ifndef mmmSizingOptions_h
#define mmmSizingOptions_h

#include "MultiMaterialMeshingOptions.h"
#include "itk/GridGeometry.h"
#include "itkIndicatorImageStages.h"
#include "sizing/SizeRule.h"
#include "sizing/Sizing.h"

#include <string>

namespace mmm
{
/** What is wrong with settings, in a sentence; empty if nothing is. */
std::string
DescribeError(const SizingInputs & sizing);
std::string
DescribeError(const MeshingOptions & options);
/** Of both, or what they contradict each other in. */
std::string
DescribeError(const MeshingOptions & meshing, const SizingInputs & sizing);

/** Rules in the grid's unit. */
SizeRule
ToGridUnit(const SizeRule & rule, const GridGeometry & geometry);
LabelSizeRules
ToGridUnit(const LabelSizeRules & rules, const GridGeometry & geometry);

/** The general options in the grid's unit. Where the smallest size is not given, it is the smallest voxel spacing or
 * the largest size, whichever is smaller. */
SizingParameters
ToGridUnit(const SizingOptions & options, const GridGeometry & geometry);
} // namespace mmm

#endif
