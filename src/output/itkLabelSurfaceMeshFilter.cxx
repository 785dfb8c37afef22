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
#include "itkLabelSurfaceMeshFilter.h"

#include "itkTriangleCell.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <utility>

namespace itk
{
auto
LabelSurfaceMeshFilter::FindLabels(const LabelInterfaceMesh * surface, int outsideLabel) -> LabelsType
{
  std::set<int> labels;
  for (const auto & sides : surface->GetCellData()->CastToSTLConstContainer())
  {
    labels.insert({ sides[0], sides[1] });
  }
  labels.erase(outsideLabel);
  return { labels.begin(), labels.end() };
}

void
LabelSurfaceMeshFilter::GenerateData()
{
  using Mesh = LabelInterfaceMesh;
  const Mesh * const surface = this->GetInput();
  Mesh * const       extracted = this->GetOutput();
  constexpr auto     None = std::numeric_limits<IdentifierType>::max();
  const auto         points = Mesh::PointsContainer::New();
  const auto         cells = Mesh::CellsContainer::New();
  const auto         data = Mesh::CellDataContainer::New();

  std::vector<IdentifierType> places(surface->GetNumberOfPoints(), None);
  for (auto it = surface->GetCells()->Begin(); it != surface->GetCells()->End(); ++it)
  {
    auto sides = surface->GetCellData()->ElementAt(it.Index());
    if (sides[0] != m_Label && sides[1] != m_Label)
    {
      continue;
    }
    std::array<IdentifierType, 3> corners;
    std::copy(it.Value()->PointIdsBegin(), it.Value()->PointIdsEnd(), corners.begin());
    if (sides[0] != m_Label)
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
    auto * const cell = new TriangleCell<Mesh::CellType>;
    cell->SetPointIds(corners.begin(), corners.end());
    cells->InsertElement(cells->Size(), cell);
    data->InsertElement(data->Size(), sides);
  }
  extracted->SetCellsAllocationMethod(MeshEnums::MeshClassCellsAllocationMethod::CellsAllocatedDynamicallyCellByCell);
  extracted->SetPoints(points);
  extracted->SetCells(cells);
  extracted->SetCellData(data);
}

void
LabelSurfaceMeshFilter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Label: " << m_Label << '\n';
}
} // end namespace itk
