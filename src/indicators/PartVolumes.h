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
#ifndef mmmPartVolumes_h
#define mmmPartVolumes_h

#include "image/ImageParts.h"

#include <map>
#include <utility>

namespace mmm
{
/** Parts that have a voxel in the neighbourhood of a voxel: of each material the nearest one. */
struct NearbyParts
{
  static constexpr int Most = 27;

  int           count{ 0 };
  Material      materials[Most];
  std::uint32_t parts[Most];
};

/** What some voxels hold of each part, and how much the parts' shares change with an offset of the interface between
 * them, which is the area of that; in voxels and voxels per unit of length. */
struct PartShares
{
  std::map<std::uint32_t, double>                           volumes;
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> areas; // the lower part first
};

/** \brief Measures the parts of an image as the indicators shape them: a part has the places where its material's
 * indicator is the largest. */
class PartVolumes
{
public:
  PartVolumes(const MaterialImage & image, const ImageParts & parts, const std::vector<Block<float>> & indicators);

  /** Whether there is another material among the 26 voxels around one. */
  bool
  IsRim(const Index & at) const;

  NearbyParts
  FindNearby(const Index & at) const;

  /** How far the interface is from a voxel's centre, negative where that is not on its own material's side. */
  float
  Gap(const Index & at) const;

  /** What the voxels of a list hold. */
  PartShares
  Measure(const std::vector<std::size_t> & voxels) const;

private:
  /** Volumes are sums over this many samples along each axis of a voxel. */
  static constexpr int Samples = 3;
  static constexpr int SamplesPerVoxel = Samples * Samples * Samples;
  /** The nodes along each axis that a voxel's samples are interpolated from. */
  static constexpr int Support = 5;

  float
  ValueAt(Material m, const Index & at) const;
  void
  Interpolate(Material m, const Index & at, float (&result)[SamplesPerVoxel]) const;
  void
  AddVoxel(const Index & at, PartShares & shares) const;

  const MaterialImage &             m_Image;
  const ImageParts &                m_Parts;
  const std::vector<Block<float>> & m_Indicators;
  std::vector<Index>                m_Neighbours; // of a voxel, itself first, then by distance
  float                             m_Weights[Samples][Support];
};
} // namespace mmm

#endif
