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
#include "options/OptionTable.h"

#include "itkLabelImageToTetrahedralMeshFilter.h"
#include "itkLabelMeshFileWriter.h"

#include <algorithm>
#include <iterator>
#include <locale>
#include <sstream>
#include <type_traits>

namespace cli
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
const Range      AnyValue;
const Range      Positive{ 0.0, false, Infinity };
const Range      NonNegative{ 0.0, true, Infinity };
const Range      AtLeastOne{ 1.0, true, Infinity };
const Range      ThreadCount{ 1.0, true, 1024.0 };
const Range      OneOrTwo{ 1.0, true, 2.0 };

template <typename T, typename TSetter>
void
SetIfGiven(const T & value, const TSetter & set)
{
  set(value);
}

/** The filter keeps its default. */
template <typename T, typename TSetter>
void
SetIfGiven(const std::optional<T> & value, const TSetter & set)
{
  if (value)
  {
    set(*value);
  }
}

// clang-format off
#define PARAMETER(field, name) \
  Target(&Settings::field, #name, [](MeshFilter & filter, const Settings & settings) { \
    SetIfGiven(settings.field, [&](const auto & value) { filter.Set##name(value); }); \
  })

std::vector<OptionGroup>
MakeTable()
{
  using S = Settings;
  return {
    { "Input", "What is meshed", {
    { "LABELS", &S::labels, Kind::LabelImage, "", "", AnyValue, "",
      "Three-dimensional image of integer labels: .nrrd, .nii, .nii.gz, .mha, .mhd, .mgz." },
    { "indicators", &S::indicators, Kind::ScalarImages, "FILE...", "", AnyValue, "",
      "Instead of LABELS: an image per material, of probabilities or other functions that are the larger the further "
      "inside. If none is exterior, the exterior is 1 - sum of probabilities, or where signed functions are negative.",
      {}, Audience::CommandLine },
    { "indicator-labels", Target(&S::indicatorLabels, "IndicatorLabels"), Kind::Labels, "L[,L...]", "", AnyValue, "1,2,3...",
      "Label of each of the indicators.", {}, Audience::CommandLine },
    { "surface-label", Target(&S::surfaceLabels, "SurfaceLabels"), Kind::SurfaceLabels, "L=FILE", "", AnyValue, "",
      "Give label L to what a closed surface encloses, on top of LABELS or without: .stl, .obj, .off, .vtk, .gii or "
      "FreeSurfer's. For several, give the option again; a later one wins.",
      {}, Audience::CommandLine },
    { "surface-spacing", &S::surfaceSpacing, Kind::Real, "MM", "mm", Positive, "from the surfaces' extent",
      "Without LABELS: the voxels of the grid on which the surfaces are known.", {}, Audience::CommandLine },
    { "surface-ras", &S::surfacesAreInRAS, Kind::Flag, "", "", AnyValue, "",
      "Points of surface files that do not say are in RAS instead of LPS.", {}, Audience::CommandLine },
    { "electrodes", &S::electrodes, Kind::TextFile, "FILE.json", "", AnyValue, "",
      "Put electrodes and implants on top, as the exact shapes that the file describes: docs/electrodes.md." },
    { "labels", &S::onlyLabels, Kind::Labels, "L[,L...]", "", AnyValue, "all",
      "Labels to mesh; all others become exterior. --map comes first, then --merge, then this." },
    { "merge", &S::merges, Kind::Merges, "NEW=L,L[,L...]", "", AnyValue, "",
      "Join labels to one, which may be another one; for several, give the option again." },
    { "map", &S::labelMap, Kind::TextFile, "FILE", "", AnyValue, "",
      "Other numbers for labels, from a text file with OLD NEW, FIRST..LAST NEW or * NEW (all others) on each line." },
    { "labels-anyway", PARAMETER(labelsAnyway, AcceptIntensities), Kind::Flag, "", "", AnyValue, "",
      "Mesh an image that looks like intensities: each value is a label." },
    { "exterior", PARAMETER(exterior, ExteriorLabels), Kind::Labels, "L[,L...]", "", AnyValue, "",
      "Labels that are not meshed; 'none' meshes all." },
    { "fill-exterior", PARAMETER(fillExterior, FillExterior), Kind::Flag, "", "", AnyValue, "",
      "Mesh the exterior as well, up to the faces of the image's box: air, with the exterior label." },
    { "air-margin", PARAMETER(airMargin, AirMargin), Kind::Real, "MM", "mm", NonNegative, "none",
      "Fill the exterior up to a box that goes this far beyond what else is meshed." },
    { "min-island", PARAMETER(minIsland, MinimumIslandSize), Kind::Integer, "N", "voxels", NonNegative, "",
      "Islands of fewer voxels go to the label that they touch most. A label's largest part always stays; 0 keeps "
      "everything." },
    { "keep-slices", PARAMETER(keepSlices, KeepSlices), Kind::Flag, "", "", AnyValue, "",
      "Leave slices that are at least four times as thick as voxels are wide as they are. Otherwise they are divided, with "
      "shapes that change evenly from slice to slice." },
    { "allow-vanished", PARAMETER(allowVanished, AllowVanishedLabels), Kind::Flag, "", "", AnyValue, "",
      "Write a mesh even if a label of more than 1,000 voxels is not in it, as it is too thin." } } },

    { "Output", "What is written", {
    { "OUTPUT", &S::output, Kind::Mesh, "", "", AnyValue, "",
      "File for the tetrahedra: .vtu (cell array 'label'), .msh (Gmsh) or .mesh (Medit); the latter two with the "
      "triangles between labels." },
    { "surface", &S::surface, Kind::Surface, "FILE", "", AnyValue, "",
      "Also write the triangles between labels: .vtu (cell arrays 'label_a', 'label_b'), .msh or .mesh; .stl, .obj, "
      ".off and .surf (FreeSurfer) have no labels." },
    { "surface-per-label", &S::surfacePrefix, Kind::FilePrefix, "PREFIX", "", AnyValue, "",
      "Also write the closed surface of each label as PREFIX<label>.stl, normals outward; PREFIX.vtu and so on gives "
      "another format." },
    { "hull", &S::hulls, Kind::Hulls, "FILE=L[,L...]", "", AnyValue, "",
      "Also write the outer surface of the labels together, without cavities, for boundary elements: a file as of "
      "--surface; .surf is for MNE-Python. For several, give the option again.",
      {}, Audience::CommandLine },
    { "particles", &S::particles, Kind::Particles, "FILE.vtu", "", AnyValue, "",
      "Also write the particles that sample the interfaces." },
    { "junctions", &S::junctions, Kind::Junctions, "FILE.vtu", "", AnyValue, "",
      "Also write the curves and points where three and more labels meet." },
    { "surface-only", PARAMETER(surfaceOnly, SurfaceOnly), Kind::Flag, "", "", AnyValue, "",
      "Leave out the interior; OUTPUT is the surface." },
    { "order", PARAMETER(order, ElementOrder), Kind::Integer, "N", "", OneOrTwo, "",
      "Order of the elements in .vtu and .msh: 2 gives tetrahedra of ten nodes and triangles of six, curved on "
      "interfaces." },
    { "msh-format", &S::mshFormat, Kind::Choice, "F", "", AnyValue, "",
      "Of .msh files: version 4.1 or 2.2 (for GetDP), binary or text (2.2-ascii for DUNE and OpenFOAM), or as SimNIBS "
      "wants it (2.2, RAS, its numbers of surfaces).",
      itk::LabelMeshFileWriter::GetMshFormats() },
    { "names", &S::names, Kind::TextFile, "FILE", "", AnyValue, "",
      "Names and colors of labels, from a table of BIDS (.tsv), FreeSurfer, 3D Slicer (.ctbl, .seg.nrrd) or ITK-SNAP, or "
      "from .json; 'none' for none. Without it, those of a .seg.nrrd, or of BIDS beside an image *_dseg, are taken." },
    { "conductivity", &S::conductivity, Kind::TextFile, "FILE", "", AnyValue, "",
      "Write the conductivity of each tetrahedron as cell data, in S/m, from a text file with LABEL S/M or NAME S/M on "
      "each line, or from .json; for .vtu and .msh." },
    { "cell-data", &S::cellData, Kind::CellData, "NAME=IMAGE[:MODE]", "", AnyValue, "",
      "Write what another image is in each tetrahedron as cell data, by MODE: its mean, or at the center, nearest or "
      "linear; for .vtu and .msh. For several, give the option again.",
      {}, Audience::CommandLine },
    { "ras", &S::ras, Kind::Flag, "", "", AnyValue, "",
      "Points in RAS instead of LPS; in .vtu they are always in LPS, in .surf always in RAS." } } },

    { "Smoothing", "How the interfaces between labels are smoothed", {
    { "radius", PARAMETER(radius, Radius), Kind::Real, "R", "mm", NonNegative, "0.5 of the smallest spacing",
      "Tightening radius: details thinner than about twice of it are smoothed away; 0 does not smooth." },
    { "save-indicators", &S::indicatorPrefix, Kind::FilePrefix, "PREFIX", "", AnyValue, "",
      "Write the smooth indicator function of each label as PREFIX<label>.nrrd." } } },

    { "Sizing", "How long edges are", {
    { "epsilon", PARAMETER(epsilon, Epsilon), Kind::Real, "E", "", Positive, "",
      "Edge length per local feature size; 1 makes thin layers finer." },
    { "topology", PARAMETER(topology, TopologyMode), Kind::Choice, "T", "", AnyValue, "",
      "Connections of the labels: those of the image as far as possible (keep), or any that the edge lengths resolve; "
      "auto keeps them where --epsilon is at most 1.",
      { "auto", "any", "keep" } },
    { "tolerance", PARAMETER(tolerance, ChordTolerance), Kind::Real, "D", "mm", Positive, "0.1 of the smallest spacing",
      "Chord tolerance: how far an edge may be from the curved interface that it stands for." },
    { "gradient-limit", PARAMETER(gradientLimit, GradientLimit), Kind::Real, "G", "", Positive, "",
      "How fast the edge length may grow with distance." },
    { "min-size", PARAMETER(minSize, MinimumSize), Kind::Real, "H", "mm", Positive, "the smallest spacing",
      "Smallest edge length to ask for." },
    { "max-size", PARAMETER(maxSize, MaximumSize), Kind::Real, "H", "mm", Positive,
      "a 25th part of the cube root of what is meshed, at least 3 times the smallest spacing",
      "Largest edge length to ask for." },
    { "label-size", PARAMETER(labelSizes, LabelSizes), Kind::LabelSizes, "L:KEY=X[:...][,...]", "", AnyValue, "",
      "Sizes by label: 'factor' on the edge length at its interfaces, 'min' and 'max' of it in mm instead of the "
      "general ones; for instance 3:factor=0.5:max=2,7:min=1." },
    { "sizing-image", Target(&S::sizingImage, "SizingImage"), Kind::ScalarImage, "FILE", "", AnyValue, "",
      "Image of edge lengths in mm on the grid of LABELS, for --sizing-mode." },
    { "sizing-mode", Target(&S::sizingMode, "SizingImageReplaces"), Kind::Choice, "M", "", AnyValue, "",
      "Whether edges get the shorter one of the sizing image's and our length, or the image's instead of ours.",
      { "minimum", "replace" } },
    { "refine-by", Target(&S::refineBy, "SizingImage"), Kind::TextFile, "FILE.vtu", "", AnyValue, "",
      "Shorter edges where a solution has large errors: a mesh of the same image, with the error of each tetrahedron, at "
      "least 0, as the cell data array 'error'.", {}, Audience::CommandLine },
    { "refine-factor", Target(&S::refineFactor), Kind::Real, "F", "", { 1.0, false, 64.0 }, "2",
      "How many times as many tetrahedra --refine-by is to give as there are in FILE.vtu.", {}, Audience::CommandLine },
    { "roi", Target(&S::roi, "RegionOfInterest"), Kind::LabelImage, "FILE", "", AnyValue, "",
      "Region of interest: a mask on the grid of LABELS with bounds of its own where it is not 0." },
    { "roi-min-size", PARAMETER(roiMinSize, RegionMinimumSize), Kind::Real, "H", "mm", Positive, "as elsewhere",
      "Smallest edge length to ask for in the region of interest." },
    { "roi-max-size", PARAMETER(roiMaxSize, RegionMaximumSize), Kind::Real, "H", "mm", Positive, "as elsewhere",
      "Largest edge length to ask for in the region of interest." },
    { "tetrahedra", PARAMETER(tetrahedra, NumberOfTetrahedra), Kind::Integer, "N", "", AtLeastOne, "as the sizes say",
      "How many tetrahedra the mesh is to have, within 5 %. Where the labels and the shape of tetrahedra need more, "
      "a warning says so." },
    { "save-sizing", &S::sizingFile, Kind::OutputImage, "FILE", "", AnyValue, "",
      "Write the sizing field, the edge length asked for in mm: .nrrd, .nii, .nii.gz or .mha." } } },

    { "Quality", "How good tetrahedra have to be, and how good they are", {
    { "max-volume", PARAMETER(maxVolume, MaximumVolume), Kind::Real, "V", "mm^3", Positive, "no limit",
      "Volume that no tetrahedron is to exceed; edges are kept short enough for that." },
    { "report", &S::reports, Kind::Report, "FILE", "", AnyValue, "",
      "Write parameters, time and memory per stage, counts, quality and topology per label: as a page to look at in a "
      "browser if FILE ends with .html, else as JSON. For both, give the option again." } } },

    { "Advanced", "How the program runs", {
    { "expect", &S::expectOnly, Kind::Flag, "", "", AnyValue, "",
      "Only print what is to be expected, points, tetrahedra and memory, and write nothing.", {}, Audience::CommandLine },
    { "max-tetrahedra", PARAMETER(maxTetrahedra, MaximumNumberOfTetrahedra), Kind::Integer, "N", "", AtLeastOne,
      "no limit", "Do not start on meshes that are expected to have more tetrahedra." },
    { "max-memory", PARAMETER(maxMemory, MaximumMemory), Kind::Real, "GB", "GB", Positive, "the machine's memory",
      "Do not start on meshes that are expected to take more memory." },
    { "threads", &S::threads, Kind::Integer, "N", "", ThreadCount, "all cores",
      "Number of threads; it does not change the result." },
    { "seed", PARAMETER(seed, Seed), Kind::Integer, "N", "", NonNegative, "",
      "Seed of the random order in which particles are thinned." },
    { "quiet", &S::quiet, Kind::Flag, "", "", AnyValue, "",
      "Print warnings and errors only." },
    { "slicer-progress", &S::slicerProgress, Kind::Flag, "", "", AnyValue, "",
      "As 3D Slicer wants it, which passes this option: progress as XML elements, and .vtu files that say LPS.",
      {}, Audience::Hidden } } },
  };
}
// clang-format on
#undef PARAMETER
} // namespace

bool
Option::IsPositional() const
{
  return name.front() >= 'A' && name.front() <= 'Z';
}

bool
Option::IsOutput() const
{
  const Kind kinds[] = { Kind::Mesh,        Kind::Surface, Kind::Particles,  Kind::Junctions,
                         Kind::OutputImage, Kind::Report,  Kind::FilePrefix, Kind::Hulls };
  return std::find(std::begin(kinds), std::end(kinds), kind) != std::end(kinds);
}

bool
Option::IsOptionalNumber() const
{
  return std::holds_alternative<std::optional<double> Settings::*>(target.field) ||
         std::holds_alternative<std::optional<std::uint64_t> Settings::*>(target.field);
}

const std::vector<OptionGroup> &
OptionTable()
{
  static const std::vector<OptionGroup> table = MakeTable();
  return table;
}

std::string
NameOf(const Option & option)
{
  return option.IsPositional() ? option.name : "--" + option.name;
}

std::string
ValueText(const Option & option, const Settings & settings)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  std::visit(
    [&](auto field) {
      const auto & value = settings.*field;
      using T = std::decay_t<decltype(value)>;
      if constexpr ((std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) || std::is_same_v<T, std::string>)
      {
        text << value;
      }
      else if constexpr (std::is_same_v<T, std::vector<int>>)
      {
        for (std::size_t i = 0; i < value.size(); ++i)
        {
          text << (i == 0 ? "" : ",") << value[i];
        }
      }
    },
    option.target.field);
  return text.str();
}

std::string
DefaultText(const Option & option)
{
  return option.defaultText.empty() ? ValueText(option, Settings{}) : option.defaultText;
}
} // namespace cli
