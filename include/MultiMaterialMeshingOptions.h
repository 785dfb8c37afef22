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
#ifndef MultiMaterialMeshingOptions_h
#define MultiMaterialMeshingOptions_h

#include "MultiMaterialMeshingExport.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace mmm
{
/** The value of a length that is to follow the image or mesh. It is not a number: test with std::isnan(). */
constexpr double Automatic = std::numeric_limits<double>::quiet_NaN();

/** \brief What is asked of the edge lengths in a label or a region.
 *
 * Where two labels with rules meet, the smaller result holds. Lengths are in mm, the unit of the image's spacing. */
struct SizeRule
{
  /** On the edge length at the interfaces, positive and finite. */
  double factor{ 1.0 };
  /** Bounds in the label and at its interfaces, positive, in place of the general ones; Automatic where not given. */
  double minimumSize{ Automatic };
  double maximumSize{ Automatic };

  /** Whether it asks for anything. */
  bool
  IsGiven() const
  {
    return factor != 1.0 || !std::isnan(minimumSize) || !std::isnan(maximumSize);
  }
};

/** Rules by label. */
using LabelSizeRules = std::map<int, SizeRule>;

/** \brief Rules from a text such as "3:factor=0.5:max=2,7:min=1".
 *
 * Labels are separated by commas. What is asked of each follows after colons: factor, min and max, in any order. An
 * empty text has no rules. Throws itk::ExceptionObject that tells what cannot be read. Values are not checked. */
MultiMaterialMeshing_EXPORT LabelSizeRules
ParseLabelSizeRules(const std::string & text);

/** The text that gives these rules. */
MultiMaterialMeshing_EXPORT std::string
                            ToText(const LabelSizeRules & rules);

/** What is wrong with a rule, in a sentence that calls its place, such as "label 3", by name; empty if nothing is. */
MultiMaterialMeshing_EXPORT std::string
                            DescribeError(const SizeRule & rule, const std::string & place);

/** The edge length that keeps tetrahedra below a volume, in the cube of its unit. */
MultiMaterialMeshing_EXPORT double
SizeOfVolume(double volume);

/** \brief What is asked of the edge lengths of a mesh. Lengths are in mm, the unit of the image's spacing. */
struct SizingOptions
{
  /** The edge length at the interfaces per local feature size, without unit, positive; 1.0 for a high resolution. */
  double epsilon{ 2.5 };
  /** The largest distance of a curved interface to the edges that stand for it, positive. Automatic is 0.1 of the
   * smallest voxel spacing. */
  double chordTolerance{ Automatic };
  /** How fast the edge length may grow with distance, without unit, positive. */
  double gradientLimit{ 0.5 };
  /** The smallest edge length to ask for, positive. Automatic is the smallest voxel spacing, or maximumSize where that
   * is smaller. */
  double minimumSize{ Automatic };
  /** The largest edge length to ask for, positive and not below minimumSize; infinity is no limit. Automatic is a
   * 25th part of the cube root of what is meshed, but at least minimumSize and three times the smallest voxel spacing;
   * where a sizing image replaces sizes, no limit. */
  double maximumSize{ Automatic };
  /** The volume that no tetrahedron is to exceed, in mm^3, positive. Edge lengths are kept so small that none does;
   * what other bounds say is no excuse. */
  double maximumVolume{ std::numeric_limits<double>::infinity() };
  /** What is asked of labels. */
  LabelSizeRules labelSizes;
  /** Whether a sizing image stands in place of the computed edge lengths, within the bounds; else it is their maximum.
   */
  bool sizingImageReplaces{ false };
  /** The bounds in the region of interest, which stand in place of all others there; its factor is 1. */
  SizeRule region;
};

/** \brief How meshes are made once indicators and sizes are known. */
struct MeshingOptions
{
  /** The particles' order of insertion. Another seed gives another mesh of the same kind. */
  std::uint64_t seed{ 1 };
  /** Leave out the interior: only the surface is made. */
  bool surfaceOnly{ false };
  /** The order of the elements, 1 or 2: with 2, edges on interfaces have mid-nodes on the interfaces. */
  unsigned int elementOrder{ 1 };
  /** Compare the components, tunnels and cavities of each label in the mesh with those of the largest indicator's
   * region, see MeshingReport::topology. */
  bool compareTopology{ false };
  /** How many tetrahedra the mesh is to have, within 5 %; 0 leaves it to the sizes. Where more are wanted, all edge
   * lengths are shortened alike. Where fewer are wanted, the mesh is coarsened: the shortest edges, by what is asked
   * for there, are pulled together as long as the labels' connections, their interfaces and the shape of tetrahedra
   * allow it; if they do not, there are more, which is a warning. */
  std::size_t numberOfTetrahedra{ 0 };
  /** Meshes that are expected to have more tetrahedra, or to need more memory, in GB (2^30 bytes), positive, are
   * refused. */
  std::size_t maximumNumberOfTetrahedra{ std::numeric_limits<std::size_t>::max() };
  double      maximumMemory{ std::numeric_limits<double>::infinity() };
};

/** \brief Which connections of the labels a mesh has. */
enum class TopologyMode
{
  /** Keep where epsilon is at most 1, else Any. */
  Automatic,
  /** Those that the edge lengths resolve: passages about as wide as a voxel may open or close. */
  Any,
  /** Those of the image, as far as possible. Voxels of a label that share a face stay connected, narrow passages get
   * more and smaller elements, and what differs is looked for at a quarter of a voxel. */
  Keep
};

/** "auto", "any" or "keep". */
MultiMaterialMeshing_EXPORT std::string
                            ToText(TopologyMode mode);

/** The mode of these texts. Throws itk::ExceptionObject for others. */
MultiMaterialMeshing_EXPORT TopologyMode
ParseTopologyMode(const std::string & text);

/** \brief How a label image is read. Lengths are in mm, the unit of the image's spacing. */
struct LabelOptions
{
  /** Labels that are not meshed. They are one material, which takes the first of them that the image has. */
  std::vector<int> exteriorLabels{ 0 };
  /** Mesh the exterior as well, as one label. */
  bool fillExterior{ false };
  /** How far the box of what is meshed is to go beyond what is not exterior, not negative; says that the exterior is
   * filled. Automatic: the box is the image's. */
  double airMargin{ Automatic };
  /** Components of a label with fewer voxels go to the neighbor that they touch most; 0 and 1 keep all. */
  std::size_t minimumIslandSize{ 8 };
  /** Leave slices that are at least four times as thick as voxels are wide as they are, rather than divide them. */
  bool keepSlices{ false };
  /** The radius of tightening, which rounds what is smaller, at least 0; 0 keeps the voxels' steps. Automatic: 0.5 of
   * the smallest voxel spacing. */
  double       radius{ Automatic };
  TopologyMode topologyMode{ TopologyMode::Automatic };
  /** Go on if a label of more than 1,000 voxels is in no mesh; smaller ones may be missing anyway. */
  bool allowVanishedLabels{ false };
  /** Keep the indicator images and the sizing image. */
  bool keepIntermediates{ false };
};

/** \brief How far the optimizer of labelled tetrahedra may go. */
struct ImprovementOptions
{
  /** How far an interface may leave its place, in the mesh's unit, positive. Automatic: 0.07 of the length of the edges
   * there. */
  double tolerance{ Automatic };
  /** Edges of interfaces at which the normals differ by more are kept; in degrees, within [0, 180]. */
  double featureAngle{ 40.0 };
  /** The number of rounds at most; fewer if nothing is changed any more. */
  int maximumNumberOfRounds{ 10 };
};
} // namespace mmm

#endif
