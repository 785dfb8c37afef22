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
#ifndef mmmIndicatorParameters_h
#define mmmIndicatorParameters_h

#include <cstddef>

namespace mmm
{
/** \file
 * The numbers that the stages of this room go by. Lengths are in units of the smallest voxel spacing. Where no source
 * is named, a value was chosen by trial. What users can set is not here: it is a parameter of the functions. */

/** Indicators are known up to this distance from their zero level. At least 2, which interpolation reaches. */
constexpr double IndicatorBandWidth = 3.0;

/** Numbers of ComputeSmoothIndicator() and of its flows. */
struct SmoothingParameters
{
  /** Every voxel centre stays at least this far on its own side, so that no surface passes through it. A radius of more
   * than half a voxel lets it yield: by how much the radius is larger. In (0, 0.5), as are the next two. */
  static constexpr float CentreMargin = 0.1f;
  /** The same in parts of one voxel's thickness: what is thinner cannot be meshed everywhere. */
  static constexpr float ThinCentreMargin = 0.2f;
  /** Where a part ends in a single voxel, or is one: triangles cut such tips off by as much as half a voxel. */
  static constexpr float TipCentreMargin = 0.35f;
  /** Nodes beyond the image border on which labels are continued, so that the flow meets the border at right angles. */
  static constexpr int BorderContinuation = 3;
  /** Opening and closing are known to this accuracy: a smooth boundary is not pressed against its own opening. */
  static constexpr float MortarSlack = 0.05f;
  /** The boundary moves less than a voxel: nodes further away need not be solved for. */
  static constexpr double FlowBandWidth = 2.0;
  /** The flows end when the boundary moves less than this per unit of time, root mean square, */
  static constexpr double AntiAliasTolerance = 0.01;
  static constexpr double TighteningTolerance = 0.005;
  /** or after so many steps. No flow that was seen needs as many. */
  static constexpr int AntiAliasSteps = 200;
  static constexpr int TighteningSteps = 100;
  /** Times that the speed is averaged with its neighbours', and steps of the flow that one average serves. */
  static constexpr int AveragingRounds = 8;
  static constexpr int StepsPerMean = 6;
  /** The part of a step's movement that is taken over into the next one, in [0, 1). */
  static constexpr float Momentum = 0.5f;
  /** Nodes this close to the zero level tell whether it rests. */
  static constexpr float RestDistance = 0.75f;
};

/** Numbers of FunctionIndicators. */
struct FunctionParameters
{
  /** Probabilities that were interpolated go beyond [0, 1] by less than this. */
  static constexpr float Overshoot = 0.25f;
  /** Nodes beyond the image border on which the border's values are continued. */
  static constexpr int BorderContinuation = 2;
  /** The least lead, in units of the functions, so that no voxel's centre is on an interface. */
  static constexpr float LeastLead = 1e-6f;
  /** The least distance of a voxel's centre to an interface, per voxel. */
  static constexpr double ShortestWay = 1e-3;
};

/** Numbers of CorrectVolumes(). */
struct VolumeParameters
{
  /** Lacks below this share of a part's volume are none: digitization itself is no more accurate. */
  static constexpr double Tolerance = 0.005;
  /** Volumes grow faster than offsets: one round leaves some ten percent of what small parts lack. */
  static constexpr int Rounds = 3;
  /** Of Gauss and Seidel's method. */
  static constexpr int Sweeps = 50;
  /** Of a round. */
  static constexpr double LongestOffset = 0.4;
  /** Values this far from the zero level get all of the offset, those at the end of the band none. */
  static constexpr float WholeDepth = 1.5f;
  /** The offset of a part is continued this many nodes beyond it. */
  static constexpr int Continuation = 4;
};

/** Numbers of WidenPassages(). */
struct PassageParameters
{
  /** Samples a voxel and axis, 2 or 4. */
  static constexpr int Refinement = 2;
  /** How much the largest indicator exceeds the second where a passage is wide enough; an interface lies at half of
   * that, so that the passage is as wide as this. */
  static constexpr float Lead = 0.5f;
  /** By how much a node's material leads at least; no more than Lead. */
  static constexpr float NodeLead = 0.3f;
  /** What has been widened may leave something else narrow. More passes where contacts are kept. */
  static constexpr int Passes = 3;
  static constexpr int ContactPasses = 6;
  /** A node this close to a place, in voxels along an axis, is the only one of the axis. */
  static constexpr double NearNode = 0.1;
  /** Catmull and Rom's interpolation halfway between two nodes gives so much of what both get. */
  static constexpr double Halfway = 9.0 / 8.0;
  /** In voxels along each axis: a critical point that is nearer to another sample is found from there. */
  static constexpr double CriticalPointReach = 0.7 / Refinement;
};

/** Numbers of FindCriticalPoint(). */
struct CriticalPointParameters
{
  /** Away from others, the difference of two signed distances has a gradient of 2: no search starts above this, */
  static constexpr double SteepStart = 1.6;
  /** ends below this, */
  static constexpr double Converged = 0.02;
  /** and has found something below this. */
  static constexpr double Tolerated = 0.1;
  /** A curvature below this is none. In voxels along each axis, as the next two. */
  static constexpr double LeastBend = 0.1;
  static constexpr double LongestNewtonStep = 0.25;
  /** Of central differences. */
  static constexpr double DifferenceStep = 0.05;
  static constexpr int    NewtonSteps = 6;
};

/** Numbers of IndicatorSet's projection on cells. */
struct ProjectionParameters
{
  /** By how much another material may be larger where a cell still counts as maximal. */
  static constexpr double MaximalityTolerance = 1e-2;
  /** A projection has converged when its step is shorter than this, */
  static constexpr double Accuracy = 1e-4;
  /** and has failed after so many steps. */
  static constexpr int GaussNewtonSteps = 12;
  /** Longer steps are cut: the indicators are not linear any further. */
  static constexpr double LongestGaussNewtonStep = 0.7;
  /** No single step takes a point onto a cell that is further away. */
  static constexpr double LongestApproach = 0.5;
  /** Squared gradients below this are none. */
  static constexpr double LeastSquaredGradient = 1e-6;
  /** What the equations of curves and points are damped by, per trace, so that parallel gradients do no harm. */
  static constexpr double Regularization = 1e-6;
  /** A step whose square is larger comes from equations without a solution. */
  static constexpr double LargestSquaredStep = 1e6;
};
} // namespace mmm

#endif
