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
#ifndef mmmParticleParameters_h
#define mmmParticleParameters_h

namespace mmm
{
/** \file
 * What particles go by. Lengths are in units of the size h that is asked for, unless it says voxels: those are units of
 * the smallest voxel spacing. Where no source is named, a value was chosen by trial. */

/** Numbers of SeedParticles(). */
struct SeedingParameters
{
  /** Particles keep this distance when they are thinned, which leaves about as many as a hexagonal packing of h has. */
  static constexpr double ThinningDistance = 0.68;
  /** A seed's projection stays this near to its cube's centre, in units of the largest voxel spacing: a cube's corners
   * are 0.87 from there. */
  static constexpr double Reach = 1.2;
  /** By how much another material may be larger at a seed, in voxels. */
  static constexpr double MaximalityTolerance = 1e-3;
};

/** Numbers of SeedInteriorParticles(). */
struct InteriorSeedingParameters
{
  /** The distance that particles keep, between two of the interior, and to one on an interface. Edges are h long on
   * average then: measured, docs/sizing.md. */
  static constexpr double ThinningDistance = 0.68;
  static constexpr double InterfaceDistance = 0.62;
  /** About so many candidates per cube of edge h are there to choose from; */
  static constexpr double CandidatesPerCube = 10.0;
  /** but no more than this in a voxel: h below a quarter of a voxel is not followed in the interior. */
  static constexpr double MostCandidates = 512.0;
};

/** Numbers of MergeCloseParticles(). */
struct MergingParameters
{
  /** Particles of one sheet, or of a sheet and its border, are joined below this distance; */
  static constexpr double SheetDistance = 0.35;
  /** junctions below this, and points of different sheets below this, both in voxels. */
  static constexpr double JunctionDistance = 0.3;
  static constexpr double LayerDistance = 0.15;
};

/** What RelaxParticles() goes by. Arrays are by the dimension of the cells. */
struct RelaxationParameters
{
  /** Sweeps end when the particles move by less than this on average, above 0, ... */
  double tolerance{ 0.01 };
  /** ... or after so many, 0 or more. */
  int maximumSweeps{ 40 };

  /** The energy vanishes at this distance: on a surface the second ring of a hexagonal packing, in space beyond the
   * second shell of a close packing. By analysis, but for the last. */
  static constexpr double Supports[] = { 1.0, 1.7320508, 1.7320508, 1.5 };
  /** The energy of a particle with two, six or twelve neighbours at distance h. By analysis. */
  static constexpr double IdealEnergies[] = { 0.0, 0.24, 0.72, 0.64 };
  /** The part of a Newton step that particles take at most, and factors on it where one turns back, and where not. */
  static constexpr float Damping = 0.7f;
  static constexpr float Shorter = 0.3f;
  static constexpr float Longer = 1.1f;
  /** Of a sweep. */
  static constexpr double LongestRelaxationMove = 0.25;
  /** What is added to the diagonal of the second derivatives, per trace, so that they can be inverted. */
  static constexpr double Regularization = 0.05;
  /** Steps beyond this, in voxels, come from forces without measure and are not taken. */
  static constexpr double LargestStep = 1e3;
  /** Of the support: the energy grows beyond all bounds where particles meet. */
  static constexpr double LeastDistance = 0.05;
  /** A moved particle's cell is this near. */
  static constexpr double Reach = 0.5;
  /** Neighbours are listed a little beyond the support of a particle's own h: there is room to move, and for neighbours
   * with a larger h. They are listed again after so many sweeps. */
  static constexpr double ListingMargin = 1.2;
  static constexpr int    SweepsPerListing = 4;
  /** Sweeps after which the population is adapted, ascending. */
  static constexpr int PopulationSweeps[] = { 3, 6, 9 };
  /** What counts as crowded and as lonely, against the ideal energy. */
  static constexpr double CrowdedEnergy = 1.6;
  static constexpr double LonelyEnergy = 0.65;
  /** The place for another particle is this far from all that are there. */
  static constexpr double LeastClearance = 0.7;
  /** Directions in which a surface is searched for it. */
  static constexpr int SearchDirections = 12;
};
} // namespace mmm

#endif
