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
#ifndef CGALMesh3Output_h
#define CGALMesh3Output_h

#include "CGALMesh3Image.h"

#include "itkMesh.h"
#include "itkMeshFileWriter.h"
#include "itkTetrahedronCell.h"
#include "itkVTUMeshIO.h"

#include <string>
#include <unordered_map>
#include <utility>

/** Writes the tetrahedra and their labels, at the place of the image, positively oriented. */
template <typename TC3t3>
void
WriteTetrahedra(const TC3t3 & c3t3, const LabelImage & image, const std::string & fileName)
{
  using MeshType = itk::Mesh<int, 3, itk::DefaultStaticMeshTraits<int, 3, 3, double, double, int>>;
  using CellType = MeshType::CellType;
  using TetrahedronType = itk::TetrahedronCell<CellType>;

  const auto mesh = MeshType::New();
  mesh->SetCellsAllocationMethod(itk::MeshEnums::MeshClassCellsAllocationMethod::CellsAllocatedDynamicallyCellByCell);
  mesh->GetCells()->Reserve(c3t3.number_of_cells_in_complex());
  const bool flipped = vnl_determinant(image.GetDirection().GetVnlMatrix()) < 0;

  std::unordered_map<typename TC3t3::Vertex_handle, itk::IdentifierType, boost::hash<typename TC3t3::Vertex_handle>>
             ids;
  const auto idOf = [&](const typename TC3t3::Vertex_handle & vertex) {
    const auto inserted = ids.emplace(vertex, ids.size());
    if (inserted.second)
    {
      itk::ContinuousIndex<double, 3> index;
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        index[axis] = vertex->point()[axis] / image.GetSpacing()[axis];
      }
      MeshType::PointType point;
      image.TransformContinuousIndexToPhysicalPoint(index, point);
      mesh->SetPoint(inserted.first->second, point);
    }
    return inserted.first->second;
  };

  itk::IdentifierType cellId = 0;
  for (auto cell = c3t3.cells_in_complex_begin(); cell != c3t3.cells_in_complex_end(); ++cell, ++cellId)
  {
    MeshType::CellAutoPointer tetrahedron;
    tetrahedron.TakeOwnership(new TetrahedronType);
    for (int corner = 0; corner < 4; ++corner)
    {
      tetrahedron->SetPointId(corner, idOf(cell->vertex(flipped && corner > 1 ? 5 - corner : corner)));
    }
    mesh->SetCell(cellId, tetrahedron);
    mesh->SetCellData(cellId, cell->subdomain_index());
  }

  const auto writer = itk::MeshFileWriter<MeshType>::New();
  writer->SetMeshIO(itk::VTUMeshIO::New());
  writer->SetInput(mesh);
  writer->SetFileName(fileName);
  writer->SetFileTypeAsBINARY();
  writer->UseCompressionOn();
  writer->Update();
}

#endif
