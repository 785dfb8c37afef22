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
#ifndef Settings_h
#define Settings_h

#include "options/CellDataRequest.h"
#include "MultiMaterialMeshingOptions.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cli
{
/** A file for the outer surface of what the labels fill together. */
struct Hull
{
  std::string      file;
  std::vector<int> labels;
};

/** A file with a surface, and the label of what it encloses. */
struct SurfaceLabel
{
  int         label;
  std::string file;
};

/** \brief What the command line says. OptionTable() describes each member to the user.
 *
 * Lengths are in mm. Those without a value follow from the image's smallest spacing. */
struct Settings
{
  std::string labels;
  std::string output;

  /** In place of `labels`: a function per material, and the materials' labels, 1 to N if there are none. */
  std::vector<std::string> indicators;
  std::vector<int>         indicatorLabels;

  /** On top of `labels`, or alone: surfaces, later ones over earlier ones, and the voxels of their grid if they are
   * alone. */
  std::vector<SurfaceLabel> surfaceLabels;
  std::optional<double>     surfaceSpacing;
  bool                      surfacesAreInRAS{ false };

  /** On top of all this: a file of electrodes. */
  std::string electrodes;

  /** The labels to mesh, if they are listed; which are joined, "9=3,4;8=1,2"; and a file of other numbers for them. */
  std::vector<int> onlyLabels;
  std::string      merges;
  std::string      labelMap;
  bool             labelsAnyway{ false };

  std::vector<int>      exterior{ 0 };
  bool                  exteriorIsListed{ false };
  bool                  fillExterior{ false };
  std::optional<double> airMargin;
  std::uint64_t         minIsland{ 8 };
  bool                  keepSlices{ false };
  bool                  allowVanished{ false };

  std::string       surface;
  std::string       particles;
  std::string       junctions;
  bool              surfaceOnly{ false };
  std::uint64_t     order{ 1 };
  std::string       surfacePrefix;
  std::vector<Hull> hulls;
  std::string       mshFormat{ "4.1" };
  bool              ras{ false };

  /** Pages to look at and JSON, by their extensions. */
  std::vector<std::string> reports;

  /** Files: what labels are called, or "none"; what they conduct; and images to sample. */
  std::string                  names;
  std::string                  conductivity;
  std::vector<CellDataRequest> cellData;

  std::optional<double> radius;
  std::string           indicatorPrefix;

  double                epsilon{ 2.5 };
  std::string           topology{ "auto" };
  std::optional<double> tolerance;
  double                gradientLimit{ 0.5 };
  std::optional<double> minSize;
  std::optional<double> maxSize;
  std::optional<double> maxVolume;
  mmm::LabelSizeRules   labelSizes;
  std::string           sizingImage;
  std::string           sizingMode{ "minimum" };
  std::string           refineBy;
  std::optional<double> refineFactor;
  std::string           roi;
  std::optional<double> roiMinSize;
  std::optional<double> roiMaxSize;
  std::string           sizingFile;

  std::optional<std::uint64_t> tetrahedra;
  bool                         expectOnly{ false };
  std::optional<std::uint64_t> maxTetrahedra;
  std::optional<double>        maxMemory;

  std::optional<std::uint64_t> threads;
  std::uint64_t                seed{ 1 };
  bool                         quiet{ false };
  bool                         slicerProgress{ false };

  bool
  IsExterior(int label) const
  {
    return std::find(exterior.begin(), exterior.end(), label) != exterior.end();
  }

  bool
  HasCellData() const
  {
    return !conductivity.empty() || !cellData.empty();
  }

  bool
  IsFilled() const
  {
    return fillExterior || airMargin;
  }
};
} // namespace cli

#endif
