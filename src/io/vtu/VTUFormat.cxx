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
#include "io/vtu/VTUFormat.h"

#include "itkMeshIOBase.h"

#include <iterator>
#include <limits>
#include <type_traits>

namespace mmm
{
namespace
{
constexpr std::size_t any = std::numeric_limits<std::size_t>::max();

// Written only: ITK's tetrahedra have four points.
constexpr std::uint8_t QuadraticTetrahedron = 24;

// Writing takes the first row that fits, reading the only row of a VTK type.
constexpr VTUCellType cellTypes[]{ { 1, itk::CellGeometryEnum::VERTEX_CELL, 1, 1 },
                                   { 2, itk::CellGeometryEnum::VERTEX_CELL, 1, any },
                                   { 3, itk::CellGeometryEnum::LINE_CELL, 2, 2 },
                                   { 4, itk::CellGeometryEnum::LINE_CELL, 2, any },
                                   { 5, itk::CellGeometryEnum::TRIANGLE_CELL, 3, 3 },
                                   { 7, itk::CellGeometryEnum::POLYGON_CELL, 3, any },
                                   { 9, itk::CellGeometryEnum::QUADRILATERAL_CELL, 4, 4 },
                                   { 10, itk::CellGeometryEnum::TETRAHEDRON_CELL, 4, 4 },
                                   { 12, itk::CellGeometryEnum::HEXAHEDRON_CELL, 8, 8 },
                                   { 21, itk::CellGeometryEnum::QUADRATIC_EDGE_CELL, 3, 3 },
                                   { 22, itk::CellGeometryEnum::QUADRATIC_TRIANGLE_CELL, 6, 6 },
                                   { QuadraticTetrahedron, itk::CellGeometryEnum::TETRAHEDRON_CELL, 10, 10 } };

// itk::CellGeometryEnum::POLYLINE_CELL, which ITK before 5.3 lacks.
constexpr std::int64_t itkPolyLine = 10;
} // namespace

std::string
VTUTypeName(itk::IOComponentEnum type)
{
  return VisitComponentType(type, [](auto zero) -> std::string {
    using T = decltype(zero);
    if (std::is_same_v<T, long double>)
    {
      return "Float64";
    }
    const char * const kind = std::is_floating_point_v<T> ? "Float" : std::is_signed_v<T> ? "Int" : "UInt";
    return kind + std::to_string(8 * sizeof(T));
  });
}

itk::IOComponentEnum
ComponentTypeOfVTU(const std::string & typeName)
{
  using Type = itk::IOComponentEnum;
  for (const Type type : { Type::CHAR, // an int8_t is not a char, though it looks like one
                           Type::UCHAR,
                           itk::MeshIOBase::MapComponentType<std::int16_t>::CType,
                           itk::MeshIOBase::MapComponentType<std::uint16_t>::CType,
                           itk::MeshIOBase::MapComponentType<std::int32_t>::CType,
                           itk::MeshIOBase::MapComponentType<std::uint32_t>::CType,
                           itk::MeshIOBase::MapComponentType<std::int64_t>::CType,
                           itk::MeshIOBase::MapComponentType<std::uint64_t>::CType,
                           Type::FLOAT,
                           Type::DOUBLE })
  {
    if (VTUTypeName(type) == typeName)
    {
      return type;
    }
  }
  throw MeshFileError("has the type \"" + typeName + "\", which is not supported");
}

std::uint8_t
VTKCellType(std::int64_t itkType, std::size_t numberOfPoints)
{
  const std::int64_t sought =
    itkType == itkPolyLine ? static_cast<std::int64_t>(itk::CellGeometryEnum::LINE_CELL) : itkType;
  for (const VTUCellType & row : cellTypes)
  {
    if (static_cast<std::int64_t>(row.itkType) == sought && row.minimumPoints <= numberOfPoints &&
        numberOfPoints <= row.maximumPoints)
    {
      return row.vtkType;
    }
  }
  throw MeshFileError("has the ITK cell type " + std::to_string(itkType) + " and " + std::to_string(numberOfPoints) +
                      " points, for which VTK has no cell type");
}

const VTUCellType &
ITKCellType(std::int64_t vtkType)
{
  for (const VTUCellType & row : cellTypes)
  {
    if (row.vtkType == vtkType && vtkType != QuadraticTetrahedron)
    {
      return row;
    }
  }
  throw MeshFileError("is a " + VTKCellTypeName(vtkType) + ", which ITK meshes cannot hold");
}

std::string
VTKCellTypeName(std::int64_t vtkType)
{
  constexpr const char * names[] = { "empty cell",
                                     "vertex",
                                     "poly-vertex",
                                     "line",
                                     "polyline",
                                     "triangle",
                                     "triangle strip",
                                     "polygon",
                                     "pixel",
                                     "quadrilateral",
                                     "tetrahedron",
                                     "voxel",
                                     "hexahedron",
                                     "wedge",
                                     "pyramid",
                                     "pentagonal prism",
                                     "hexagonal prism",
                                     "cell",
                                     "cell",
                                     "cell",
                                     "cell",
                                     "quadratic edge",
                                     "quadratic triangle",
                                     "quadratic quadrilateral",
                                     "quadratic tetrahedron",
                                     "quadratic hexahedron",
                                     "quadratic wedge",
                                     "quadratic pyramid" };
  const bool             isNamed = vtkType >= 0 && vtkType < static_cast<std::int64_t>(std::size(names));
  const char *           name = isNamed ? names[vtkType] : vtkType == 42 ? "polyhedron" : "cell";
  return std::string(name) + " (VTK cell type " + std::to_string(vtkType) + ')';
}
} // namespace mmm
