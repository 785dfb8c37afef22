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
#include <limits>
#include <map>
#include <string>

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
  /** The largest edge length to ask for, positive and not below minimumSize. */
  double maximumSize{ std::numeric_limits<double>::infinity() };
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
} // namespace mmm

#endif
