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
#ifndef MeshFilter_h
#define MeshFilter_h

#include "console/ProgressDisplay.h"
#include "options/OptionTable.h"
#include "run/Input.h"
#include "itkLabelImageToTetrahedralMeshFilter.h"

namespace cli
{
/** \brief The filter with the settings of the command line. */
MeshFilter::Pointer
MakeMeshFilter(const Settings & settings, const Input & input);

/** \brief Runs the filter, shows its progress and stops it when the user interrupts the program.
 *
 * With `expectOnly` it stops once the mesh's expected size is known. Throws what the filter throws. If it fails after
 * the surface was made, that is written to a file beside OUTPUT, and the exception is an Error that says so. */
void
RunMeshFilter(MeshFilter & filter, const Settings & settings, ProgressDisplay & display);
} // namespace cli

#endif
