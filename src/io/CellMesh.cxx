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
#include "io/CellMesh.h"
#include "io/CellBuffer.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace mmm
{
namespace
{
std::uint8_t
FindShape(std::int64_t itkType, std::size_t corners)
{
  const auto shape = std::find_if(std::begin(CellShapes), std::end(CellShapes), [&](const CellShape & candidate) {
    return static_cast<std::int64_t>(candidate.itkType) == itkType && candidate.corners == corners;
  });
  if (shape == std::end(CellShapes))
  {
    throw MeshFileError("has the ITK cell type " + std::to_string(itkType) + " and " + std::to_string(corners) +
                        " points; such cells cannot be written");
  }
  return static_cast<std::uint8_t>(shape - std::begin(CellShapes));
}
} // namespace

void
CheckCorners(const CellMesh & mesh)
{
  const auto * corner = mesh.corners.data();
  for (std::size_t i = 0; i < mesh.shapes.size(); ++i)
  {
    for (std::size_t k = 0; k < mesh.ShapeOf(i).corners; ++k, ++corner)
    {
      if (*corner >= mesh.NumberOfPoints())
      {
        throw MeshFileError("its cell " + std::to_string(i) + " refers to a point that is not one of its " +
                            std::to_string(mesh.NumberOfPoints()));
      }
    }
  }
}

std::vector<std::size_t>
CornerBegins(const CellMesh & mesh)
{
  std::vector<std::size_t> begins(mesh.shapes.size());
  for (std::size_t i = 0, begin = 0; i < begins.size(); begin += mesh.ShapeOf(i).corners, ++i)
  {
    begins[i] = begin;
  }
  return begins;
}

GroupNames
NamesInUse(const CellMesh & mesh, const std::string & characters)
{
  GroupNames names;
  Group      previous{ -1, 0 };
  for (std::size_t i = 0; i < mesh.shapes.size(); ++i)
  {
    // neighbours in the list are often alike
    const Group group = mesh.GroupOf(i);
    const auto  found = group == previous ? mesh.names.end() : mesh.names.find(group);
    if (found != mesh.names.end())
    {
      names.insert(*found);
    }
    previous = group;
  }
  for (auto & [group, name] : names)
  {
    std::replace_if(name.begin(), name.end(), [&](char c) { return characters.find(c) != std::string::npos; }, ' ');
  }
  return names;
}

void
SortCells(CellMesh & mesh, const std::vector<std::uint64_t> & keys)
{
  if (std::is_sorted(keys.begin(), keys.end()))
  {
    return;
  }
  std::vector<std::size_t> order(keys.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  const auto     begins = CornerBegins(mesh);
  const CellMesh unsorted = mesh;
  auto           corner = mesh.corners.begin();
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    mesh.shapes[i] = unsorted.shapes[order[i]];
    mesh.tags[i] = unsorted.tags[order[i]];
    corner = std::copy_n(unsorted.corners.begin() + begins[order[i]], mesh.ShapeOf(i).corners, corner);
  }
}

void
SetPoints(CellMesh &           mesh,
          const void *         buffer,
          itk::IOComponentEnum type,
          std::size_t          numberOfPoints,
          unsigned int         dimension)
{
  if (dimension < 1 || dimension > 3)
  {
    throw MeshFileError("its points have " + std::to_string(dimension) + " coordinates; such files have three");
  }
  mesh.points.assign(3 * numberOfPoints, 0.0);
  VisitComponentType(type, [&](auto zero) {
    using T = decltype(zero);
    const auto * values = static_cast<const T *>(buffer);
    for (std::size_t i = 0; i < numberOfPoints; ++i)
    {
      for (unsigned int axis = 0; axis < dimension; ++axis)
      {
        mesh.points[3 * i + axis] = static_cast<double>(*values++);
      }
    }
  });
}

void
SetCells(CellMesh &           mesh,
         const void *         buffer,
         itk::IOComponentEnum type,
         std::size_t          bufferSize,
         std::size_t          numberOfCells)
{
  VisitCells(
    buffer, type, bufferSize, numberOfCells, [&](std::int64_t itkType, const std::vector<std::uint64_t> & points) {
      mesh.shapes.push_back(FindShape(itkType, points.size()));
      mesh.corners.insert(mesh.corners.end(), points.begin(), points.end());
    });
}

std::vector<itk::IdentifierType>
MakeCellBuffer(const CellMesh & mesh)
{
  std::vector<itk::IdentifierType> buffer;
  buffer.reserve(2 * mesh.shapes.size() + mesh.corners.size());
  auto corner = mesh.corners.begin();
  for (std::size_t i = 0; i < mesh.shapes.size(); ++i)
  {
    const CellShape & shape = mesh.ShapeOf(i);
    buffer.push_back(static_cast<itk::IdentifierType>(shape.itkType));
    buffer.push_back(shape.corners);
    buffer.insert(buffer.end(), corner, corner + shape.corners);
    corner += shape.corners;
  }
  return buffer;
}

void
TurnLPSAndRAS(CellMesh & mesh)
{
  for (std::size_t i = 0; i < mesh.points.size(); i += 3)
  {
    mesh.points[i] = -mesh.points[i];
    mesh.points[i + 1] = -mesh.points[i + 1];
  }
}
} // namespace mmm
