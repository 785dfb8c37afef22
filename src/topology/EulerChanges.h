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
#ifndef mmmEulerChanges_h
#define mmmEulerChanges_h

#include "image/MaterialImage.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace mmm
{
/** By how much the Euler characteristic of what is of a material differs. */
struct EulerChange
{
  Material       material;
  std::ptrdiff_t change;
};

/** By material, ascending. */
using EulerChanges = std::vector<EulerChange>;

inline void
AddChange(EulerChanges & changes, Material material, std::ptrdiff_t change)
{
  const auto isBelow = [](const EulerChange & entry, Material m) { return entry.material < m; };
  auto       at = std::lower_bound(changes.begin(), changes.end(), material, isBelow);
  if (at == changes.end() || at->material != material)
  {
    at = changes.insert(at, { material, 0 });
  }
  at->change += change;
}

inline EulerChanges
Difference(EulerChanges changes, const EulerChanges & others)
{
  for (const auto & other : others)
  {
    AddChange(changes, other.material, -other.change);
  }
  return changes;
}

inline bool
IsZero(const EulerChanges & changes)
{
  return std::all_of(changes.begin(), changes.end(), [](const EulerChange & entry) { return entry.change == 0; });
}
} // namespace mmm

#endif
