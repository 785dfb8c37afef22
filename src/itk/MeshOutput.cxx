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
#include "itk/MeshOutput.h"

#include "itkLineCell.h"
#include "itkTriangleCell.h"
#include "itkVertexCell.h"

#include <algorithm>
#include <map>
#include <utility>

namespace mmm
{
namespace
{
template <typename TMesh>
void
SetPoints(TMesh * mesh, const GridGeometry & geometry, const std::vector<Vector> & points, std::size_t count)
{
  const auto container = TMesh::PointsContainer::New();
  container->Reserve(count);
  for (std::size_t p = 0; p < count; ++p)
  {
    container->ElementAt(p) = geometry.ToPhysicalPoint(points[p]);
  }
  mesh->SetPoints(container);
}

/** Cells in the order of their creation, each with its value. */
template <typename TMesh>
void
SetCells(TMesh * mesh, typename TMesh::CellsContainer * cells, std::vector<typename TMesh::CellPixelType> values)
{
  mesh->SetCellsAllocationMethod(itk::MeshEnums::MeshClassCellsAllocationMethod::CellsAllocatedDynamicallyCellByCell);
  mesh->SetCells(cells);
  const auto data = TMesh::CellDataContainer::New();
  data->CastToSTLContainer() = std::move(values);
  mesh->SetCellData(data);
}

void
SetSurface(const MeshingResult &     result,
           const GridGeometry &      geometry,
           const InterfaceLabels &   labels,
           itk::LabelInterfaceMesh * mesh)
{
  using Cell = itk::TriangleCell<itk::LabelInterfaceMesh::CellType>;
  const InterfaceMesh &                               interfaces = result.interfaces;
  std::vector<itk::LabelInterfaceMesh::CellPixelType> sideLabels;
  sideLabels.reserve(interfaces.sides.size());
  const auto cells = itk::LabelInterfaceMesh::CellsContainer::New();
  cells->Reserve(interfaces.triangles.size());
  const bool isReflected = geometry.IsReflected();
  for (std::size_t t = 0; t < interfaces.triangles.size(); ++t)
  {
    const auto & sides = interfaces.sides[t];
    auto         corners = interfaces.triangles[t];
    if (isReflected != (labels.OfMaterial(sides[0]) > labels.OfMaterial(sides[1])))
    {
      std::swap(corners[1], corners[2]);
    }
    auto * cell = new Cell;
    for (int corner = 0; corner < 3; ++corner)
    {
      cell->SetPointId(corner, corners[corner]);
    }
    cells->ElementAt(t) = cell;
    sideLabels.emplace_back(labels.OfSides(sides));
  }
  SetPoints(mesh, geometry, result.points, result.numberOfSurfacePoints);
  SetCells(mesh, cells.GetPointer(), std::move(sideLabels));
}

void
SetParticles(const ParticleSet &      particles,
             const GridGeometry &     geometry,
             const InterfaceLabels &  labels,
             itk::LabelParticleMesh * mesh)
{
  SetPoints(mesh, geometry, particles.positions, particles.Size());
  const auto data = itk::LabelParticleMesh::PointDataContainer::New();
  auto &     values = data->CastToSTLContainer();
  values.reserve(particles.Size());
  for (std::size_t p = 0; p < particles.Size(); ++p)
  {
    values.emplace_back(labels.OfParticle(particles.CellOf(p)));
  }
  mesh->SetPointData(data);
}

void
SetJunctions(const MeshingResult &    result,
             const GridGeometry &     geometry,
             const InterfaceLabels &  labels,
             itk::LabelJunctionMesh * mesh)
{
  using Mesh = itk::LabelJunctionMesh;
  const auto cells = Mesh::CellsContainer::New();

  std::vector<Vector>              points;
  std::vector<Mesh::CellPixelType> data;
  std::map<PointId, std::size_t>   places;
  const auto                       placeOf = [&](PointId point) {
    const auto inserted = places.emplace(point, points.size());
    if (inserted.second)
    {
      points.push_back(result.points[point]);
    }
    return inserted.first->second;
  };
  const auto append = [&](auto * cell, int curve, const MaterialList & materials) {
    cells->InsertElement(cells->Size(), cell);
    const auto          values = labels.OfJunction(materials);
    Mesh::CellPixelType pixel;
    pixel[0] = curve;
    std::copy(values.begin(), values.end(), &pixel[1]);
    data.push_back(pixel);
  };
  for (const auto & junction : result.junctions.points)
  {
    auto * vertex = new itk::VertexCell<Mesh::CellType>;
    vertex->SetPointId(0, placeOf(junction.point));
    append(vertex, -1, junction.materials);
  }
  for (std::size_t c = 0; c < result.junctions.curves.size(); ++c)
  {
    const auto & curve = result.junctions.curves[c];
    for (std::size_t p = 1; p < curve.points.size(); ++p)
    {
      auto * line = new itk::LineCell<Mesh::CellType>;
      line->SetPointId(0, placeOf(curve.points[p - 1]));
      line->SetPointId(1, placeOf(curve.points[p]));
      append(line, static_cast<int>(c), curve.materials);
    }
  }
  SetPoints(mesh, geometry, points, points.size());
  SetCells(mesh, cells.GetPointer(), std::move(data));
}

void
SetMidNodes(const CurvedEdges & edges, const GridGeometry & geometry, itk::LabelMidNodeMesh * mesh)
{
  std::vector<Vector> points;
  const auto          data = itk::LabelMidNodeMesh::PointDataContainer::New();
  auto &              ends = data->CastToSTLContainer();
  points.reserve(edges.size());
  ends.resize(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    points.push_back(edges[e].middle);
    std::copy(edges[e].ends.begin(), edges[e].ends.end(), ends[e].Begin());
  }
  SetPoints(mesh, geometry, points, points.size());
  mesh->SetPointData(data);
}
} // namespace

void
SetSurfaceAndParticles(const MeshingResult &   result,
                       const GridGeometry &    geometry,
                       const InterfaceLabels & labels,
                       const MeshingOutputs &  outputs)
{
  if (!result.points.empty())
  {
    SetSurface(result, geometry, labels, outputs.surface);
  }
  SetParticles(result.particles, geometry, labels, outputs.particles);
  SetJunctions(result, geometry, labels, outputs.junctions);
  SetMidNodes(result.curvedEdges, geometry, outputs.midNodes);
  outputs.surface->SetBufferedRegion(outputs.surface->GetRequestedRegion());
  outputs.particles->SetBufferedRegion(outputs.particles->GetRequestedRegion());
  outputs.junctions->SetBufferedRegion(outputs.junctions->GetRequestedRegion());
  outputs.midNodes->SetBufferedRegion(outputs.midNodes->GetRequestedRegion());
}

itk::TetrahedronArrays
TakeTetrahedra(MeshingResult & result, const GridGeometry & geometry, const std::vector<int> & labels)
{
  itk::TetrahedronArrays arrays;
  arrays.points.reserve(result.points.size());
  for (const Vector & point : result.points)
  {
    arrays.points.push_back(geometry.ToPhysicalPoint(point));
  }
  arrays.tetrahedra = std::move(result.tetrahedra.tetrahedra);
  if (geometry.IsReflected())
  {
    for (auto & tetrahedron : arrays.tetrahedra)
    {
      std::swap(tetrahedron[1], tetrahedron[2]);
    }
  }
  arrays.labels.reserve(result.tetrahedra.materials.size());
  for (const Material material : result.tetrahedra.materials)
  {
    arrays.labels.push_back(labels[material]);
  }
  return arrays;
}
} // namespace mmm
