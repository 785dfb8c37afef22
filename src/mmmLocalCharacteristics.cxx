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
#include "mmmLocalCharacteristics.h"

#include "mmmBlockCellFinder.h"
#include "mmmHash.h"
#include "mmmIndexBox.h"
#include "mmmSampleCharacteristics.h"
#include "mmmTetrahedronNeighbours.h"
#include "mmmTetrahedronRaster.h"

#include <algorithm>
#include <initializer_list>

namespace mmm
{
namespace
{
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
    Vector lower = m_Points[p];
    Vector upper = m_Points[p];
    for (auto t = m_Stars.Begin(p); t != m_Stars.End(p); ++t)
    {
      for (const auto c : m_Mesh.tetrahedra[*t])
      {
        lower = lower.cwiseMin(m_Points[c]);
        upper = upper.cwiseMax(m_Points[c]);
      }
    }
    Index first;
    Index last;
    for (int a = 0; a < 3; ++a)
    {
      m_Blocks.CellsOf(a, lower[a], upper[a], first[a], last[a]);
    }
    return m_Blocks.HasKept(first, last);
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
        m_Sums.Add(m_Blocks.NumberOf(cell), material, weight);
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

/** Whether points are corners of faces with two materials, or with one tetrahedron. */
std::vector<char>
FindInterfacePoints(std::size_t numberOfPoints, const TetrahedralMesh & mesh)
{
  // each face and material is there once or twice, and what is there twice cancels out
  std::vector<std::uint64_t> sums(numberOfPoints, 0);
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
  {
    const auto &                 corners = mesh.tetrahedra[t];
    std::array<std::uint64_t, 4> hashes;
    std::transform(corners.begin(), corners.end(), hashes.begin(), [](std::uint32_t c) { return Hash(c); });
    const auto all = hashes[0] + hashes[1] + hashes[2] + hashes[3] + Hash(~std::uint64_t(mesh.materials[t]));
    for (int opposite = 0; opposite < 4; ++opposite)
    {
      for (int corner = 0; corner < 4; ++corner)
      {
        sums[corners[corner]] ^= corner == opposite ? 0 : Hash(all - hashes[opposite]);
      }
    }
  }
  std::vector<char> isThere(numberOfPoints);
  std::transform(sums.begin(), sums.end(), isThere.begin(), [](std::uint64_t sum) { return char(sum != 0); });
  return isThere;
}

/** Keeps the blocks of tetrahedra that may have a face on an interface. */
void
KeepInterfaces(const std::vector<Vector> & points, const TetrahedralMesh & mesh, BlockComplex & blocks)
{
  const auto isOnInterface = FindInterfacePoints(points.size(), mesh);
  for (const auto & corners : mesh.tetrahedra)
  {
    if (std::count_if(corners.begin(), corners.end(), [&](std::uint32_t c) { return isOnInterface[c] != 0; }) >= 3)
    {
      Vector lower = points[corners[0]];
      Vector upper = lower;
      for (const auto c : corners)
      {
        lower = lower.cwiseMin(points[c]);
        upper = upper.cwiseMax(points[c]);
      }
      blocks.Keep(lower, upper);
    }
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
  const Index           size{ { blocks.NumberOfBlocks(0), blocks.NumberOfBlocks(1), blocks.NumberOfBlocks(2) } };
  std::vector<Material> materials(std::size_t(size[0]) * size[1] * size[2], exterior);
  // a middle is inside of one tetrahedron at most: no two threads write to one place
  ParallelFor(mesh.tetrahedra.size(), Grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
    {
      std::array<Vector, 4> corners;
      for (int c = 0; c < 4; ++c)
      {
        corners[c] = points[mesh.tetrahedra[t][c]] - Vector::Constant(0.5);
      }
      VisitIndicesInside(size, corners, -1e-9, [&](const Index & at) {
        materials[(std::size_t(at[2]) * size[1] + at[1]) * size[0] + at[0]] = mesh.materials[t];
      });
    }
  });
  auto material = materials.begin();
  IndexBox{ { { 0, 0, 0 } }, { { size[0] - 1, size[1] - 1, size[2] - 1 } } }.Visit([&](const Index & at) {
    const Index cell{ { 2 * at[0], 2 * at[1], 2 * at[2] } };
    if (!blocks.IsKept(cell) && lattice.At(partition, blocks.FirstSample(cell)) != *material)
    {
      const Vector middle = Vector(at[0], at[1], at[2]) + Vector::Constant(0.5);
      blocks.Keep(middle, middle);
    }
    ++material;
  });
}
} // namespace

LocalCharacteristics
CompareCharacteristics(BlockComplex &              blocks,
                       const SampleLattice &       lattice,
                       const SampledMaterials &    partition,
                       const std::vector<Vector> & points,
                       const TetrahedralMesh &     mesh,
                       Material                    exterior)
{
  constexpr std::size_t             PointsPerRange = 8192;
  constexpr std::size_t             CellsPerRange = 65536;
  std::vector<LocalCharacteristics> lists;
  {
    std::vector<Vector> places;
    places.reserve(points.size());
    for (const Vector & x : points)
    {
      places.push_back(blocks.ToBlocks(x));
    }
    KeepInterfaces(places, mesh, blocks);
    KeepDiffering(places, mesh, exterior, lattice, partition, blocks);
    const Incidence stars = StarsOfPoints(mesh.tetrahedra, points.size());
    AddRanges(points.size(), PointsPerRange, lists, [&](std::size_t begin, std::size_t end, CharacteristicSums & sums) {
      SimplexCounter counter(blocks, places, mesh, exterior, stars, sums);
      for (std::size_t p = begin; p < end; ++p)
      {
        counter.CountAt(std::uint32_t(p));
      }
    });
  }
  AddRanges(
    blocks.NumberOfCells(), CellsPerRange, lists, [&](std::size_t begin, std::size_t end, CharacteristicSums & sums) {
      std::vector<Material> samples;
      for (std::size_t n = begin; n < end; ++n)
      {
        const Index cell = blocks.CellAt(n);
        if (!blocks.IsKept(cell))
        {
          continue;
        }
        const Index first = blocks.FirstSample(cell);
        const Index last = blocks.LastSample(cell);
        samples.clear();
        for (int k = first[2]; k <= last[2]; ++k)
        {
          for (int j = first[1]; j <= last[1]; ++j)
          {
            for (int i = first[0]; i <= last[0]; ++i)
            {
              samples.push_back(lattice.At(partition, { { i, j, k } }));
            }
          }
        }
        AddCharacteristicsOfSamples({ { last[0] - first[0] + 1, last[1] - first[1] + 1, last[2] - first[2] + 1 } },
                                    samples,
                                    [&](Material material, int count) {
                                      if (material != exterior)
                                      {
                                        sums.Add(n, material, -count);
                                      }
                                    });
      }
    });
  return AddUp(lists, blocks.NumberOfCells());
}
} // namespace mmm
