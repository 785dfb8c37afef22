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
#ifndef MultiMaterialMeshingLabels_h
#define MultiMaterialMeshingLabels_h

#include <array>
#include <map>
#include <optional>
#include <string>

namespace mmm
{
/** What people call a label, and how they draw it. */
struct LabelEntry
{
  /** Empty if it has none. */
  std::string name;
  /** Red, green and blue in [0, 1]. */
  std::optional<std::array<double, 3>> color;
};

/** Entries by label. Labels without an entry have neither name nor color. */
using LabelTable = std::map<int, LabelEntry>;
} // end namespace mmm

#endif
