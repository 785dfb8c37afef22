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
#ifndef mmmSurfaceParameters_h
#define mmmSurfaceParameters_h

#include <cstddef>

namespace mmm
{
/** \file
 * What the stage of the surface goes by. Lengths are in units of the smallest voxel spacing, unless it says h: those
 * are units of the size that is asked for. Where no source is named, a value was chosen by trial. */

/** Numbers of BuildSurface(). */
struct SurfaceRoundParameters
{
  /** Triangulations that are followed by sweeps of the particles on them. The last one is compared with the indicators.
   */
  static constexpr int Rounds = 5;
  static constexpr int SweepsPerRound = 2;
  /** Where topology need not be kept, places that differ and have more samples stay as they are: the sizes do not
   * resolve them. */
  static constexpr std::size_t LargestPlace = 80;
  /** Triangulations after that which add particles where the topology is to be kept, at most. */
  static constexpr int MendingRounds = 6;
  /** After this number of them, particles are also added further around, by one sample more each time, ... */
  static constexpr int MendingRoundsInPlace = 2;
  /** ... but not around more samples than this. */
  static constexpr std::size_t MostSamplesToGrow = 2000;
  /** There are no more of these rounds where places that differ have more than this share of the samples that are kept:
   * that is noise, which particles do not follow. Nor are there more of the next ones where that share of the triangles
   * is inconsistent. */
  static constexpr double ShareOfNoise = 0.05;
  /** Triangulations after all these that add particles where triangles are inconsistent, at most, the share of the
   * triangles that may stay so, the distance of the particles, and how many samples around. Measured: docs/ablation.md.
   */
  static constexpr int    ConsistencyRounds = 2;
  static constexpr double ConsistentEnough = 1e-4;
  static constexpr double ConsistencySize = 0.7;
  static constexpr int    ConsistencyReach = 1;
  /** In each of these rounds the distance of particles is smaller by this factor: an eighth of a voxel in the last one.
   */
  static constexpr double MendingShrinkage = 0.75;
  /** What a round missed is sampled at this distance, */
  static constexpr double RecoverySize = 0.5;
  /** which grows around at this rate and has met the usual sizes at this distance. */
  static constexpr double RecoveryGrowth = 0.5;
  static constexpr double RecoveryReach = 6.0;
  /** Corners of small labels are not worth it where sizes are this large, which is by someone's wish. */
  static constexpr float CoarseSize = 1.75f;
};

/** Numbers of FindMissingSamples() and AddMissingSamples(). */
struct MissingSampleParameters
{
  /** Triangulations after the last round that add samples, at most; mostly two or three do. */
  static constexpr int Rounds = 6;
  /** Steps along an edge: nothing that is sampled is thinner. */
  static constexpr double LongestStep = 0.5;
  /** Halvings of a step, to where the material changes. */
  static constexpr int Halvings = 6;
  /** How far such a place may be from the cell. */
  static constexpr double Reach = 0.5;
  /** A sample and a particle that are closer are the same, as are a particle and a cell. */
  static constexpr double SameDistance = 0.15;
  /** A particle of a surface that is closer to a sample of its rim is not needed any more, in h. */
  static constexpr double CrowdedDistance = 0.35;
};

/** Numbers of FindLostNodes(). */
struct LostNodeParameters
{
  /** Labels of no more voxels are small: a few lost ones count, and it costs little to sample all more finely. */
  static constexpr std::size_t SmallLabel = 5000;
  /** The share of its voxels that a small label may lose; the smallest ones may lose none. */
  static constexpr double      AcceptedLoss = 0.06;
  static constexpr std::size_t SmallestLabels = 500;
};

/** Numbers of LabelTetrahedra(). */
struct LabellingParameters
{
  /** A tetrahedron is flat if it is all within this distance of an interface, or within this part of its longest edge
   * where that is shorter than 1: small ones fill passages that are this narrow. */
  static constexpr double FlatDistance = 0.25;
  /** Indicators count for no more than this: a thin part of a tetrahedron is to be heard beside a deep one. */
  static constexpr double LargestSupport = 1.0;
};

/** Numbers of RepairLinks(), TurnFlatTetrahedra() and UpdateCells(). */
struct MendingParameters
{
  /** Passes over what is left; most is done in the first. */
  static constexpr int Passes = 5;
  /** Triangles below this radius ratio are poor. */
  static constexpr double PoorTriangle = 0.8;
  /** By how much the indicators may prefer the material that a tetrahedron had: an interface is where two of them are
   * the same, and each falls off by one per unit of distance. So it may move by a quarter of a voxel. */
  static constexpr double Tolerance = 2.0 * 0.25;
  /** How far the cell of the materials that meet at a particle may be from it. */
  static constexpr double CellReach = 0.5;
};

/** Numbers of RelaxOnSurface() and SurfaceConnectivity. */
struct SurfaceRelaxationParameters
{
  /** Edges beyond these, in h, get a particle or lose one. */
  static constexpr double LongEdge = 1.45;
  static constexpr double ShortEdge = 0.65;
  /** Of a sweep, in h. */
  static constexpr double LongestCentroidMove = 0.3;
  /** Where a moved or new particle looks for its cell, in h. */
  static constexpr double Reach = 0.5;
  /** A flip for the sake of valences may leave triangles of this radius ratio, which relaxation improves. */
  static constexpr double LeastRadiusRatio = 0.45;
  /** No fan is larger, unless a sheet touches itself. */
  static constexpr int LargestFan = 100;
};

/** Numbers of MeasureResiduals(). */
struct ResidualParameters
{
  /** How far to look for a particle's cell; where it is not found, the particle counts as so far away. */
  static constexpr double Reach = 1.0;
};
} // namespace mmm

#endif
