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
#include "output/SecondOrder.h"

#include "output/TenNodeTetrahedronCell.h"

#include "itkQuadraticTriangleCell.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace mmm
{
namespace
{
/** The lower end first. */
using Edge = std::pair<itk::IdentifierType, itk::IdentifierType>;

/** In VTK's order of mid-nodes; the first three are those of a triangle. */
constexpr int EdgesOfCell[6][2] = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 1, 3 }, { 2, 3 } };

/** Calls visit(place among EdgesOfCell, edge) for each edge of a triangle or a tetrahedron. */
template <typename TCell, typename TVisitor>
void
VisitEdges(const TCell & cell, const TVisitor & visit)
{
  const auto * corners = cell.PointIdsBegin();
  const int    count = cell.GetDimension() == 3 ? 6 : 3;
  for (int e = 0; e < count; ++e)
  {
    const auto ends = std::minmax(corners[EdgesOfCell[e][0]], corners[EdgesOfCell[e][1]]);
    visit(e, Edge(ends.first, ends.second));
  }
}

/** Calls visit(cell) for each cell. */
template <typename TMesh, typename TVisitor>
void
VisitCells(const TMesh * mesh, const TVisitor & visit)
{
  for (auto cell = mesh->GetCells()->Begin(); cell != mesh->GetCells()->End(); ++cell)
  {
    visit(std::as_const(*cell.Value()));
  }
}

template <typename TMesh>
void
VerifyCells(const TMesh * mesh)
{
  VisitCells(mesh, [&](const typename TMesh::CellType & cell) {
    if (cell.GetType() != itk::CellGeometryEnum::TRIANGLE_CELL &&
        cell.GetType() != itk::CellGeometryEnum::TETRAHEDRON_CELL)
    {
      itkGenericExceptionMacro("There is no second order of a " << cell.GetType()
                                                                << ": cells have to be triangles and tetrahedra.");
    }
    if (*std::max_element(cell.PointIdsBegin(), cell.PointIdsEnd()) >= mesh->GetNumberOfPoints())
    {
      itkGenericExceptionMacro("A cell has a point that is not one of the mesh's " << mesh->GetNumberOfPoints() << '.');
    }
  });
}

/** The edges of a mesh, each once, by their lower ends. */
class MeshEdges
{
public:
  template <typename TMesh>
  explicit MeshEdges(const TMesh * mesh)
    : m_First(mesh->GetNumberOfPoints() + 1, 0)
  {
    const auto visitEdges = [mesh](const auto & visit) {
      VisitCells(mesh, [&](const auto & cell) { VisitEdges(cell, [&](int, const Edge & edge) { visit(edge); }); });
    };
    visitEdges([&](const Edge & edge) { ++m_First[edge.first + 1]; });
    for (std::size_t p = 1; p < m_First.size(); ++p)
    {
      m_First[p] += m_First[p - 1];
    }
    m_Higher.resize(m_First.back());
    auto next = m_First;
    visitEdges([&](const Edge & edge) { m_Higher[next[edge.first]++] = edge.second; });
    this->DropRepetitions();
  }

  std::size_t
  Size() const
  {
    return m_Higher.size();
  }

  /** The place of an edge; Size() if it is not there. */
  std::size_t
  Find(const Edge & edge) const
  {
    if (edge.first + 1 >= m_First.size())
    {
      return this->Size();
    }
    const auto begin = m_Higher.begin() + m_First[edge.first];
    const auto end = m_Higher.begin() + m_First[edge.first + 1];
    const auto found = std::lower_bound(begin, end, edge.second);
    return found != end && *found == edge.second ? found - m_Higher.begin() : this->Size();
  }

  /** Calls visit(place, edge) for each. */
  template <typename TVisitor>
  void
  Visit(const TVisitor & visit) const
  {
    for (std::size_t p = 0; p + 1 < m_First.size(); ++p)
    {
      for (auto e = m_First[p]; e < m_First[p + 1]; ++e)
      {
        visit(e, Edge(p, m_Higher[e]));
      }
    }
  }

private:
  void
  DropRepetitions()
  {
    auto        kept = m_Higher.begin();
    std::size_t begin = 0;
    for (std::size_t p = 0; p + 1 < m_First.size(); ++p)
    {
      const auto first = m_Higher.begin() + begin;
      const auto last = m_Higher.begin() + m_First[p + 1];
      begin = m_First[p + 1];
      std::sort(first, last);
      auto previous = itk::NumericTraits<itk::IdentifierType>::max();
      for (auto e = first; e != last; ++e)
      {
        if (*e != previous)
        {
          previous = *e;
          *kept++ = previous;
        }
      }
      m_First[p + 1] = kept - m_Higher.begin();
    }
    m_Higher.erase(kept, m_Higher.end());
  }

  /** Of each point, where the edges begin whose lower end it is. */
  std::vector<std::size_t>         m_First;
  std::vector<itk::IdentifierType> m_Higher;
};

/** The points of the mesh, and those of the edges. */
template <typename TMesh>
typename TMesh::PointsContainer::Pointer
MakePoints(const TMesh * mesh, const MeshEdges & edges, const itk::LabelMidNodeMesh * midNodes)
{
  const auto container = TMesh::PointsContainer::New();
  auto &     points = container->CastToSTLContainer();
  points = mesh->GetPoints()->CastToSTLConstContainer();
  const std::size_t first = points.size();
  points.resize(first + edges.Size());
  edges.Visit([&](std::size_t e, const Edge & edge) {
    points[first + e].SetToMidPoint(points[edge.first], points[edge.second]);
  });
  for (std::size_t n = 0; n < midNodes->GetNumberOfPoints(); ++n)
  {
    const auto &      ends = midNodes->GetPointData()->ElementAt(n);
    const std::size_t place = edges.Find(Edge(ends[0], ends[1]));
    if (place == edges.Size())
    {
      itkGenericExceptionMacro("No cell has the edge from point " << ends[0] << " to point " << ends[1]
                                                                  << " of mid-node " << n
                                                                  << ": the mid-nodes are those of another mesh.");
    }
    points[first + place] = midNodes->GetPoints()->ElementAt(n);
  }
  return container;
}

/** `straight` with its mid-nodes, which follow `firstMidNode` points. */
template <typename TCell>
TCell *
MakeCell(const TCell & straight, const MeshEdges & edges, std::size_t firstMidNode)
{
  const bool isTriangle = straight.GetDimension() == 2;
  const int  corners = isTriangle ? 3 : 4;
  TCell *    cell =
    isTriangle ? static_cast<TCell *>(new itk::QuadraticTriangleCell<TCell>) : new TenNodeTetrahedronCell<TCell>;
  for (int corner = 0; corner < corners; ++corner)
  {
    cell->SetPointId(corner, straight.PointIdsBegin()[corner]);
  }
  VisitEdges(straight,
             [&](int e, const Edge & edge) { cell->SetPointId(corners + e, firstMidNode + edges.Find(edge)); });
  return cell;
}
} // namespace

template <typename TMesh>
typename TMesh::Pointer
MakeSecondOrder(const TMesh * mesh, const itk::LabelMidNodeMesh * midNodes)
{
  VerifyCells(mesh);
  const MeshEdges edges(mesh);
  const auto      cells = TMesh::CellsContainer::New();
  cells->CastToSTLContainer().reserve(mesh->GetNumberOfCells());
  VisitCells(mesh, [&](const typename TMesh::CellType & cell) {
    cells->CastToSTLContainer().push_back(MakeCell(cell, edges, mesh->GetNumberOfPoints()));
  });
  const auto result = TMesh::New();
  result->SetCellsAllocationMethod(itk::MeshEnums::MeshClassCellsAllocationMethod::CellsAllocatedDynamicallyCellByCell);
  result->SetCells(cells);
  result->SetPoints(MakePoints(mesh, edges, midNodes));
  result->SetCellData(const_cast<typename TMesh::CellDataContainer *>(mesh->GetCellData()));
  return result;
}

template itk::LabelTetrahedralMesh::Pointer
MakeSecondOrder(const itk::LabelTetrahedralMesh * mesh, const itk::LabelMidNodeMesh * midNodes);
template itk::LabelInterfaceMesh::Pointer
MakeSecondOrder(const itk::LabelInterfaceMesh * mesh, const itk::LabelMidNodeMesh * midNodes);
} // namespace mmm
