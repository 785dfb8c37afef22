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
#ifndef FileNames_h
#define FileNames_h

#include "options/OptionTable.h"

#include <string>
#include <utility>
#include <vector>

namespace cli
{
/** The extensions, with their points, of what an option of this kind writes. */
const std::vector<std::string> &
ExtensionsOf(Kind kind);

/** The one of these that a file name ends with; else an empty text. */
std::string
FindExtension(Kind kind, const std::string & fileName);

/** ".vtu, .msh or .mesh" */
std::string
DescribeExtensions(Kind kind);

/** What --surface-per-label writes for a label: before the extension, if there is one of surfaces, else with .stl. If
 * the label has a name, it follows: "tissue-3-gray_matter.stl". */
std::string
SurfaceName(const std::string & prefix, int label, const std::string & name);

/** What --save-indicators writes for a label. */
std::string
IndicatorName(const std::string & prefix, int label);

/** What is named for tetrahedra and surfaces, the prefix of --surface-per-label included. */
std::vector<std::string>
MeshFiles(const Settings & settings);

/** Throws UsageError where a file is named in a format that there is not, or for two purposes, and itk::ExceptionObject
 * where it cannot be written: hours of work shall not be lost to a misspelled folder. */
void
CheckFileFormats(const Settings & settings);
void
CheckOutputs(const Settings & settings);
} // namespace cli

#endif
