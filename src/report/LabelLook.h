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
#ifndef mmmLabelLook_h
#define mmmLabelLook_h

#include "MultiMaterialMeshingLabels.h"

#include <set>
#include <string>

namespace mmm
{
/** What a label is drawn in where the table has no color for it: red, green and blue in [0, 1]. It depends on the label
 * alone, so that a label looks the same in all pages, and labels next to each other look different. */
std::array<double, 3>
DefaultColor(int label);

/** "#rrggbb", of the table or the default one. */
std::string
ColorText(int label, const LabelTable & table);

/** "5", or "5 skull" if it has a name. Not escaped. */
std::string
LabelText(int label, const LabelTable & table);

/** The class of elements that have the label's color: "l5". */
std::string
LabelClass(int label);

/** Rules of CSS that give the classes of these labels their colors, as the variable --c. */
std::string
LabelRules(const std::set<int> & labels, const LabelTable & table);

/** HTML: a small square in the label's color, and its number and name. */
std::string
LabelHTML(int label, const LabelTable & table);
} // namespace mmm

#endif
