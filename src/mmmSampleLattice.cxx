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
#include "mmmSampleLattice.h"

#include "mmmParallel.h"

namespace mmm
{
namespace
{
constexpr std::uint32_t None = 0xffffffffu;
/** How far samples are off their places, in samples. */
const Vector Shift(-0.0031, -0.0047, -0.0023);

/** Whether the nodes from `lower` up to `upper`, as far as they are within the grid, are of one material. */
bool
IsUniform(const Grid & grid, const std::vector<Material> & materials, const Index & lower, const Index & upper)
{
  const Index first = grid.Clamp(lower);
  const Index last = grid.Clamp(upper);
  const auto  material = materials[grid.Offset(first)];
  for (int k = first[2]; k <= last[2]; ++k)
  {
    for (int j = first[1]; j <= last[1]; ++j)
    {
      for (int i = first[0]; i <= last[0]; ++i)
      {
        if (materials[grid.Offset(i, j, k)] != material)
        {
          return false;
        }
      }
    }
  }
  return true;
}
} // namespace

SampleLattice::SampleLattice(const IndicatorSet & indicators, int refinement)
  : m_Indicators(indicators)
  , m_Refinement(refinement)
  , m_Shift(refinement / 2)
  , m_SamplesPerVoxel(refinement * refinement * refinement)
{
  const Grid & grid = indicators.GetGrid();
  for (int a = 0; a < 3; ++a)
  {
    m_Size[a] = refinement * grid.size[a];
    m_Step[a] = grid.spacing[a] / refinement;
    m_Origin[a] = Shift[a] * m_Step[a];
  }
  std::vector<std::vector<std::size_t>> layers(grid.size[2]);
  ParallelFor(grid.size[2], 1, [&](std::size_t begin, std::size_t end) {
    for (int k = int(begin); k < int(end); ++k)
    {
      for (int j = 0; j < grid.size[1]; ++j)
      {
        for (int i = 0; i < grid.size[0]; ++i)
        {
          if (!IsUniform(grid, indicators.NodeMaterials(), { { i - 1, j - 1, k - 1 } }, { { i + 1, j + 1, k + 1 } }))
          {
            layers[k].push_back(grid.Offset(i, j, k));
          }
        }
      }
    }
  });
  m_Numbers.assign(grid.NumberOfNodes(), None);
  for (const auto & layer : layers)
  {
    for (const auto voxel : layer)
    {
      m_Numbers[voxel] = std::uint32_t(m_Voxels.size());
      m_Voxels.push_back(voxel);
    }
  }
}

std::size_t
SampleLattice::PlaceOf(const Index & sample) const
{
  const auto number = m_Numbers[this->VoxelOf(sample)];
  const int  within = m_Refinement - 1;
  return number == None
           ? NotKept
           : std::size_t(number) * m_SamplesPerVoxel +
               ((((sample[2] & within) << m_Shift) + (sample[1] & within)) << m_Shift) + (sample[0] & within);
}

Index
SampleLattice::SampleAt(std::size_t place) const
{
  const int   r = m_Refinement;
  const int   within = int(place % m_SamplesPerVoxel);
  const Index voxel = m_Indicators.GetGrid().IndexAt(m_Voxels[place / m_SamplesPerVoxel]);
  return { { r * voxel[0] + within % r, r * voxel[1] + within / r % r, r * voxel[2] + within / (r * r) } };
}

bool
SampleLattice::IsDecidedByNodes(const Index & sample) const
{
  Index lower;
  Index upper;
  for (int a = 0; a < 3; ++a)
  {
    lower[a] = sample[a] >> m_Shift;
    upper[a] = (sample[a] + m_Refinement - 1) >> m_Shift;
  }
  return IsUniform(m_Indicators.GetGrid(), m_Indicators.NodeMaterials(), lower, upper);
}

Material
SampleLattice::MaterialAt(const Vector & sample, Material exterior) const
{
  const Vector x = m_Origin + m_Step.cwiseProduct(sample);
  return this->IsBeyondBox(x) ? exterior : m_Indicators.MaterialAt(x);
}

SampledMaterials
SampleLattice::SamplePartition(Material exterior) const
{
  SampledMaterials materials(this->NumberOfKept());
  ParallelFor(materials.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t place = begin; place < end; ++place)
    {
      const Index  sample = this->SampleAt(place);
      const Vector x = this->Position(sample);
      materials[place] = this->IsBeyondBox(x)             ? exterior
                         : this->IsDecidedByNodes(sample) ? m_Indicators.MaterialAtNode(this->VoxelOf(sample))
                                                          : m_Indicators.MaterialAt(x);
    }
  });
  return materials;
}
} // namespace mmm
