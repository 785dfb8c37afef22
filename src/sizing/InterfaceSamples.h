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
#ifndef mmmInterfaceSamples_h
#define mmmInterfaceSamples_h

#include "indicators/IndicatorSet.h"

#include <vector>

namespace mmm
{
/** A point where an interface crosses an edge of the grid (or, for a cut, the image border). */
struct InterfaceSample
{
  Vector position;
  /** The materials on both sides; `second` may be a plane. The normal points from `first` to `second`. */
  Material first;
  Material second;
  Vector   normal;

  /** The material that is not this one. */
  Material
  Opposite(Material own) const
  {
    return first == own ? second : first;
  }
};

/** All crossings of interfaces with grid edges, and a sample for each voxel face in which the image border cuts a
 * material other than `exterior`. In the order of the grid nodes. */
std::vector<InterfaceSample>
CollectInterfaceSamples(const IndicatorSet & indicators, int exterior);
} // namespace mmm

#endif
