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
#include "topology/CellsToCompare.h"

#include "base/ParallelCollect.h"
#include "mesh/InterfaceMesh.h"
#include "mesh/TetrahedronRaster.h"
#include "topology/BlockCellFinder.h"

namespace mmm
{
void
CellsToCompare::Find(const std::vector<Vector> &   places,
                     const TetrahedralMesh &       mesh,
                     Material                      exterior,
                     const TetrahedronNeighbours & neighbours)
{
  this->FindMixed(exterior);
  this->FindOthers(places, mesh);
  this->FindMet(places, ExtractInterfaces(mesh, neighbours, exterior).triangles);
}

void
CellsToCompare::KeepOnly(const std::vector<char> & hasChanged)
{
  for (std::size_t n = 0; n < m_States.size(); ++n)
  {
    m_States[n] = hasChanged[n] ? m_States[n] : char(Same);
  }
}

void
CellsToCompare::FindMixed(Material exterior)
{
  constexpr std::size_t Grain = 16384;
  // a block is a voxel; with it go the planes in front of it
  ParallelFor(m_Blocks.Blocks().NumberOfNodes(), Grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      const auto [i, j, k] = m_Blocks.Blocks().IndexAt(n);
      const Index    last{ { 2 * i, 2 * j, 2 * k } };
      const IndexBox cells{ { { std::max(0, last[0] - 1), std::max(0, last[1] - 1), std::max(0, last[2] - 1) } },
                            last };
      const bool     isKept = m_Lattice.IsKept(n);
      const State    alike = this->MaterialOf(last) != exterior ? Other : Same;
      cells.Visit([&](const Index & cell) {
        const State ofCell = !isKept                              ? alike
                             : this->IsMixed(cell)                ? Met
                             : this->MaterialOf(cell) != exterior ? Other
                                                                  : Same;
        m_States[m_Blocks.Cells().Offset(cell)] = char(ofCell);
      });
    }
  });
}

bool
CellsToCompare::IsMixed(const Index & cell) const
{
  const Index    first = m_Blocks.FirstSample(cell);
  const Index    last = m_Blocks.LastSample(cell);
  const Material material = this->MaterialOf(cell);
  for (int k = first[2]; k <= last[2]; ++k)
  {
    for (int j = first[1]; j <= last[1]; ++j)
    {
      for (int i = first[0]; i <= last[0]; ++i)
      {
        if (m_Lattice.At(m_Partition, { { i, j, k } }) != material)
        {
          return true;
        }
      }
    }
  }
  return false;
}

void
CellsToCompare::FindOthers(const std::vector<Vector> & places, const TetrahedralMesh & mesh)
{
  constexpr std::size_t Grain = 1024;
  // a middle is inside of one tetrahedron at most: no two threads write to one place
  ParallelFor(mesh.tetrahedra.size(), Grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
    {
      std::array<Vector, 4> corners;
      for (int c = 0; c < 4; ++c)
      {
        corners[c] = 2.0 * places[mesh.tetrahedra[t][c]] - Vector::Ones(); // by the numbers of cells
      }
      VisitIndicesInside(m_Blocks.Cells().size, corners, -1e-9, [&](const Index & cell) {
        char & state = m_States[m_Blocks.Cells().Offset(cell)];
        if (state != Met)
        {
          state = this->MaterialOf(cell) != mesh.materials[t] ? Other : Same;
        }
      });
    }
  });
}

void
CellsToCompare::FindMet(const std::vector<Vector> & places, const std::vector<Triangle> & triangles)
{
  constexpr std::size_t Grain = 4096;
  const auto            all = [](int, int, int, int) { return true; };
  for (const auto n : ParallelCollect<std::size_t>(triangles.size(), Grain, [&](std::size_t t, auto & met) {
         BlockCellFinder finder(m_Blocks);
         for (const auto corner : triangles[t])
         {
           finder.Corners().push_back(places[corner]);
         }
         finder.Visit(all, [&](const Index & cell) {
           const auto number = m_Blocks.Cells().Offset(cell);
           if (m_States[number] != Met)
           {
             met.push_back(number);
           }
         });
       }))
  {
    m_States[n] = Met;
  }
}
} // namespace mmm
