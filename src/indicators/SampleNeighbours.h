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
#ifndef mmmSampleNeighbours_h
#define mmmSampleNeighbours_h

#include "base/Grid.h"

#include <cstdint>

namespace mmm
{
/** \brief The samples around one of a lattice, and sets of them.
 *
 * The samples are the vertices of a Freudenthal (Kuhn) subdivision, in which two are neighbours if the indices of one
 * exceed those of the other by 0 or 1 each. It treats all materials alike: what does not connect one connects the
 * others. A sample has 14 neighbours, the vertices of a triangulated sphere; a set of them, one bit each, stands for
 * the part of the sphere that it spans. */
class SampleNeighbours
{
public:
  static constexpr int Count = 14;

  SampleNeighbours();

  /** The n-th neighbour. */
  static Index
  Of(const Index & sample, int n)
  {
    return { { sample[0] + Steps[n][0], sample[1] + Steps[n][1], sample[2] + Steps[n][2] } };
  }

  /** Whether it is one piece without a hole, and not all of the sphere. The sample in the middle can then enter or
   * leave the set's material without a change of topology. */
  bool
  IsDisk(unsigned set) const
  {
    return m_IsDisk[set];
  }

private:
  static const std::array<Index, Count> Steps;

  int
  CountParts(unsigned set) const;

  std::array<unsigned, Count> m_Adjacent{};
  std::vector<bool>           m_IsDisk;
};
} // namespace mmm

#endif
