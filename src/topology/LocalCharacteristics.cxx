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
#include "topology/LocalCharacteristics.h"

#include "topology/BlockCellFinder.h"
#include "base/IndexBox.h"
#include "mesh/InterfaceMesh.h"
#include "base/Parallel.h"
#include "topology/SampleCharacteristics.h"
#include "mesh/TetrahedronNeighbours.h"
#include "mesh/TetrahedronRaster.h"

#include <algorithm>
#include <initializer_list>

namespace mmm
{
namespace
{
template <typename TCorners>
Eigen::AlignedBox3d
BoxOf(const TCorners & corners, const std::vector<Vector> & points)
{
  Eigen::AlignedBox3d box;
  for (const auto c : corners)
  {
    box.extend(points[c]);
  }
  return box;
}

/** Adds up the simplices of a mesh, each at its smallest point. */
class SimplexCounter
{
public:
  SimplexCounter(const BlockComplex &        blocks,
                 const std::vector<Vector> & points,
                 const TetrahedralMesh &     mesh,
                 Material                    exterior,
                 const Incidence &           stars,
                 CharacteristicSums &        sums)
    : m_Blocks(blocks)
    , m_Points(points)
    , m_Mesh(mesh)
    , m_Exterior(exterior)
    , m_Stars(stars)
    , m_Finder(blocks)
    , m_Sums(sums)
  {}

  void
  CountAt(std::uint32_t p)
  {
    if (!this->IsNearKept(p))
    {
      return;
    }
    m_Wedges.clear();
    for (auto t = m_Stars.Begin(p); t != m_Stars.End(p); ++t)
    {
      const Material material = m_Mesh.materials[*t];
      if (material == m_Exterior)
      {
        continue;
      }
      const auto & corners = m_Mesh.tetrahedra[*t];
      if (*std::min_element(corners.begin(), corners.end()) == p)
      {
        this->Add({ corners[0], corners[1], corners[2], corners[3] }, material, 1);
      }
      for (const auto b : corners)
      {
        for (const auto c : corners)
        {
          if (b != p && c != p && b != c)
          {
            m_Wedges.push_back({ material, b, c });
          }
        }
      }
    }
    std::sort(m_Wedges.begin(), m_Wedges.end());
    for (auto wedge = m_Wedges.cbegin(); wedge != m_Wedges.cend();)
    {
      wedge = this->CountMaterial(p, wedge);
    }
  }

private:
  /** A tetrahedron at a point, by two of its other corners: listed six times. */
  struct Wedge
  {
    Material      material;
    std::uint32_t second;
    std::uint32_t third;

    bool
    operator<(const Wedge & other) const
    {
      return material != other.material ? material < other.material
             : second != other.second   ? second < other.second
                                        : third < other.third;
    }
  };
  using WedgeIterator = std::vector<Wedge>::const_iterator;

  bool
  IsNearKept(std::uint32_t p) const
  {
    Eigen::AlignedBox3d box(m_Points[p]);
    for (auto t = m_Stars.Begin(p); t != m_Stars.End(p); ++t)
    {
      box.extend(BoxOf(m_Mesh.tetrahedra[*t], m_Points));
    }
    return m_Blocks.HasKept(m_Blocks.CellsOf(box));
  }

  /** Adds the point, its edges and its faces in a material. Returns where the wedges of the next one begin. */
  WedgeIterator
  CountMaterial(std::uint32_t p, WedgeIterator wedge)
  {
    const Material material = wedge->material;
    int            edges = 0;
    int            faces = 0;      // each twice
    int            tetrahedra = 0; // each six times
    while (wedge != m_Wedges.cend() && wedge->material == material)
    {
      const auto second = wedge->second;
      int        facesHere = 0;
      int        tetrahedraHere = 0; // each twice
      while (wedge != m_Wedges.cend() && wedge->material == material && wedge->second == second)
      {
        const auto third = wedge->third;
        int        atFace = 0;
        for (; wedge != m_Wedges.cend() && wedge->material == material && wedge->second == second &&
               wedge->third == third;
             ++wedge)
        {
          ++atFace;
        }
        if (p < second && second < third)
        {
          this->Add({ p, second, third }, material, 1 - atFace);
        }
        ++facesHere;
        tetrahedraHere += atFace;
      }
      if (p < second)
      {
        this->Add({ p, second }, material, 1 - facesHere + tetrahedraHere / 2);
      }
      ++edges;
      faces += facesHere;
      tetrahedra += tetrahedraHere;
    }
    this->Add({ p }, material, 1 - edges + faces / 2 - tetrahedra / 6);
    return wedge;
  }

  void
  Add(std::initializer_list<std::uint32_t> corners, Material material, int weight)
  {
    if (weight == 0)
    {
      return;
    }
    m_Finder.Corners().clear();
    for (const auto c : corners)
    {
      m_Finder.Corners().push_back(m_Points[c]);
    }
    m_Finder.Visit([&](const Index & cell) {
      if (m_Blocks.IsKept(cell))
      {
        m_Sums.Add(m_Blocks.Cells().Offset(cell), material, weight);
      }
    });
  }

  const BlockComplex &        m_Blocks;
  const std::vector<Vector> & m_Points;
  const TetrahedralMesh &     m_Mesh;
  const Material              m_Exterior;
  const Incidence &           m_Stars;
  BlockCellFinder             m_Finder;
  CharacteristicSums &        m_Sums;
  std::vector<Wedge>          m_Wedges;
};

/** Subtracts what the samples of a partition span in cells. */
class SampleCounter
{
public:
  SampleCounter(const BlockComplex &     blocks,
                const SampleLattice &    lattice,
                const SampledMaterials & partition,
                Material                 exterior,
                CharacteristicSums &     sums)
    : m_Blocks(blocks)
    , m_Lattice(lattice)
    , m_Partition(partition)
    , m_Exterior(exterior)
    , m_Sums(sums)
  {}

  void
  SubtractAt(std::size_t number)
  {
    const Index cell = m_Blocks.Cells().IndexAt(number);
    if (!m_Blocks.IsKept(cell))
    {
      return;
    }
    const IndexBox box{ m_Blocks.FirstSample(cell), m_Blocks.LastSample(cell) };
    m_Samples.clear();
    box.Visit([&](const Index & sample) { m_Samples.push_back(m_Lattice.At(m_Partition, sample)); });
    AddCharacteristicsOfSamples(box.Size(), m_Samples, [&](Material material, int count) {
      if (material != m_Exterior)
      {
        m_Sums.Add(number, material, -count);
      }
    });
  }

private:
  const BlockComplex &     m_Blocks;
  const SampleLattice &    m_Lattice;
  const SampledMaterials & m_Partition;
  const Material           m_Exterior;
  CharacteristicSums &     m_Sums;
  std::vector<Material>    m_Samples;
};

/** Keeps the blocks that interfaces of the mesh come to. */
void
KeepInterfaces(const std::vector<Vector> & points,
               const TetrahedralMesh &     mesh,
               Material                    exterior,
               const Incidence &           stars,
               BlockComplex &              blocks)
{
  const auto neighbours = ComputeTetrahedronNeighbours(mesh.tetrahedra, points.size(), stars);
  for (const auto & corners : ExtractInterfaces(mesh, neighbours, exterior).triangles)
  {
    blocks.KeepAround(BoxOf(corners, points));
  }
}

/** Keeps the blocks without interfaces in which mesh and partition are of different materials. */
void
KeepDiffering(const std::vector<Vector> & points,
              const TetrahedralMesh &     mesh,
              Material                    exterior,
              const SampleLattice &       lattice,
              const SampledMaterials &    partition,
              BlockComplex &              blocks)
{
  constexpr std::size_t Grain = 1024;
  std::vector<Material> materials(blocks.Blocks().NumberOfNodes(), exterior);
  // a middle is inside of one tetrahedron at most: no two threads write to one place
  ParallelFor(mesh.tetrahedra.size(), Grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
    {
      std::array<Vector, 4> corners;
      for (int c = 0; c < 4; ++c)
      {
        corners[c] = points[mesh.tetrahedra[t][c]] - Vector::Constant(0.5);
      }
      VisitIndicesInside(blocks.Blocks().size, corners, -1e-9, [&](const Index & block) {
        materials[blocks.Blocks().Offset(block)] = mesh.materials[t];
      });
    }
  });
  for (std::size_t n = 0; n < materials.size(); ++n)
  {
    const Index block = blocks.Blocks().IndexAt(n);
    const Index cell{ { 2 * block[0], 2 * block[1], 2 * block[2] } };
    if (!blocks.IsKept(cell) && lattice.At(partition, blocks.FirstSample(cell)) != materials[n])
    {
      blocks.Keep({ block, block });
    }
  }
}
} // namespace

CharacteristicsComparison::CharacteristicsComparison(const SampleLattice &    lattice,
                                                     const SampledMaterials & partition,
                                                     Material                 exterior,
                                                     int                      samplesPerBlock)
  : m_Lattice(lattice)
  , m_Partition(partition)
  , m_Exterior(exterior)
  , m_Blocks(lattice, samplesPerBlock)
{}

const LocalCharacteristics &
CharacteristicsComparison::Compare(const std::vector<Vector> & points, const TetrahedralMesh & mesh)
{
  std::vector<Vector> places;
  places.reserve(points.size());
  for (const Vector & x : points)
  {
    places.push_back(m_Blocks.ToBlocks(x));
  }
  const Incidence stars = StarsOfPoints(mesh.tetrahedra, points.size());
  KeepInterfaces(places, mesh, m_Exterior, stars, m_Blocks);
  KeepDiffering(places, mesh, m_Exterior, m_Lattice, m_Partition, m_Blocks);

  const auto changes = m_Changes.Next(places, mesh);
  if (!changes)
  {
    m_Differences = this->CompareWithin(m_Blocks, places, mesh, stars);
    return m_Differences;
  }
  BlockComplex blocks = m_Blocks.WithoutKept();
  for (const auto & corners : *changes)
  {
    blocks.KeepAround(BoxOf(corners, places));
  }
  blocks.KeepOnlyOf(m_Blocks);
  const auto isReplaced = [&](const LocalCharacteristic & entry) {
    return blocks.IsKept(blocks.Cells().IndexAt(entry.cell));
  };
  m_Differences.erase(std::remove_if(m_Differences.begin(), m_Differences.end(), isReplaced), m_Differences.end());
  m_Differences =
    AddUp({ m_Differences, this->CompareWithin(blocks, places, mesh, stars) }, blocks.Cells().NumberOfNodes());
  return m_Differences;
}

LocalCharacteristics
CharacteristicsComparison::CompareWithin(const BlockComplex &        blocks,
                                         const std::vector<Vector> & places,
                                         const TetrahedralMesh &     mesh,
                                         const Incidence &           stars) const
{
  constexpr std::size_t             PointsPerRange = 1024;
  constexpr std::size_t             CellsPerRange = 65536;
  std::vector<LocalCharacteristics> lists;
  AddRanges(places.size(), PointsPerRange, lists, [&](std::size_t begin, std::size_t end, CharacteristicSums & sums) {
    SimplexCounter counter(blocks, places, mesh, m_Exterior, stars, sums);
    for (std::size_t p = begin; p < end; ++p)
    {
      counter.CountAt(std::uint32_t(p));
    }
  });
  AddRanges(blocks.Cells().NumberOfNodes(), CellsPerRange, lists, [&](auto begin, auto end, CharacteristicSums & sums) {
    SampleCounter counter(blocks, m_Lattice, m_Partition, m_Exterior, sums);
    for (std::size_t n = begin; n < end; ++n)
    {
      counter.SubtractAt(n);
    }
  });
  return AddUp(lists, blocks.Cells().NumberOfNodes());
}
} // namespace mmm
