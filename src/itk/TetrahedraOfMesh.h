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
#ifndef mmmTetrahedraOfMesh_h
#define mmmTetrahedraOfMesh_h

#include "mesh/TetrahedralMesh.h"

#include "itkCommonEnums.h"
#include "itkMacro.h"
#include "itkNumericTraits.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace mmm
{
/** \brief The points of an itk::Mesh, its tetrahedra and their labels. Cells keep their order.
 *
 * \throw itk::ExceptionObject that names the cell, if a cell is of another kind, lacks a label or has a point that the
 * mesh lacks. */
template <typename TMesh>
class TetrahedraOfMesh
{
public:
  enum class OtherCells
  {
    Throw,
    /** Those of lower dimension, that is: others throw. */
    LeaveOut
  };

  TetrahedraOfMesh(const TMesh * mesh, OtherCells otherCells)
    : m_Mesh(mesh)
    , m_OtherCells(otherCells)
  {
    this->ReadPoints();
    if (mesh->GetCells())
    {
      this->ReadCells();
    }
  }

  std::vector<Vector>                         points;
  std::vector<Tetrahedron>                    tetrahedra;
  std::vector<int>                            labels;
  std::vector<typename TMesh::CellIdentifier> cellIdentifiers;
  std::size_t                                 leftOut{ 0 };

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
    points.reserve(container->Size());
    bool isContiguous = true;
    for (auto point = container->Begin(); point != container->End(); ++point)
    {
      isContiguous = isContiguous && point.Index() == points.size();
      m_PointIdentifiers.push_back(point.Index());
      points.emplace_back(point.Value()[0], point.Value()[1], point.Value()[2]);
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
    tetrahedra.reserve(cells->Size());
    labels.reserve(cells->Size());
    for (auto cell = cells->Begin(); cell != cells->End(); ++cell)
    {
      // a vector of cells may have gaps
      if (cell.Value() == nullptr)
      {
        continue;
      }
      const typename TMesh::CellType & constCell = *cell.Value();
      if (constCell.GetType() != itk::CommonEnums::CellGeometry::TETRAHEDRON_CELL)
      {
        if (m_OtherCells == OtherCells::LeaveOut && constCell.GetDimension() < 3)
        {
          ++leftOut;
          continue;
        }
        itkGenericExceptionMacro("Cell " << cell.Index() << " is no tetrahedron: it is a " << constCell.GetType()
                                         << ".");
      }
      auto        pointOfCell = constCell.PointIdsBegin();
      Tetrahedron tetrahedron{ {} };
      for (auto & index : tetrahedron)
      {
        const PointIdentifier point = *pointOfCell++;
        const std::size_t     position = this->PositionOf(point);
        if (position >= points.size())
        {
          itkGenericExceptionMacro("Cell " << cell.Index() << " has the point " << point << ", which the mesh lacks.");
        }
        index = static_cast<std::uint32_t>(position);
      }
      cellIdentifiers.push_back(cell.Index());
      tetrahedra.push_back(tetrahedron);
      labels.push_back(this->LabelOf(cell.Index()));
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
             : points.size();
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
    if (!(label >= itk::NumericTraits<int>::NonpositiveMin() && label <= itk::NumericTraits<int>::max()) ||
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
} // namespace mmm

#endif
