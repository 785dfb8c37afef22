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
#include "indicators/SampleLattice.h"

#include "base/ParallelCollect.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
constexpr std::size_t VoxelsPerRange = 65536;
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

/** Where a line from a, which is in the box, to b, which is beyond upper faces, leaves the box. */
Vector
CutAtBox(const Grid & grid, const Vector & a, const Vector & b)
{
  const Vector upper(grid.UpperFace(0), grid.UpperFace(1), grid.UpperFace(2));
  double       share = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (b[axis] > upper[axis])
    {
      share = std::min(share, (upper[axis] - a[axis]) / (b[axis] - a[axis]));
    }
  }
  return (a + share * (b - a)).cwiseMin(upper);
}

/** Where the indicators of two materials are equal between a, at which the first one is larger, and b: by the method of
 * false position, where an end that stays counts half (the Illinois algorithm). */
Vector
PlaceOfEquality(const IndicatorSet & indicators, Material first, Material last, Vector a, Vector b)
{
  constexpr int    MostSteps = 16;
  constexpr double Accuracy = 1e-5;
  double           atA = indicators.Difference(first, last, a);
  double           atB = indicators.Difference(first, last, b);
  int              side = 0;
  Vector           x = a;
  for (int step = 0; step < MostSteps && atA > atB; ++step)
  {
    x = a + atA / (atA - atB) * (b - a);
    const double atX = indicators.Difference(first, last, x);
    if (std::abs(atX) < Accuracy)
    {
      break;
    }
    if (atX > 0.0)
    {
      a = x;
      atA = atX;
      atB *= side > 0 ? 0.5 : 1.0;
      side = 1;
    }
    else
    {
      b = x;
      atB = atX;
      atA *= side < 0 ? 0.5 : 1.0;
      side = -1;
    }
  }
  return x;
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
  m_Voxels = ParallelCollect<std::size_t>(
    grid.NumberOfNodes(), VoxelsPerRange, [&](std::size_t n, std::vector<std::size_t> & kept) {
      const auto [i, j, k] = grid.IndexAt(n);
      if (!IsUniform(grid, indicators.NodeMaterials(), { { i - 1, j - 1, k - 1 } }, { { i + 1, j + 1, k + 1 } }))
      {
        kept.push_back(n);
      }
    });
  m_Numbers.assign(grid.NumberOfNodes(), NotNumbered);
  for (std::size_t v = 0; v < m_Voxels.size(); ++v)
  {
    m_Numbers[m_Voxels[v]] = std::uint32_t(v);
  }
}

Index
SampleLattice::NearestTo(const Vector & x) const
{
  Index sample;
  for (int a = 0; a < 3; ++a)
  {
    sample[a] = std::clamp(int(std::lround((x[a] - m_Origin[a]) / m_Step[a])), 0, m_Size[a] - 1);
  }
  return sample;
}

std::size_t
SampleLattice::PlaceOf(const Index & sample) const
{
  const auto number = m_Numbers[this->VoxelOf(sample)];
  const int  within = m_Refinement - 1;
  return number == NotNumbered
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
  const Vector x = this->Position(sample);
  return this->IsBeyondBox(x) ? exterior : m_Indicators.MaterialAt(x);
}

Material
SampleLattice::MaterialBetween(const Vector & begin, const Vector & end, Material first, Material last) const
{
  const Vector a = this->Position(begin);
  const Vector b = this->Position(end);
  const Grid & grid = m_Indicators.GetGrid();
  return m_Indicators.MaterialAt(this->IsBeyondBox(a)   ? CutAtBox(grid, b, a)
                                 : this->IsBeyondBox(b) ? CutAtBox(grid, a, b)
                                                        : PlaceOfEquality(m_Indicators, first, last, a, b));
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
