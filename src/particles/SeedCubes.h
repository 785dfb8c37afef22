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
#ifndef mmmSeedCubes_h
#define mmmSeedCubes_h

#include "indicators/SampleLattice.h"

#include <algorithm>

namespace mmm
{
/** \brief Cubes between the places of a lattice, with the materials at their corners: what seeds start from.
 *
 * A cube goes by its lowest place. Cubes reach one place beyond the border, where the planes are. */
class SeedCubes
{
public:
  /** A material a corner, and the planes. */
  static constexpr int MostMaterials = 8 + BoxPlanes::Count;

  explicit SeedCubes(const IndicatorSet & indicators)
    : m_Indicators(indicators)
  {}
  virtual ~SeedCubes() = default;

  const IndicatorSet &
  GetIndicators() const
  {
    return m_Indicators;
  }
  /** Where a place is, and the middle of a cube. */
  virtual Vector
  Position(const Index & place) const = 0;
  virtual Vector
  Middle(const Index & cube) const = 0;
  /** Writes the materials at a cube's corners, each once, ascending, and returns how many there are. */
  virtual int
  ListMaterials(const Index & cube, Material * materials) const = 0;

protected:
  static Index
  Corner(const Index & cube, int number)
  {
    return { { cube[0] + (number & 1), cube[1] + ((number >> 1) & 1), cube[2] + (number >> 2) } };
  }
  static void
  Add(Material material, Material * materials, int & count)
  {
    Material * const end = materials + count;
    Material * const at = std::lower_bound(materials, end, material);
    if (at == end || *at != material)
    {
      std::copy_backward(at, end, end + 1);
      *at = material;
      ++count;
    }
  }
  /** What lies beyond the border stands for all the planes that it lies behind. `sideOf(axis)` tells on which side of
   * the box it is: below (-1), within, or above (1). Returns whether there is a plane. */
  template <typename TSideOf>
  bool
  AddPlanes(const TSideOf & sideOf, Material * materials, int & count) const
  {
    bool isBeyond = false;
    for (int a = 0; a < 3; ++a)
    {
      const int side = sideOf(a);
      if (side != 0)
      {
        Add(m_Indicators.Planes().At(2 * a + (side < 0 ? 0 : 1)), materials, count);
        isBeyond = true;
      }
    }
    return isBeyond;
  }

private:
  const IndicatorSet & m_Indicators;
};

/** Between the nodes of the grid. */
class NodeCubes : public SeedCubes
{
public:
  using SeedCubes::SeedCubes;

  Vector
  Position(const Index & node) const override
  {
    return this->GetIndicators().GetGrid().Position(node);
  }
  Vector
  Middle(const Index & cube) const override
  {
    return (Vector(cube[0], cube[1], cube[2]) + Vector::Constant(0.5))
      .cwiseProduct(this->GetIndicators().GetGrid().spacing);
  }
  int
  ListMaterials(const Index & cube, Material * materials) const override
  {
    const Grid & grid = this->GetIndicators().GetGrid();
    int          count = 0;
    for (int corner = 0; corner < 8; ++corner)
    {
      const Index node = Corner(cube, corner);
      const auto  sideOf = [&](int a) { return node[a] < 0 ? -1 : int(node[a] >= grid.size[a]); };
      if (!this->AddPlanes(sideOf, materials, count))
      {
        Add(this->GetIndicators().MaterialAtNode(grid.Offset(node)), materials, count);
      }
    }
    return count;
  }
};

/** Between the samples of a partition. */
class SampleCubes : public SeedCubes
{
public:
  /** Both have to stay. */
  SampleCubes(const SampleLattice & lattice, const SampledMaterials & partition)
    : SeedCubes(lattice.GetIndicators())
    , m_Lattice(lattice)
    , m_Partition(partition)
  {}

  Vector
  Position(const Index & sample) const override
  {
    return m_Lattice.Position(sample);
  }
  Vector
  Middle(const Index & cube) const override
  {
    Vector middle = Vector::Zero();
    for (int corner = 0; corner < 8; ++corner)
    {
      middle += 0.125 * m_Lattice.Position(Corner(cube, corner));
    }
    return middle;
  }
  int
  ListMaterials(const Index & cube, Material * materials) const override
  {
    int count = 0;
    for (int corner = 0; corner < 8; ++corner)
    {
      const Index sample = Corner(cube, corner);
      if (!this->AddPlanes([&](int a) { return m_Lattice.SideOf(a, sample[a]); }, materials, count))
      {
        Add(m_Lattice.At(m_Partition, sample), materials, count);
      }
    }
    return count;
  }

private:
  const SampleLattice &    m_Lattice;
  const SampledMaterials & m_Partition;
};
} // namespace mmm

#endif
