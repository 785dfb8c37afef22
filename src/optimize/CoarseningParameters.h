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
#ifndef mmmCoarseningParameters_h
#define mmmCoarseningParameters_h

namespace mmm
{
/** \brief The numbers of the coarsening to a number of tetrahedra. */
struct CoarseningParameters
{
  /** Edges shorter than this, in units of the mean length that so many tetrahedra have, are pulled together. Analysis:
   * with four fifths, those that are split and those that are not stay apart (Botsch and Kobbelt 2004). */
  static constexpr double ShortEdge = 0.8;
  /** Where a round takes less than this share of the tetrahedra, longer ones are tried, by this factor each time, up to
   * this many times that length; then it is over. */
  static constexpr double LittleGain = 0.03;
  static constexpr double Growth = 1.25;
  static constexpr double LongestEdge = 2.0;
  /** Edges that touch are pulled together one after the other, in so many passes, before points are smoothed. */
  static constexpr int Passes = 3;
  /** New tetrahedra have no smaller dihedral angle than this, in degrees, new triangles no smaller radius ratio. */
  static constexpr double LeastAngle = 15.0;
  static constexpr double LeastTriangle = 0.5;
  /** The interfaces' tolerance grows with the length of edges up to this factor. */
  static constexpr double LargestTolerance = 1.5;
  /** Rounds of pulling together and smoothing, at most. */
  static constexpr int Rounds = 30;
};
} // namespace mmm

#endif
