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
#ifndef mmmLabelNames_h
#define mmmLabelNames_h

#include "MultiMaterialMeshingLabels.h"

#include <set>
#include <string>
#include <utility>

namespace mmm
{
/** \brief The entries of those of the labels that have a name, with names that files can have, each unlike the others.
 *
 * A name that several of the labels have, or that a file would take for another thing, such as "label 3", is followed
 * by the label: "cortex (3)". Control characters become blanks, quotation marks become '. */
LabelTable
NamesForFiles(const LabelTable & table, const std::set<int> & labels);

/** Of the triangles between two labels: "gray matter|label 7"; empty if neither has a name. */
std::string
NameOfPair(const LabelTable & names, const std::pair<int, int> & labels);
} // namespace mmm

#endif
