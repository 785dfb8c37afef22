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
#include "output/OrientedTriangles.h"

#include "itkTriangleCell.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace mmm
{
using Mesh = itk::LabelInterfaceMesh;

std::vector<OrientedTriangle>
FindSurface(const Mesh & mesh, const std::vector<int> & labels)
{
  const auto isInside = [&](int label) { return std::find(labels.begin(), labels.end(), label) != labels.end(); };
  std::vector<OrientedTriangle> triangles;
  for (auto it = mesh.GetCells()->Begin(); it != mesh.GetCells()->End(); ++it)
  {
    OrientedTriangle triangle{ {}, mesh.GetCellData()->ElementAt(it.Index()) };
    auto & [corners, sides] = triangle;
    if (isInside(sides[0]) == isInside(sides[1]))
    {
      continue;
    }
    std::copy(it.Value()->PointIdsBegin(), it.Value()->PointIdsEnd(), corners.begin());
    if (!isInside(sides[0]))
    {
      std::swap(sides[0], sides[1]);
      std::swap(corners[1], corners[2]);
    }
    triangles.push_back(triangle);
  }
  return triangles;
}

void
SetTriangles(const Mesh & source, const std::vector<OrientedTriangle> & triangles, Mesh * mesh)
{
  constexpr auto None = std::numeric_limits<itk::IdentifierType>::max();
  const auto     points = Mesh::PointsContainer::New();
  const auto     cells = Mesh::CellsContainer::New();
  const auto     data = Mesh::CellDataContainer::New();

  std::vector<itk::IdentifierType> places(source.GetNumberOfPoints(), None);
  for (auto [corners, sides] : triangles)
  {
    for (auto & corner : corners)
    {
      auto & place = places[corner];
      if (place == None)
      {
        place = points->Size();
        points->InsertElement(place, source.GetPoint(corner));
      }
      corner = place;
    }
    auto * const cell = new itk::TriangleCell<Mesh::CellType>;
    cell->SetPointIds(corners.begin(), corners.end());
    cells->InsertElement(cells->Size(), cell);
    data->InsertElement(data->Size(), sides);
  }
  mesh->SetCellsAllocationMethod(itk::MeshEnums::MeshClassCellsAllocationMethod::CellsAllocatedDynamicallyCellByCell);
  mesh->SetPoints(points);
  mesh->SetCells(cells);
  mesh->SetCellData(data);
}
} // namespace mmm
