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
#include "OptionTable.h"

#include "MeshFormat.h"

#include <iterator>
#include <sstream>

namespace cli
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
const Range      AnyValue;
const Range      Positive{ 0.0, false, Infinity };
const Range      NonNegative{ 0.0, true, Infinity };
const Range      AtLeastOne{ 1.0, true, 1024.0 };

template <typename T>
std::string
ToText(const T & value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

std::vector<Option>
MakeTable()
{
  const Settings standard;
  return {
    { "LABELS",
      &Settings::labels,
      Kind::LabelImage,
      Channel::Input,
      "Input",
      "",
      "",
      AnyValue,
      "",
      "Three-dimensional image of integer labels: .nrrd, .nii, .nii.gz, .mha, .mhd." },
    { "indicators",
      &Settings::indicators,
      Kind::ScalarImages,
      Channel::Input,
      "Input",
      "FILE...",
      "",
      AnyValue,
      "",
      "Instead of LABELS: an image per material, of probabilities or other functions that are the larger the further "
      "inside. If none is exterior, the exterior is 1 - sum of probabilities, or where signed functions are negative.",
      {},
      false,
      true },
    { "indicator-labels",
      &Settings::indicatorLabels,
      Kind::Labels,
      Channel::Input,
      "Input",
      "L[,L...]",
      "",
      AnyValue,
      "1,2,3...",
      "Label of each of the indicators.",
      {},
      false,
      true },
    { "exterior",
      &Settings::exterior,
      Kind::Labels,
      Channel::Input,
      "Input",
      "L[,L...]",
      "",
      AnyValue,
      "0",
      "Labels that are not meshed; 'none' meshes all." },
    { "min-island",
      &Settings::minIsland,
      Kind::Integer,
      Channel::Input,
      "Input",
      "N",
      "voxels",
      NonNegative,
      ToText(standard.minIsland),
      "Islands of fewer voxels go to the label that they touch most. A label's largest part always stays; 0 keeps "
      "everything." },

    { "OUTPUT",
      &Settings::output,
      Kind::Mesh,
      Channel::Output,
      "Output",
      "",
      "",
      AnyValue,
      "",
      "File for the tetrahedra: .vtu (cell array 'label'), .msh (Gmsh) or .mesh (Medit); the latter two with the "
      "triangles between labels." },
    { "surface",
      &Settings::surface,
      Kind::Surface,
      Channel::Output,
      "Output",
      "FILE",
      "",
      AnyValue,
      "",
      "Also write the triangles between labels: .vtu (cell arrays 'label_a', 'label_b'), .msh or .mesh; .stl, .obj or "
      ".off have no labels." },
    { "surface-per-label",
      &Settings::surfacePrefix,
      Kind::FilePrefix,
      Channel::Output,
      "Output",
      "PREFIX",
      "",
      AnyValue,
      "",
      "Also write the closed surface of each label as PREFIX<label>.stl, normals outward; PREFIX.vtu and so on gives "
      "another format." },
    { "particles",
      &Settings::particles,
      Kind::Particles,
      Channel::Output,
      "Output",
      "FILE.vtu",
      "",
      AnyValue,
      "",
      "Also write the particles that sample the interfaces." },
    { "surface-only",
      &Settings::surfaceOnly,
      Kind::Flag,
      Channel::Input,
      "Output",
      "",
      "",
      AnyValue,
      "",
      "Make no tetrahedra; OUTPUT is the surface." },
    { "msh-format",
      &Settings::mshFormat,
      Kind::Choice,
      Channel::Input,
      "Output",
      "F",
      "",
      AnyValue,
      standard.mshFormat,
      "Of .msh files: version 4.1 or 2.2, binary or text, or as SimNIBS wants it (2.2, RAS, its numbers of surfaces).",
      { std::begin(MshFormats), std::end(MshFormats) } },
    { "ras",
      &Settings::ras,
      Kind::Flag,
      Channel::Input,
      "Output",
      "",
      "",
      AnyValue,
      "",
      "Points in RAS instead of LPS; in .vtu they are always in LPS, and the file says so." },
    { "report",
      &Settings::report,
      Kind::File,
      Channel::Output,
      "Output",
      "FILE.json",
      "",
      AnyValue,
      "",
      "Write parameters, time and memory per stage, counts and quality per label." },

    { "radius",
      &Settings::radius,
      Kind::Real,
      Channel::Input,
      "Smoothing",
      "R",
      "mm",
      NonNegative,
      "0.5 of the smallest spacing",
      "Tightening radius: details thinner than about twice of it are smoothed away; 0 does not smooth." },
    { "save-indicators",
      &Settings::indicatorPrefix,
      Kind::FilePrefix,
      Channel::Output,
      "Smoothing",
      "PREFIX",
      "",
      AnyValue,
      "",
      "Write the smooth indicator function of each label as PREFIX<label>.nrrd." },

    { "epsilon",
      &Settings::epsilon,
      Kind::Real,
      Channel::Input,
      "Sizing",
      "E",
      "",
      Positive,
      ToText(standard.epsilon),
      "Edge length per local feature size; 1 makes thin layers finer." },
    { "tolerance",
      &Settings::tolerance,
      Kind::Real,
      Channel::Input,
      "Sizing",
      "D",
      "mm",
      Positive,
      "0.1 of the smallest spacing",
      "Chord tolerance: how far an edge may be from the curved interface that it stands for." },
    { "gradient-limit",
      &Settings::gradientLimit,
      Kind::Real,
      Channel::Input,
      "Sizing",
      "G",
      "",
      Positive,
      ToText(standard.gradientLimit),
      "How fast the edge length may grow with distance." },
    { "min-size",
      &Settings::minSize,
      Kind::Real,
      Channel::Input,
      "Sizing",
      "H",
      "mm",
      Positive,
      "the smallest spacing",
      "Smallest edge length to ask for." },
    { "max-size",
      &Settings::maxSize,
      Kind::Real,
      Channel::Input,
      "Sizing",
      "H",
      "mm",
      Positive,
      "no limit",
      "Largest edge length to ask for." },
    { "sizing-image",
      &Settings::sizingImage,
      Kind::ScalarImage,
      Channel::Input,
      "Sizing",
      "FILE",
      "",
      AnyValue,
      "",
      "Image of edge lengths in mm that are not to be exceeded." },
    { "save-sizing",
      &Settings::sizingFile,
      Kind::ScalarImage,
      Channel::Output,
      "Sizing",
      "FILE",
      "",
      AnyValue,
      "",
      "Write the sizing field, the edge length asked for in mm: .nrrd, .nii, .nii.gz or .mha." },

    { "threads",
      &Settings::threads,
      Kind::Integer,
      Channel::Input,
      "Advanced",
      "N",
      "",
      AtLeastOne,
      "all cores",
      "Number of threads; it does not change the result." },
    { "seed",
      &Settings::seed,
      Kind::Integer,
      Channel::Input,
      "Advanced",
      "N",
      "",
      NonNegative,
      ToText(standard.seed),
      "Seed of the random order in which particles are thinned." },
    { "quiet",
      &Settings::quiet,
      Kind::Flag,
      Channel::Input,
      "Advanced",
      "",
      "",
      AnyValue,
      "",
      "Print warnings and errors only." },
    { "slicer-progress",
      &Settings::slicerProgress,
      Kind::Flag,
      Channel::Input,
      "Advanced",
      "",
      "",
      AnyValue,
      "",
      "Print progress as the XML elements that 3D Slicer reads, which passes this option.",
      {},
      true },
  };
}
} // namespace

bool
Option::IsPositional() const
{
  return name.front() >= 'A' && name.front() <= 'Z';
}

std::string
NameOf(const Option & option)
{
  return option.IsPositional() ? option.name : "--" + option.name;
}

const std::vector<Option> &
OptionTable()
{
  static const std::vector<Option> table = MakeTable();
  return table;
}
} // namespace cli
