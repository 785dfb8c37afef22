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
#ifndef mmmSliceGap_h
#define mmmSliceGap_h

#include "image/ImageParts.h"
#include "image/SliceSides.h"

namespace mmm
{
/** The materials of a slice. */
using Slice = std::vector<Material>;

/** \brief What lies between two slices of a label image.
 *
 * The border of two materials moves evenly from where it is in one slice to where it is in the other: shape-based
 * interpolation (Raya and Udupa 1990, Shape-based interpolation of multidimensional objects), for each pair of
 * materials by itself. A distance to the border of a pair is not bounded by how thick the two are, so that thin layers
 * keep their thickness where they shift by more than that, and do not break.
 *
 * A part of a slice ends in the gap if nothing of its material is near in the other slice. It gets a dome there, with
 * the volume of half a voxel on each of its pixels.
 */
class SliceGap
{
public:
  /** Two slices at a distance, in the unit of the plane's spacing. */
  SliceGap(const SlicePlane & plane, double distance, Slice lower, Slice upper);

  /** The materials at a share of the way from the lower slice, 0, to the upper one, 1. */
  Slice
  At(double share) const;

private:
  /** A pixel of a part that ends, and how far that goes, as a share of the gap. */
  struct EndingPixel
  {
    std::size_t pixel;
    Material    material;
    double      reach;
  };
  /** A pixel that has not the same material in both slices: the materials that may lie there, and for each pair of them
   * the signed distances from their border in both slices, positive in the first one. */
  struct ChangingPixel
  {
    std::size_t                    pixel;
    std::vector<Material>          candidates;
    std::vector<BothSides<double>> contests;
  };

  BothSides<MaterialDistances>
  TakeOutEnds(double distance);
  ImageParts
  PartsOf(const Slice & slice) const;
  std::vector<EndingPixel>
  EndsOf(int side, const MaterialDistances & distancesInOther, double farthest) const;
  void
  AddDome(const std::vector<std::size_t> & pixels, int side, std::vector<EndingPixel> & ends) const;
  void
  FillIn(int side);
  MaterialDistances
  DistancesToMaterials(const Slice & slice) const;
  void
  FindChanges(const BothSides<MaterialDistances> & distances);
  void
  BalanceVolumes();
  static Material
  Winner(const ChangingPixel & pixel, double share);

  const SlicePlane                    m_Plane;
  BothSides<Slice>                    m_Slices; // without what ends
  BothSides<std::vector<EndingPixel>> m_Ends;
  std::vector<ChangingPixel>          m_Changes;
};
} // namespace mmm

#endif
