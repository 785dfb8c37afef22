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
#ifndef Summary_h
#define Summary_h

#include "run/Outcome.h"

#include <iosfwd>

namespace cli
{
/** The image's voxels with this label, after islands were merged. */
std::size_t
CountVoxels(const Outcome & outcome, int label);

/** Prints a few lines on what was made. */
void
PrintSummary(std::ostream & os, const Outcome & outcome);

/** Labels that the image has and the mesh lacks. */
void
WarnOfVanishedLabels(const Settings & settings, const MeshFilter & filter);

/** Labels of which islands were a large part. */
void
WarnOfMergedIslands(const MeshFilter & filter);

/** Tetrahedra above the largest volume that was asked for. */
void
WarnOfLargeTetrahedra(const Outcome & outcome);

/** Files whose triangles stay flat though second order was asked for. */
void
WarnOfFlatTriangles(const Settings & settings);
} // namespace cli

#endif
