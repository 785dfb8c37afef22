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
#ifndef itkTetrahedronArrays_h
#define itkTetrahedronArrays_h

#include "itkCommonEnums.h"
#include "itkIntTypes.h"
#include "itkMacro.h"
#include "itkNumericTraits.h"
#include "itkPoint.h"
#include "itkTetrahedronCell.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace itk
{
/** \brief Tetrahedra and their labels as plain arrays: what filters of any type of mesh give to compiled code, and get.
 *
 * \ingroup MultiMaterialMeshing
 */
struct TetrahedronArrays
{
  using PointType = Point<double, 3>;
  using TetrahedronType = std::array<std::uint32_t, 4>;

  std::vector<PointType> points;
  /** Places in `points`. */
  std::vector<TetrahedronType> tetrahedra;
  std::vector<int>             labels;
};

/** \brief The tetrahedra of an itk::Mesh. Cells keep their order.
 *
 * \throw ExceptionObject that names the cell, if a cell is of another kind, lacks a label or has a point that the mesh
 * lacks.
 *
 * \ingroup MultiMaterialMeshing
 */
template <typename TMesh>
class TetrahedronReader
{
public:
  enum class OtherCells
  {
    Throw,
    /** Those of lower dimension, that is: others throw. */
    LeaveOut
  };

  TetrahedronReader(const TMesh * mesh, OtherCells otherCells)
    : m_Mesh(mesh)
    , m_OtherCells(otherCells)
  {
    this->ReadPoints();
    if (mesh->GetCells())
    {
      this->ReadCells();
    }
  }

  TetrahedronArrays                           arrays;
  std::vector<typename TMesh::CellIdentifier> cellIdentifiers;
  SizeValueType                               leftOut{ 0 };

private:
  using CellIdentifier = typename TMesh::CellIdentifier;
  using PointIdentifier = typename TMesh::PointIdentifier;

  void
  ReadPoints()
  {
    const auto * container = m_Mesh->GetPoints();
    if (container == nullptr)
    {
      return;
    }
    arrays.points.reserve(container->Size());
    bool isContiguous = true;
    for (auto point = container->Begin(); point != container->End(); ++point)
    {
      isContiguous = isContiguous && point.Index() == arrays.points.size();
      m_PointIdentifiers.push_back(point.Index());
      arrays.points.emplace_back();
      arrays.points.back().CastFrom(point.Value());
    }
    if (isContiguous)
    {
      m_PointIdentifiers.clear();
    }
  }

  void
  ReadCells()
  {
    const auto * cells = m_Mesh->GetCells();
    cellIdentifiers.reserve(cells->Size());
    arrays.tetrahedra.reserve(cells->Size());
    arrays.labels.reserve(cells->Size());
    for (auto cell = cells->Begin(); cell != cells->End(); ++cell)
    {
      // a vector of cells may have gaps
      if (cell.Value() == nullptr)
      {
        continue;
      }
      const typename TMesh::CellType & constCell = *cell.Value();
      if (constCell.GetType() != CommonEnums::CellGeometry::TETRAHEDRON_CELL)
      {
        if (m_OtherCells == OtherCells::LeaveOut && constCell.GetDimension() < 3)
        {
          ++leftOut;
          continue;
        }
        itkGenericExceptionMacro("Cell " << cell.Index() << " is no tetrahedron: it is a " << constCell.GetType()
                                         << ".");
      }
      auto                               pointOfCell = constCell.PointIdsBegin();
      TetrahedronArrays::TetrahedronType tetrahedron{ {} };
      for (auto & index : tetrahedron)
      {
        const PointIdentifier point = *pointOfCell++;
        const std::size_t     position = this->PositionOf(point);
        if (position >= arrays.points.size())
        {
          itkGenericExceptionMacro("Cell " << cell.Index() << " has the point " << point << ", which the mesh lacks.");
        }
        index = static_cast<std::uint32_t>(position);
      }
      cellIdentifiers.push_back(cell.Index());
      arrays.tetrahedra.push_back(tetrahedron);
      arrays.labels.push_back(this->LabelOf(cell.Index()));
    }
  }

  std::size_t
  PositionOf(PointIdentifier point) const
  {
    if (m_PointIdentifiers.empty())
    {
      return point;
    }
    const auto found = std::lower_bound(m_PointIdentifiers.begin(), m_PointIdentifiers.end(), point);
    return found != m_PointIdentifiers.end() && *found == point
             ? static_cast<std::size_t>(found - m_PointIdentifiers.begin())
             : arrays.points.size();
  }

  int
  LabelOf(CellIdentifier cell) const
  {
    const auto * data = m_Mesh->GetCellData();
    if (data == nullptr || data->Size() == 0)
    {
      return 0;
    }
    typename TMesh::CellPixelType pixel{};
    if (!data->GetElementIfIndexExists(cell, &pixel))
    {
      itkGenericExceptionMacro("Cell " << cell << " has no label.");
    }
    const auto label = static_cast<double>(pixel);
    if (!(label >= NumericTraits<int>::NonpositiveMin() && label <= NumericTraits<int>::max()) ||
        label != std::floor(label))
    {
      itkGenericExceptionMacro("Cell " << cell << " has the label " << label
                                       << ", which is not a whole number of type int.");
    }
    return static_cast<int>(label);
  }

  const TMesh *    m_Mesh;
  const OtherCells m_OtherCells;
  /** Empty where they are 0, 1, 2 and so on. */
  std::vector<PointIdentifier> m_PointIdentifiers;
};

/** Gives an itk::Mesh these points, tetrahedra and labels in place of what it has. */
template <typename TMesh>
void
FillMesh(const TetrahedronArrays & arrays, TMesh * mesh)
{
  const auto points = TMesh::PointsContainer::New();
  points->Reserve(arrays.points.size());
  const auto cells = TMesh::CellsContainer::New();
  cells->Reserve(arrays.tetrahedra.size());
  const auto data = TMesh::CellDataContainer::New();
  data->Reserve(arrays.labels.size());
  for (std::size_t p = 0; p < arrays.points.size(); ++p)
  {
    points->ElementAt(p).CastFrom(arrays.points[p]);
  }
  for (std::size_t t = 0; t < arrays.tetrahedra.size(); ++t)
  {
    auto * cell = new TetrahedronCell<typename TMesh::CellType>;
    for (int corner = 0; corner < 4; ++corner)
    {
      cell->SetPointId(corner, arrays.tetrahedra[t][corner]);
    }
    cells->ElementAt(t) = cell;
    data->ElementAt(t) = static_cast<typename TMesh::CellPixelType>(arrays.labels[t]);
  }
  mesh->SetPoints(points);
  mesh->SetCellsAllocationMethod(MeshEnums::MeshClassCellsAllocationMethod::CellsAllocatedDynamicallyCellByCell);
  mesh->SetCells(cells);
  mesh->SetCellData(data);
}
} // namespace itk

#endif
