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
#include "LabelSurface.h"

#include "itkTriangleCell.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <utility>

namespace cli
{
std::vector<int>
EnclosedLabels(const itk::LabelInterfaceMesh * surface, int outside)
{
  std::set<int> labels;
  for (const auto & sides : surface->GetCellData()->CastToSTLConstContainer())
  {
    labels.insert({ sides[0], sides[1] });
  }
  labels.erase(outside);
  return { labels.begin(), labels.end() };
}

itk::LabelInterfaceMesh::Pointer
ExtractLabelSurface(const itk::LabelInterfaceMesh * surface, int label)
{
  using Mesh = itk::LabelInterfaceMesh;
  constexpr auto None = std::numeric_limits<itk::IdentifierType>::max();
  const auto     extracted = Mesh::New();
  const auto     points = Mesh::PointsContainer::New();
  const auto     cells = Mesh::CellsContainer::New();
  const auto     data = Mesh::CellDataContainer::New();

  std::vector<itk::IdentifierType> places(surface->GetNumberOfPoints(), None);
  for (auto it = surface->GetCells()->Begin(); it != surface->GetCells()->End(); ++it)
  {
    auto sides = surface->GetCellData()->ElementAt(it.Index());
    if (sides[0] != label && sides[1] != label)
    {
      continue;
    }
    std::array<itk::IdentifierType, 3> corners;
    std::copy(it.Value()->PointIdsBegin(), it.Value()->PointIdsEnd(), corners.begin());
    if (sides[0] != label)
    {
      std::swap(sides[0], sides[1]);
      std::swap(corners[1], corners[2]);
    }
    for (auto & corner : corners)
    {
      if (places[corner] == None)
      {
        places[corner] = points->Size();
        points->InsertElement(points->Size(), surface->GetPoint(corner));
      }
      corner = places[corner];
    }
    auto * const cell = new itk::TriangleCell<Mesh::CellType>;
    cell->SetPointIds(corners.begin(), corners.end());
    cells->InsertElement(cells->Size(), cell);
    data->InsertElement(data->Size(), sides);
  }
  extracted->SetCellsAllocationMethod(
    itk::MeshEnums::MeshClassCellsAllocationMethod::CellsAllocatedDynamicallyCellByCell);
  extracted->SetPoints(points);
  extracted->SetCells(cells);
  extracted->SetCellData(data);
  return extracted;
}
} // namespace cli
