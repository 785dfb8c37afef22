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
#ifndef LabelNames_h
#define LabelNames_h

#include "options/Settings.h"
#include "MultiMaterialMeshingLabels.h"

#include <map>
#include <set>
#include <string>

namespace cli
{
/** \brief What labels are called, and which file says so. */
struct LabelNames
{
  std::string     file;
  mmm::LabelTable table;

  /** "label 3", or "label 3 (gray matter)". */
  std::string
  Describe(int label) const;

  /** Empty if it has none. */
  std::string
  NameOf(int label) const;
};

/** \brief Reads --names, or what is found beside LABELS.
 *
 * The table of --names names the labels that are meshed. A table that was found names those of the image: a label keeps
 * its name where --map and --merge give it another number; one that joins several has a name if they all have the same.
 * Labels that the table lacks have the names of `own`, if there are. `changes`: what the labels of the image have
 * become; empty if they are as they were. Warns of the `meshed` labels that have no name, and of a table that was found
 * and cannot be read. Throws where that of --names cannot. */
LabelNames
ReadLabelNames(const Settings &           settings,
               const std::map<int, int> & changes,
               const std::set<int> &      meshed,
               const mmm::LabelTable &    own);
} // namespace cli

#endif
