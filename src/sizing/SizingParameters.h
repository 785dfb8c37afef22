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
#ifndef mmmSizingParameters_h
#define mmmSizingParameters_h

namespace mmm
{
/** \file
 * What sizes go by. Lengths are in units of the smallest voxel spacing. Where no source is named, a value was chosen by
 * trial. */

/** \brief What users set of ComputeSizing(). */
struct SizingParameters
{
  /** Edge length per local feature size, above 0. The paper's value; its other one is 1. */
  double epsilon{ 2.5 };
  /** The largest distance between a chord and the interface that it stands for, above 0. */
  double chordTolerance{ 0.1 };
  /** The largest gradient of the sizing field, above 0. */
  double gradientLimit{ 0.5 };
  /** Bounds of all sizes. A maximum that is not a number stands for DefaultMaximumSize(). */
  double minimumSize{ 1.0 };
  double maximumSize{ 1e30 };
  /** What no size exceeds, whatever else is asked for. */
  double sizeLimit{ 1e30 };
};

/** \brief Numbers of DefaultMaximumSize(). */
struct DefaultMaximumParameters
{
  /** Edges across what is meshed, 6 mm in an adult's head: with fewer, potentials deep inside are off by more than the
   * interfaces are to blame for. */
  static constexpr double EdgesAcross = 25.0;
  /** Thick parts do not get nearly as many elements as voxels. */
  static constexpr double LeastVoxels = 3.0;
};

/** \brief Numbers of ComputeMedialAxis(). */
struct MedialAxisParameters
{
  /** Feet on two interfaces that meet this near in a junction do not count: each wedge's axis runs into its edge. */
  static constexpr double JunctionReach = 2.5;
  /** Three materials meet where their cell indicator is below this. */
  static constexpr double JunctionTolerance = 0.01;
  /** Junctions are listed for bricks of this edge length. */
  static constexpr double JunctionBrick = 4.0;
  /** Layers below this thickness are measured along the normals: the grid's nodes see too little of them, */
  static constexpr double ThinLayer = 3.0;
  /** in steps of this length; the end is then found by so many halvings. */
  static constexpr double ProbeStep = 0.3;
  static constexpr int    Halvings = 4;
  /** Nodes this far inside are looked at, */
  static constexpr double LeastDepth = 1.0;
  /** where feet lie so far apart (as in the lambda-medial axis of Chazal and Lieutier, 2005) ... */
  static constexpr double LeastSeparation = 1.5;
  /** ... and are seen under a wide angle (Foskey, Lin and Manocha, 2003), by its cosine: 90 degrees, ... */
  static constexpr double LargestCosine = 0.0;
  /** ... or 120 for neighbours across a diagonal, which lie further apart. Around an isolated axis point, such as a
   * ball's centre, only they see their feet on opposite sides. */
  static constexpr double LargestDiagonalCosine = -0.5;
  /** The nearest sample is at most this far from the foot. */
  static constexpr double LongestRefinement = 1.0;
  /** Normals are known less well than feet: they move an axis point by no more than this, */
  static constexpr double LongestCorrection = 0.75;
  /** and not where a foot is seen from the other at less than this cosine to the normal. */
  static constexpr double LeastNormalCosine = 0.5;
};
} // namespace mmm

#endif
