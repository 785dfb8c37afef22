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
#ifndef mmmOptimizationParameters_h
#define mmmOptimizationParameters_h

#include <cstddef>

namespace mmm
{
/** \brief The numbers of the optimizer. Those that differ between its users are members, the others constants.
 *
 * Radius ratios are 0 to 1, angles are dihedral ones in degrees. Large angles count as small ones: quality falls off
 * alike at both ends. "Measured": docs/measurements.md has what it brought. What has no source was chosen, and has not
 * been measured on its own. */
struct OptimizationParameters
{
  /** Tetrahedra with an angle below this are poor: all is done to improve them, on interfaces too. Measured. */
  double poorAngle{ 26.0 };
  /** Below this angle, edges and faces within a material are flipped. Measured at 30; as good at 32. */
  double flipAngle{ 32.0 };
  /** Triangles of interfaces with a radius ratio below this are poor: edges there are flipped and collapsed. Measured.
   */
  double poorTriangle{ 0.87 };
  /** Points of triangles below this radius ratio move for the sake of the worst triangle around them alone. Measured.
   */
  double lowTriangle{ 0.77 };
  /** Below this, they leave their cells for it, within the tolerance, one by one or together. */
  double flatTriangle{ 0.4 };
  /** Where all tetrahedra around a point have larger angles than this, the worst may lose a little when it moves. */
  double angleToKeep{ 30.0 };
  /** Likewise when an edge or a point changes for the sake of triangles, or when a point returns to its cell. */
  double angleToKeepBesideTriangles{ 15.0 };
  /** How much the average radius ratio of tetrahedra counts when points move, from 0; 0 leaves it to triangles. */
  double tetrahedronWeight{ 1.0 };
  /** Rounds of local changes and smoothing, from 0; fewer if nothing is changed any more. */
  int rounds{ 6 };
  /** An interface may leave the zero set by this much, in units of the smallest voxel spacing. Measured. */
  double interfaceTolerance{ 0.25 };

  /** \name What a change of the connectivity has to give. */
  /** The worst quality rises by this at least: more than rounding does. */
  static constexpr double LeastGain = 1e-6;
  /** New triangles of interfaces keep this radius ratio, or that of the worst one that they replace, ... */
  static constexpr double TriangleFloor = 0.4;
  /** ... or this one where that ends a tetrahedron with an angle below the second number. */
  static constexpr double TriangleFloorBesideFlat = 0.15;
  static constexpr double FlatAngle = 10.0;
  /** A point that joins an interface splits a triangle into three of this radius ratio at least. */
  static constexpr double TriangleFloorOfSplit = 0.2;
  /** Exterior tetrahedra with an angle below this are gaps that should not be there. */
  static constexpr double GapAngle = 2.0;
  /** A triangle turns by less than the angle of this cosine, 60 degrees, when an edge collapses: no folds. */
  static constexpr double LeastCosineOfCollapse = 0.5;
  /** Edges with more tetrahedra around them less 2 are left: the link's triangulations grow with the third power. */
  static constexpr int LongestRing = 9;
  /** More tetrahedra than that around a point are hardly ever brought to another one. */
  static constexpr std::size_t LargestStar = 60;

  /** \name How points move. */
  /** How much an interface triangle counts against a tetrahedron. Measured: 5 to 8. */
  static constexpr double TriangleWeight = 8.0;
  /** A triangle of radius ratio r is worth r - s / (r + o): the worse, the more a gain counts. */
  static constexpr double TriangleScarcity = 0.5;
  static constexpr double TriangleOffset = 0.05;
  /** Steps uphill in the average, in units of the distance to the nearest neighbour: the longest, the one that tells
   * the bend, and the shortest that is tried; how many are. */
  static constexpr double LongestStepUphill = 0.2;
  static constexpr double TrialStepUphill = 0.06;
  static constexpr double ShortestStepUphill = 0.01;
  static constexpr int    StepsUphill = 3;
  /** Shares of the way to where a poor tetrahedron wants its corner. */
  static constexpr double SharesOfIdeal[] = { 0.5, 0.2, 0.05 };
  /** The surroundings are searched where the worst quality is still below this share of poor. */
  static constexpr double ShareOfPoorToSearch = 0.5;
  /** Searches around a point, in units of the longest edge there: from this length, halved down to the shortest one. */
  static constexpr double LongestSearch = 0.2;
  static constexpr double ShortestSearch = 0.02;
  static constexpr double ShortestSearchForTriangles = 0.01;
  /** For the sake of tetrahedra, a point leaves its cell, within the tolerance, only where one has an angle below this.
   */
  static constexpr double AngleToLeaveCell = 20.0;
  /** Points that are this near are on their cell, in units of the smallest voxel spacing. */
  static constexpr double OnCell = 1e-3;
  /** Triangles keep this radius ratio when points return to their cells. */
  static constexpr double TriangleFloorOfReturn = 0.5;
  /** What is further from the interfaces, in units of their tolerance, is not near them: such points belong to the
   * image's box, for instance. */
  static constexpr double NearInTolerances = 8.0;
};

/** \brief The numbers of the fit of the interfaces. Lengths are in units of the smallest voxel spacing. */
struct InterfaceFitParameters
{
  /** A tetrahedron may get worse, but not beyond this angle, and a triangle not beyond this radius ratio. */
  struct Floor
  {
    double angle;
    double triangle;
  };

  /** \name Volumes on both sides of the zero set. Measured: what the balance gives. */
  static constexpr int   BalancePasses = 2;
  static constexpr Floor BalanceFloor{ 20.0, 0.75 };
  /** Nothing moves further than this in one pass. */
  static constexpr double LongestBalanceMove = 0.3;
  /** Of a surface's unit normal along the face of the box where it ends. At a smaller angle, points on the face stay.
   */
  static constexpr double LeastSquareOnFace = 0.5;

  /** \name Voxel centres. Measured: what their recovery gives. */
  static constexpr int   CentrePasses = 2;
  static constexpr Floor CentreFloor{ 26.0, 0.93 };
  /** Points move by this, then by half of it, and so on, down to the shortest. */
  static constexpr double LongestCentreMove = 0.2;
  static constexpr double ShortestCentreMove = 0.04;
  /** A gain in depth that is not worth a move. */
  static constexpr double NegligibleDepth = 1e-6;
  /** Where more centres than this are around a point, elements are so coarse that centres are no measure for them. */
  static constexpr std::size_t MostCentres = 100;
  /** Points that did not leave their cell may do so by this when they make room for those that moved. */
  static constexpr double RoomOffCell = 0.02;
  /** A triangle whose points make room keeps this radius ratio. */
  static constexpr double TriangleFloorOfRoom = 0.8;
  /** Points that are further than this from where they belong stay where they are. */
  static constexpr double Far = 1.0;
  /** Centres this near to a face belong to both tetrahedra: rounding. */
  static constexpr double OnFace = 1e-9;
};

/** \brief The numbers of the edges of second-order meshes. */
struct EdgeCurvingParameters
{
  /** The mid-node of an edge is no further from the edge's middle than this times its length. Analysis: in half of a
   * circle, the middle of the arc is 0.5 from its chord. */
  static constexpr double LargestRise = 0.25;
  /** The least Jacobian of a tetrahedron, in units of that with straight edges: shapes of elements that are distorted
   * further spoil the order of convergence. */
  static constexpr double LeastJacobian = 0.2;
};

/** \brief The numbers by which points slide on the interfaces that a mesh has at first. */
struct TriangulationParameters
{
  /** The tolerance where edges are this long, if it is automatic. Analysis: about the rise of an arc of 32 degrees. */
  static constexpr double ToleranceOfEdges = 0.07;
  /** Points slide no further than this times the mean length of the edges around them. */
  static constexpr double LongestSlide = 1.0;
  /** The least cosine between normals: the other side of a thin sheet is no place to slide to. */
  static constexpr double LeastAlignment = 0.3;
  /** How far from a chord towards the mean of its ends' tangents. Analysis: half of the way is on the circle. */
  static constexpr double Roundness = 0.5;
  /** How far an interface is looked for, in units of the largest tolerance; what is further has no distance. */
  static constexpr double ReachInTolerances = 4.0;
};
} // namespace mmm

#endif
