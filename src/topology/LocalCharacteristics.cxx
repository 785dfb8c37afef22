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
#include "topology/CellsToCompare.h"
#include "base/IndexBox.h"
#include "base/Parallel.h"
#include "topology/SampleCharacteristics.h"

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
  SimplexCounter(const CellsToCompare &      cells,
                 const std::vector<Vector> & points,
                 const TetrahedralMesh &     mesh,
                 Material                    exterior,
                 const Incidence &           stars,
                 CharacteristicSums &        sums)
    : m_Cells(cells)
    , m_Points(points)
    , m_Mesh(mesh)
    , m_Exterior(exterior)
    , m_Stars(stars)
    , m_Finder(cells.Blocks())
    , m_Sums(sums)
  {}

  void
  CountAt(std::uint32_t p)
  {
    if (!this->IsNearCells(p))
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
  IsNearCells(std::uint32_t p) const
  {
    Eigen::AlignedBox3d box(m_Points[p]);
    for (auto t = m_Stars.Begin(p); t != m_Stars.End(p); ++t)
    {
      box.extend(BoxOf(m_Mesh.tetrahedra[*t], m_Points));
    }
    return m_Cells.HasAny(m_Cells.Blocks().CellsOf(box));
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
    const auto hasAny = [this](int first, int last, int j, int k) { return m_Cells.HasAny(first, last, j, k); };
    m_Finder.Visit(hasAny, [&](const Index & cell) {
      const auto number = m_Cells.Blocks().Cells().Offset(cell);
      if (m_Cells.Has(number))
      {
        m_Sums.Add(number, material, weight);
      }
    });
  }

  const CellsToCompare &      m_Cells;
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
  SampleCounter(const CellsToCompare &   cells,
                const SampleLattice &    lattice,
                const SampledMaterials & partition,
                Material                 exterior,
                CharacteristicSums &     sums)
    : m_Cells(cells)
    , m_Lattice(lattice)
    , m_Partition(partition)
    , m_Exterior(exterior)
    , m_Sums(sums)
  {}

  void
  SubtractAt(std::size_t number)
  {
    if (!m_Cells.Has(number))
    {
      return;
    }
    const BlockComplex & blocks = m_Cells.Blocks();
    const Index          cell = blocks.Cells().IndexAt(number);
    const IndexBox       box{ blocks.FirstSample(cell), blocks.LastSample(cell) };
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
  const CellsToCompare &   m_Cells;
  const SampleLattice &    m_Lattice;
  const SampledMaterials & m_Partition;
  const Material           m_Exterior;
  CharacteristicSums &     m_Sums;
  std::vector<Material>    m_Samples;
};

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
CharacteristicsComparison::Compare(const std::vector<Vector> &  points,
                                   const TetrahedralMesh &      mesh,
                                   const TetrahedronAdjacency & adjacency)
{
  std::vector<Vector> places;
  places.reserve(points.size());
  for (const Vector & x : points)
  {
    places.push_back(m_Blocks.ToBlocks(x));
  }
  CellsToCompare cells(m_Blocks, m_Lattice, m_Partition);
  cells.Find(places, mesh, m_Exterior, adjacency.neighbours);

  const auto changes = m_Changes.Next(places, mesh);
  if (!changes)
  {
    m_Differences = this->CompareWithin(cells, places, mesh, adjacency.stars);
    return m_Differences;
  }
  std::vector<char> hasChanged(m_Blocks.Cells().NumberOfNodes(), 0);
  for (const auto & corners : *changes)
  {
    m_Blocks.CellsOf(BoxOf(corners, places)).Visit([&](const Index & cell) {
      hasChanged[m_Blocks.Cells().Offset(cell)] = 1;
    });
  }
  cells.KeepOnly(hasChanged);
  const auto isReplaced = [&](const LocalCharacteristic & entry) { return hasChanged[entry.cell] != 0; };
  m_Differences.erase(std::remove_if(m_Differences.begin(), m_Differences.end(), isReplaced), m_Differences.end());
  m_Differences =
    AddUp({ m_Differences, this->CompareWithin(cells, places, mesh, adjacency.stars) }, hasChanged.size());
  return m_Differences;
}

LocalCharacteristics
CharacteristicsComparison::CompareWithin(const CellsToCompare &      cells,
                                         const std::vector<Vector> & places,
                                         const TetrahedralMesh &     mesh,
                                         const Incidence &           stars) const
{
  constexpr std::size_t             PointsPerRange = 1024;
  constexpr std::size_t             CellsPerRange = 65536;
  const std::size_t                 numberOfCells = m_Blocks.Cells().NumberOfNodes();
  std::vector<LocalCharacteristics> lists;
  AddRanges(places.size(), PointsPerRange, lists, [&](std::size_t begin, std::size_t end, CharacteristicSums & sums) {
    SimplexCounter counter(cells, places, mesh, m_Exterior, stars, sums);
    for (std::size_t p = begin; p < end; ++p)
    {
      counter.CountAt(std::uint32_t(p));
    }
  });
  AddRanges(numberOfCells, CellsPerRange, lists, [&](auto begin, auto end, CharacteristicSums & sums) {
    SampleCounter counter(cells, m_Lattice, m_Partition, m_Exterior, sums);
    for (std::size_t n = begin; n < end; ++n)
    {
      counter.SubtractAt(n);
    }
  });
  return AddUp(lists, numberOfCells);
}
} // namespace mmm
