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
#include "mmmTetrahedronRaster.h"

#include <algorithm>
#include <atomic>
#include <cmath>

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

bool
SampleLattice::IsBeyondBox(const Index & sample) const
{
  const Grid & grid = m_Indicators.GetGrid();
  const Vector x = this->Position(sample);
  return x[0] > grid.UpperFace(0) || x[1] > grid.UpperFace(1) || x[2] > grid.UpperFace(2);
}

SampledMaterials
SampleLattice::SamplePartition(Material exterior) const
{
  SampledMaterials materials(this->NumberOfKept());
  ParallelFor(materials.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t place = begin; place < end; ++place)
    {
      const Index sample = this->SampleAt(place);
      materials[place] = this->IsBeyondBox(sample)        ? exterior
                         : this->IsDecidedByNodes(sample) ? m_Indicators.MaterialAtNode(this->VoxelOf(sample))
                                                          : m_Indicators.MaterialAt(this->Position(sample));
    }
  });
  return materials;
}

bool
SampleLattice::HasMarked(const std::vector<char> & marks, const std::array<Vector, 4> & corners, double reach) const
{
  // beyond that, looking costs more than it saves
  constexpr int Most = 64;
  const Grid &  grid = m_Indicators.GetGrid();
  Index         lower;
  Index         upper;
  int           count = 1;
  for (int a = 0; a < 3; ++a)
  {
    const auto coordinates = { corners[0][a], corners[1][a], corners[2][a], corners[3][a] };
    lower[a] = std::max(0, int(std::floor((std::min(coordinates) - reach) / m_Refinement)));
    upper[a] = std::min(grid.size[a] - 1, int(std::floor((std::max(coordinates) + reach) / m_Refinement)));
    count *= std::min(Most, std::max(0, upper[a] - lower[a] + 1));
  }
  if (count > Most)
  {
    return true;
  }
  for (int k = lower[2]; k <= upper[2]; ++k)
  {
    for (int j = lower[1]; j <= upper[1]; ++j)
    {
      for (int i = lower[0]; i <= upper[0]; ++i)
      {
        const auto number = m_Numbers[grid.Offset(i, j, k)];
        if (number != None && marks[number])
        {
          return true;
        }
      }
    }
  }
  return false;
}

template <typename TVisitor>
void
SampleLattice::VisitSamplesInside(const std::vector<Vector> & points,
                                  const TetrahedralMesh &     mesh,
                                  double                      reach,
                                  const std::vector<char> &   marks,
                                  const TVisitor &            visit) const
{
  ParallelFor(mesh.tetrahedra.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
    {
      std::array<Vector, 4> corners;
      for (int c = 0; c < 4; ++c)
      {
        corners[c] = (points[mesh.tetrahedra[t][c]] - m_Origin).cwiseQuotient(m_Step);
      }
      if (!this->HasMarked(marks, corners, reach))
      {
        continue;
      }
      VisitIndicesInside(m_Size, corners, reach, [&](const Index & sample) {
        const auto place = this->PlaceOf(sample);
        if (place != NotKept)
        {
          visit(t, place);
        }
      });
    }
  });
}

SampledMaterials
SampleLattice::SampleMesh(const std::vector<Vector> & points,
                          const TetrahedralMesh &     mesh,
                          Material                    exterior,
                          const SampledMaterials &    wanted,
                          double                      tolerance) const
{
  SampledMaterials  materials(this->NumberOfKept(), exterior);
  std::vector<char> marks(m_Voxels.size(), 1);
  // a sample is inside of one tetrahedron at most: no two threads write to one place
  this->VisitSamplesInside(
    points, mesh, -1e-9, marks, [&](std::size_t t, std::size_t place) { materials[place] = mesh.materials[t]; });

  std::fill(marks.begin(), marks.end(), 0);
  for (std::size_t place = 0; place < materials.size(); ++place)
  {
    marks[place / m_SamplesPerVoxel] |= char(materials[place] != wanted[place]);
  }
  std::vector<std::atomic<bool>> isNear(materials.size());
  this->VisitSamplesInside(points, mesh, tolerance * m_Refinement, marks, [&](std::size_t t, std::size_t place) {
    if (mesh.materials[t] == wanted[place] && materials[place] != wanted[place])
    {
      isNear[place].store(true, std::memory_order_relaxed);
    }
  });
  for (std::size_t place = 0; place < materials.size(); ++place)
  {
    if (isNear[place])
    {
      materials[place] = wanted[place];
    }
  }
  return materials;
}
} // namespace mmm
