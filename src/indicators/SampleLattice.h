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
#ifndef mmmSampleLattice_h
#define mmmSampleLattice_h

#include "indicators/IndicatorSet.h"

#include <cstdint>
#include <vector>

namespace mmm
{
/** The materials at those samples of a lattice that are kept. */
using SampledMaterials = std::vector<Material>;

/** \brief A lattice of samples at twice or four times the resolution of the grid, to compare partitions.
 *
 * The samples are the grid's nodes and what lies evenly between them and after the last ones, all moved by the
 * same small part of a voxel: interfaces between boxes of voxels have none on them. Those of voxels with an interface
 * around them are kept, in arrays that live elsewhere; any other sample is of its voxel's material. */
class SampleLattice
{
public:
  static constexpr std::size_t NotKept = std::size_t(-1);

  /** The samples per voxel and axis at which topologies are compared: what is half a voxel wide, as it is where
   * topologies are kept, takes four. */
  static constexpr int
  RefinementFor(bool keepTopology)
  {
    return keepTopology ? 4 : 2;
  }

  /** `refinement` is the number of samples per voxel and axis, 2 or 4. */
  explicit SampleLattice(const IndicatorSet & indicators, int refinement = 2);

  const IndicatorSet &
  GetIndicators() const
  {
    return m_Indicators;
  }
  /** Samples per voxel and axis. */
  int
  GetRefinement() const
  {
    return m_Refinement;
  }
  /** In samples. */
  const Index &
  GetSize() const
  {
    return m_Size;
  }
  bool
  Contains(const Index & sample) const
  {
    return sample[0] >= 0 && sample[1] >= 0 && sample[2] >= 0 && sample[0] < m_Size[0] && sample[1] < m_Size[1] &&
           sample[2] < m_Size[2];
  }
  /** On which side of the box along an axis is what has this index, below (-1), within (0), or above (1). Some of the
   * last samples are above. */
  int
  SideOf(int axis, int index) const
  {
    return index < 0 ? -1 : int(m_Origin[axis] + m_Step[axis] * index > m_Indicators.GetGrid().UpperFace(axis));
  }
  Vector
  Position(const Index & sample) const
  {
    return this->Position(Vector(sample[0], sample[1], sample[2]));
  }
  /** The sample that is the nearest to a point. */
  Index
  NearestTo(const Vector & x) const;

  /** Of all axes together. */
  int
  GetSamplesPerVoxel() const
  {
    return m_SamplesPerVoxel;
  }
  /** Those of a voxel follow each other, from its first corner to its last one. */
  std::size_t
  NumberOfKept() const
  {
    return m_Voxels.size() * m_SamplesPerVoxel;
  }
  /** Whether the samples of a voxel, by its node, are kept. Where they are not, they and all next to them are of the
   * voxel's material. */
  bool
  IsKept(std::size_t node) const
  {
    return m_Numbers[node] != NotNumbered;
  }
  /** Where a sample is in SampledMaterials, or NotKept. */
  std::size_t
  PlaceOf(const Index & sample) const;
  /** The inverse. */
  Index
  SampleAt(std::size_t place) const;
  Material
  At(const SampledMaterials & materials, const Index & sample) const
  {
    const auto place = this->PlaceOf(sample);
    return place == NotKept ? m_Indicators.MaterialAtNode(this->VoxelOf(sample)) : materials[place];
  }
  /** The node of a sample's voxel. */
  std::size_t
  VoxelOf(const Index & sample) const
  {
    return m_Indicators.GetGrid().Offset(sample[0] >> m_Shift, sample[1] >> m_Shift, sample[2] >> m_Shift);
  }
  /** Whether the nodes around a sample are of one material, and so the sample as well. */
  bool
  IsDecidedByNodes(const Index & sample) const;

  /** The material between samples: the coordinates are in samples. What is beyond the box is `exterior`. */
  Material
  MaterialAt(const Vector & sample, Material exterior) const;
  /** The material where those of two places, `first` and `last`, are equally large between them, or where the line
   * between the places leaves the box: a third one if there is a sheet of it, however thin. */
  Material
  MaterialBetween(const Vector & begin, const Vector & end, Material first, Material last) const;
  /** The argmax partition of the indicators; what is beyond the box is `exterior`. */
  SampledMaterials
  SamplePartition(Material exterior) const;

private:
  Vector
  Position(const Vector & sample) const
  {
    return m_Origin + m_Step.cwiseProduct(sample);
  }
  /** Some of the last samples are. */
  bool
  IsBeyondBox(const Vector & x) const
  {
    const Grid & grid = m_Indicators.GetGrid();
    return x[0] > grid.UpperFace(0) || x[1] > grid.UpperFace(1) || x[2] > grid.UpperFace(2);
  }

  static constexpr std::uint32_t NotNumbered = 0xffffffffu;

  const IndicatorSet & m_Indicators;
  const int            m_Refinement;
  const int            m_Shift; // divides by the refinement
  const int            m_SamplesPerVoxel;
  Index                m_Size;
  Vector               m_Origin;
  Vector               m_Step;
  /** The voxels whose samples are kept, ascending, and each voxel's number among them. */
  std::vector<std::size_t>   m_Voxels;
  std::vector<std::uint32_t> m_Numbers;
};
} // namespace mmm

#endif
