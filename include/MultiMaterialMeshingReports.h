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
#ifndef MultiMaterialMeshingReports_h
#define MultiMaterialMeshingReports_h

#include "MultiMaterialMeshingExport.h"
#include "MultiMaterialMeshingQuality.h"

#include "itkPoint.h"

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace mmm
{
/** Numbers of voxels by label. */
using LabelCounts = std::map<int, std::size_t>;

/** What a stage of the work took. */
struct StageRecord
{
  std::string name;
  double      seconds{ 0.0 };
  /** The largest memory that the process had occupied by the end of the stage, since it started, in MB (2^20 bytes);
   * 0 where the system does not tell. */
  double peakMemory{ 0.0 };
};

/** Where the work of a filter is, for those who observe it. */
struct StageLog
{
  /** The stage that is running or ran last, and the fraction of it that is done, in [0, 1]. */
  std::string current;
  float       progress{ 0.0f };
  /** The stages that ended, in their order. */
  std::vector<StageRecord> records;
};

/** What became of the voxels of a label when islands were merged. */
struct IslandRecord
{
  /** Components that went to other labels, and how many voxels they had. */
  std::size_t components{ 0 };
  std::size_t voxels{ 0 };
  /** Where those voxels went: voxels by label. */
  std::map<int, std::size_t> destinations;
  /** Voxels of the label in the input and in the output. */
  std::size_t voxelsBefore{ 0 };
  std::size_t voxelsAfter{ 0 };
};

/** About how large a mesh and the work on it will be. All are 0 where there is no estimate. */
struct MeshEstimate
{
  double triangles{ 0.0 };
  double points{ 0.0 };
  double tetrahedra{ 0.0 };
  /** The largest physical memory that the process will have occupied, in GB (2^30 bytes). */
  double memory{ 0.0 };
};

/** A number in words, rounded: "3.5 million", "240 thousand", "870"; below 5 it is "0". */
MultiMaterialMeshing_EXPORT std::string
                            DescribeCount(double count);

/** For instance "690 thousand points, 3.5 million tetrahedra and 2.9 GB". */
MultiMaterialMeshing_EXPORT std::string
                            Describe(const MeshEstimate & estimate);

/** How the particles on the cells of one dimension came to rest. */
struct RelaxationReport
{
  int sweeps{ 0 };
  /** In the last sweep, in units of the edge length that is asked for; below the tolerance if they converged. */
  double      meanMove{ 0.0 };
  bool        converged{ false };
  std::size_t added{ 0 };
  std::size_t removed{ 0 };
};

/** Somewhere in the mesh, in physical space, and the labels that meet there. */
struct MeshingPlace
{
  itk::Point<double, 3> position;
  std::vector<int>      labels;
};

/** How the materials meet around the points of interfaces: where a material around a point or an edge is not connected
 * through faces, the link has a defect. */
struct LinkReport
{
  /** Defects that labelling left. */
  std::size_t edges{ 0 };
  std::size_t points{ 0 };
  /** Tetrahedra that were given to another material to mend them. */
  std::size_t relabelled{ 0 };
  /** What could not be mended. */
  std::vector<MeshingPlace> left;
};

/** A place where the topology of the mesh is not that of the indicators. */
struct TopologyPlace
{
  MeshingPlace place;
  /** For each of the place's labels, by how much the Euler characteristic is larger in the mesh: a component or a
   * cavity more is 1, a tunnel more -1. */
  std::vector<std::ptrdiff_t> changes;
};

/** The Betti numbers of a label. */
struct LabelTopology
{
  int          label;
  BettiNumbers mesh;
  /** Of the region where the label's indicator is the largest. */
  BettiNumbers partition;
  /** By how much the Euler characteristic is larger in the mesh, less what the places found account for. */
  std::ptrdiff_t unexplained;
};

/** How the topology of the mesh is that of the indicators, or not. */
struct TopologyReport
{
  std::vector<LabelTopology> labels;
  /** Where it is not. */
  std::vector<TopologyPlace> differences;
  /** Where differences side by side cancel out: Betti numbers may differ, or not. */
  std::vector<MeshingPlace> cancelling;
};

/** What the optimizer did. */
struct OptimizationReport
{
  std::size_t flips{ 0 };
  std::size_t interfaceFlips{ 0 };
  std::size_t relabelled{ 0 };
  std::size_t collapses{ 0 };
  std::size_t moves{ 0 };
  int         rounds{ 0 };
};

/** \brief The edges on interfaces of a second-order mesh; all but the Jacobian are 0 or empty for one of first order.
 */
struct CurvingReport
{
  /** Edges between labels, but those that are straight on the faces of the image's box in any case. */
  std::size_t edges{ 0 };
  /** Those of them that are straight as their interface is not close to their middle. */
  std::size_t withoutPlace{ 0 };
  /** Those that are straight as they would turn a tetrahedron inside out, or nearly so. */
  std::size_t inverting{ 0 };
  /** The least lower bound of the determinant of a tetrahedron's Jacobian, in units of that with straight edges. */
  double smallestJacobian{ 1.0 };
  /** Volumes of the curved tetrahedra by label, in mm^3. */
  std::map<int, double> volumes;
};

/** How well the points of a surface follow the edge length that is asked for. */
struct SamplingReport
{
  /** The smallest and the largest spacing that count as near to what was asked for. */
  static constexpr double LeastNear = 0.6;
  static constexpr double MostNear = 1.6;

  /** Lengths of the surface's edges in units of what is asked for at their middle, 0 without edges. */
  double medianSpacing{ 0.0 };
  double percentile1Spacing{ 0.0 };
  double percentile99Spacing{ 0.0 };
  /** The share of edges whose spacing is near 1. */
  double nearShare{ 0.0 };
};

/** Distances of particles to their cells, in units of the smallest voxel spacing; all are 0 without particles. */
struct ResidualReport
{
  /** A particle that is further away than this has left its cell. */
  static constexpr double Largest = 0.01;

  double maximum{ 0.0 };
  double percentile99{ 0.0 };
  /** The share of the particles that have left their cell, or whose cell is not found within a voxel. */
  double leftShare{ 0.0 };
};

/** Of the particles on 1- and 2-cells; [0] is unused. */
using ResidualReports = std::array<ResidualReport, 3>;

/** What became of the particles, and of the surface. */
struct MeshingReport
{
  /** What was expected before the work began. */
  MeshEstimate estimate;
  /** On cells of dimension 0 to 3: where four labels meet, three, two, and within one. */
  std::array<std::size_t, 4>      particles{ { 0, 0, 0, 0 } };
  std::array<RelaxationReport, 4> relaxation;
  LinkReport                      links;
  /** Interface triangles of which a corner does not lie on a cell with both of the triangle's labels: their centers. */
  std::vector<MeshingPlace> inconsistentTriangles;
  /** Only if it was asked for. */
  TopologyReport topology;
  /** Particles that no interface triangle uses; they are dropped. */
  std::size_t unusedParticles{ 0 };
  /** Particles of the interior that were left out as they were in the way of interfaces. */
  std::size_t pointsLeftOut{ 0 };
  /** Points that TetGen added to the interior to recover the interfaces, where that was necessary. */
  std::size_t steinerPoints{ 0 };
  /** What became worse than was asked for, in sentences; the filters give them out as warnings. */
  std::vector<std::string> warnings;
  OptimizationReport       optimization;
  CurvingReport            curving;
  /** Of the final surface, against the sizes that were asked for. */
  SamplingReport sampling;
  /** Of the particles between which the surface was found, against the cells that they were put on. */
  ResidualReports residualsOfParticles;
  /** Where the optimizer left those that the surface uses, against the cells of the labels that meet at them in the
   * mesh, before the fit of the interfaces. Where there was nothing to optimize, the same particles as they were. */
  ResidualReports residualsAfterOptimization;
};
} // namespace mmm

#endif
