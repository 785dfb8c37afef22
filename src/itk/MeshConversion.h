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
#ifndef mmmMeshConversion_h
#define mmmMeshConversion_h

#include "itk/GridGeometry.h"
#include "mesh/TetrahedralMesh.h"

#include "itkCommonEnums.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace mmm
{
/** Gives an itk::Mesh the first `count` points, in physical space. */
template <typename TMesh>
void
SetMeshPoints(TMesh * mesh, const GridGeometry & geometry, const std::vector<Vector> & points, std::size_t count)
{
  const auto container = TMesh::PointsContainer::New();
  container->Reserve(count);
  auto & values = container->CastToSTLContainer();
  for (std::size_t p = 0; p < count; ++p)
  {
    const auto point = geometry.ToPhysicalPoint(points[p]);
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      values[p][axis] = static_cast<typename TMesh::PointType::ValueType>(point[axis]);
    }
  }
  mesh->SetPoints(container);
}

/** Gives an itk::Mesh points that are in physical space already. */
template <typename TMesh>
void
SetMeshPoints(TMesh * mesh, const std::vector<Vector> & points)
{
  const auto container = TMesh::PointsContainer::New();
  container->Reserve(points.size());
  auto & values = container->CastToSTLContainer();
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      values[p][axis] = static_cast<typename TMesh::PointType::ValueType>(points[p][axis]);
    }
  }
  mesh->SetPoints(container);
}

/** Gives an itk::Mesh cells of type TCell. Where `isReversed(cell)`, two of its corners are swapped. */
template <typename TCell, typename TMesh, typename TCorners, typename TPredicate>
void
SetMeshCells(TMesh * mesh, const std::vector<TCorners> & cells, const TPredicate & isReversed)
{
  const auto container = TMesh::CellsContainer::New();
  container->Reserve(cells.size());
  auto & pointers = container->CastToSTLContainer();
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    TCorners corners = cells[c];
    if (isReversed(c))
    {
      std::swap(corners[1], corners[2]);
    }
    auto * cell = new TCell;
    for (std::size_t corner = 0; corner < corners.size(); ++corner)
    {
      cell->SetPointId(static_cast<int>(corner), corners[corner]);
    }
    pointers[c] = cell;
  }
  mesh->SetCellsAllocationMethod(itk::MeshEnums::MeshClassCellsAllocationMethod::CellsAllocatedDynamicallyCellByCell);
  mesh->SetCells(container);
}

/** Gives an itk::Mesh a value per cell. */
template <typename TMesh>
void
SetMeshCellData(TMesh * mesh, std::vector<typename TMesh::CellPixelType> values)
{
  const auto container = TMesh::CellDataContainer::New();
  container->CastToSTLContainer() = std::move(values);
  mesh->SetCellData(container);
}
} // namespace mmm

#endif
