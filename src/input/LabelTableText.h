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
#ifndef mmmLabelTableText_h
#define mmmLabelTableText_h

#include "MultiMaterialMeshingLabels.h"

#include <string>

namespace mmm
{
/** \brief The names and colors of labels that a text lists, in any of the forms that there are.
 *
 * - JSON, which begins with a brace: {"3": "gray matter"}, {"3": {"name": ..., "color": ...}} or {"gray matter": 3}, at
 *   the top, or as member "LabelMap" (BIDS) or "labels" (nnU-Net). Colors are "#rrggbb", or three numbers, from 0 to 1,
 *   or to 255 if one is above 1.
 * - columns parted by tabs, with the names "index", "name" and, if there are some, "color" (#rrggbb) on top: BIDS.
 * - a label per line: `3 -> 205 62 78 1 1 1 "gray matter"` (ITK-SNAP, without the arrow), or `3 gray-matter 205 62 78
 * 0` (FreeSurfer, 3D Slicer's .ctbl), with or without the color. Lines with # are comments. In .ctbl files, a blank in
 * a name is stored as underscore.
 *
 * Throws itk::ExceptionObject with file, line and what is wrong there, or if there is no label. */
LabelTable
ParseLabelTable(const std::string & fileName, const std::string & text);

/** Whether a JSON text has names of labels where BIDS and nnU-Net have them. */
bool
HasLabelMap(const std::string & fileName, const std::string & text);
} // namespace mmm

#endif
