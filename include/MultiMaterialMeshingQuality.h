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
#ifndef MultiMaterialMeshingQuality_h
#define MultiMaterialMeshingQuality_h

#include "MultiMaterialMeshingExport.h"

#include "itkPoint.h"

#include <array>
#include <cstddef>
#include <iosfwd>
#include <vector>

namespace mmm
{
/** Components, tunnels and cavities. */
using BettiNumbers = std::array<std::ptrdiff_t, 3>;

/** All are 0 without values. The percentile is interpolated linearly between the values next to it. */
struct Distribution
{
  double average{ 0.0 };
  double minimum{ 0.0 };
  double firstPercentile{ 0.0 };
};

struct MeshQualityOptions
{
  /** Tetrahedra with a dihedral angle below or above, in degrees, within [0, 180], are listed one by one. */
  double smallestAngle{ 10.0 };
  double largestAngle{ 165.0 };
  /** The list's greatest length: the worst are kept. All are counted. */
  std::size_t maximumListed{ 1000 };
  /** Points are duplicates if their coordinates are the same multiple of this, once rounded; in the points' unit, at
   * least 0. With 0 they must be equal. */
  double duplicateTolerance{ 1e-9 };
  /** Betti numbers add about a third to the time. */
  bool computeBettiNumbers{ false };
};

/** The shapes of the tetrahedra of a label, or of the whole mesh. Volumes are in the cube of the points' unit. */
struct TetrahedronStatistics
{
  static constexpr int RadiusRatioBins = 20;
  static constexpr int DihedralAngleBins = 18;

  std::size_t count{ 0 };
  /** The sum of the absolute volumes. */
  double volume{ 0.0 };
  double largestVolume{ 0.0 };
  /** Tetrahedra that are flat or turned over. */
  std::size_t nonPositive{ 0 };

  /** Three times the radius of the inscribed sphere over that of the circumscribed one, in [0, 1]. */
  Distribution radiusRatio;
  /** Of the smallest dihedral angle of each tetrahedron, in degrees. */
  Distribution smallestAngle;
  double       largestAngle{ 0.0 };

  /** Tetrahedra with a dihedral angle below 5, 10 and 15 degrees. */
  std::array<std::size_t, 3> below{ { 0, 0, 0 } };
  /** Tetrahedra with a dihedral angle above 165, 170 and 175 degrees. */
  std::array<std::size_t, 3> above{ { 0, 0, 0 } };

  /** Tetrahedra per twentieth of the radius ratio. */
  std::array<std::size_t, RadiusRatioBins> radiusRatioHistogram{ {} };
  /** Dihedral angles, six a tetrahedron, per 10 degrees. */
  std::array<std::size_t, DihedralAngleBins> dihedralAngleHistogram{ {} };
};

struct LabelQuality
{
  int                   label{ 0 };
  TetrahedronStatistics tetrahedra;

  /** Parts that tetrahedra with a common face hold together. */
  std::size_t components{ 0 };
  /** Faces behind which is another label, or nothing. */
  std::size_t boundaryFaces{ 0 };
  /** Edges with an odd number of boundary faces. A mesh whose faces have one or two tetrahedra each has none. */
  std::size_t openEdges{ 0 };
  /** Edges with more than two boundary faces: the label touches itself there. */
  std::size_t nonManifoldEdges{ 0 };
  /** Of the closed set of the label's tetrahedra, if asked for: a common point is enough to hold two components
   * together. */
  BettiNumbers betti{ { 0, 0, 0 } };
};

/** A tetrahedron with a dihedral angle beyond the bounds. */
struct PoorTetrahedron
{
  /** Where it is stuck. Points of interfaces, the outside among them, can be moved on them only. */
  enum class Place
  {
    /** No corner is on an interface. */
    Interior,
    /** Some are, not all. */
    BesideInterface,
    /** All corners are on interfaces, but no face: it spans a thin layer, or lies flat under the surface. */
    AcrossLayer,
    /** All corners are on interfaces, and at least a face. */
    OnInterface
  };
  Place
  GetPlace() const
  {
    return boundaryCorners == 0  ? Place::Interior
           : boundaryCorners < 4 ? Place::BesideInterface
           : boundaryFaces == 0  ? Place::AcrossLayer
                                 : Place::OnInterface;
  }

  std::size_t index{ 0 };
  int         label{ 0 };
  /** The other labels that it shares a face with, ascending. */
  std::vector<int> neighborLabels;
  /** Its faces on interfaces, the outside among them. */
  int boundaryFaces{ 0 };
  /** Its corners on interfaces. */
  int boundaryCorners{ 0 };
  /** The mean of its points. */
  itk::Point<double, 3> center{};
  /** In degrees. */
  double smallestAngle{ 0.0 };
  double largestAngle{ 0.0 };
};

/** What is measured of a labelled tetrahedral mesh. */
struct MeshQualityReport
{
  /** Of the whole mesh. */
  TetrahedronStatistics tetrahedra;
  /** Ascending. */
  std::vector<LabelQuality> labels;

  /** The faces between different labels or on the outside, each once. */
  std::size_t interfaceTriangles{ 0 };
  /** Twice the radius of the inscribed circle over that of the circumscribed one, in [0, 1]. */
  Distribution interfaceRadiusRatio;

  std::size_t points{ 0 };
  std::size_t unusedPoints{ 0 };
  /** The number of points less that of different ones. */
  std::size_t duplicatePoints{ 0 };
  /** Faces with more than two tetrahedra. */
  std::size_t overusedFaces{ 0 };
  /** Sums over the labels. */
  std::size_t openEdges{ 0 };
  std::size_t nonManifoldEdges{ 0 };

  /** Whether the labels' Betti numbers have been computed; if not, they are 0. */
  bool hasBettiNumbers{ false };

  std::size_t poorTetrahedra{ 0 };
  /** The worst of them, that with the angle closest to 0 or 180 degrees first. */
  std::vector<PoorTetrahedron> poorest;
};

/** "interior", "beside an interface", "across a thin layer" or "on an interface". */
const MultiMaterialMeshing_EXPORT char *
ToString(PoorTetrahedron::Place place);

/** Prints the report as a table, with a line for each label. */
MultiMaterialMeshing_EXPORT std::ostream &
                            operator<<(std::ostream & os, const MeshQualityReport & report);
} // namespace mmm

#endif
