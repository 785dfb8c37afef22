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
#include "io/vtu/VTUCells.h"
#include "io/CellBuffer.h"
#include "io/vtu/VTUArrayDecoder.h"
#include "io/vtu/VTUFormat.h"

#include "itkMeshIOBase.h"

#include <numeric>
#include <optional>

namespace mmm
{
namespace
{
VTUValues
ReadIntegers(std::istream &               file,
             const VTUDocument &          document,
             const std::string &          name,
             std::optional<std::uint64_t> expected)
{
  for (const VTUArray & array : document.cells)
  {
    if (array.name == name)
    {
      if (array.numberOfComponents != 1 || array.type.compare(0, 5, "Float") == 0)
      {
        throw MeshFileError("its array \"" + name + "\" must have one integer per value");
      }
      return ReadVTUArray(file, document, array, expected);
    }
  }
  throw MeshFileError("its cells have no array \"" + name + '"');
}

/** Appends the cell with these points; those with more points than ITK's type can have as several ones. */
void
AppendCell(VTUCells & cells, const VTUCellType & type, const std::vector<itk::IdentifierType> & points)
{
  const bool isVertex = type.itkType == itk::CellGeometryEnum::VERTEX_CELL;
  const bool isLine = type.itkType == itk::CellGeometryEnum::LINE_CELL;
  // Of a polyline, consecutive parts share a point.
  const std::size_t size = isVertex ? 1 : isLine ? 2 : points.size();
  const std::size_t step = isVertex || isLine ? 1 : size;
  for (std::size_t first = 0; first + size <= points.size(); first += step)
  {
    cells.buffer.push_back(static_cast<itk::IdentifierType>(type.itkType));
    cells.buffer.push_back(size);
    cells.buffer.insert(cells.buffer.end(), points.begin() + first, points.begin() + first + size);
    ++cells.count;
  }
}

void
CheckPoint(std::int64_t point, std::uint64_t numberOfPoints)
{
  if (point < 0 || static_cast<std::uint64_t>(point) >= numberOfPoints)
  {
    throw MeshFileError("refers to the point " + std::to_string(point) + " of " + std::to_string(numberOfPoints));
  }
}
} // namespace

VTUCells
ReadVTUCells(std::istream & file, const VTUDocument & document)
{
  VTUCells cells;
  if (document.numberOfCells == 0)
  {
    return cells;
  }
  const VTUValues types = ReadIntegers(file, document, "types", document.numberOfCells);
  const VTUValues offsets = ReadIntegers(file, document, "offsets", document.numberOfCells);
  const VTUValues connectivity = ReadIntegers(file, document, "connectivity", std::nullopt);

  cells.buffer.reserve(2 * types.count + connectivity.count);
  std::vector<itk::IdentifierType> points;
  std::size_t                      begin = 0;
  for (std::size_t i = 0; i < types.count; ++i)
  {
    NameCell(i, [&] {
      const std::int64_t end = offsets.IntegerAt(i);
      if (end < 0 || static_cast<std::uint64_t>(end) > connectivity.count || static_cast<std::size_t>(end) < begin)
      {
        throw MeshFileError("has the offset " + std::to_string(end) + ", which is out of range");
      }
      points.clear();
      for (; begin < static_cast<std::size_t>(end); ++begin)
      {
        const std::int64_t point = connectivity.IntegerAt(begin);
        CheckPoint(point, document.numberOfPoints);
        points.push_back(static_cast<itk::IdentifierType>(point));
      }
      const std::int64_t  vtkType = types.IntegerAt(i);
      const VTUCellType & type = ITKCellType(vtkType);
      if (points.size() < type.minimumPoints || type.maximumPoints < points.size())
      {
        throw MeshFileError("is a " + VTKCellTypeName(vtkType) + " of " + std::to_string(points.size()) + " points");
      }
      const std::size_t firstOfCell = cells.count;
      AppendCell(cells, type, points);
      if (cells.count != i + 1)
      {
        if (cells.sources.empty())
        {
          cells.sources.resize(firstOfCell);
          std::iota(cells.sources.begin(), cells.sources.end(), std::size_t{ 0 });
        }
        cells.sources.resize(cells.count, i);
      }
    });
  }
  if (begin != connectivity.count)
  {
    throw MeshFileError("its cells have " + std::to_string(begin) + " points, but its array \"connectivity\" has " +
                        std::to_string(connectivity.count));
  }
  return cells;
}

EncodedVTUCells
EncodeVTUCells(const void *         buffer,
               itk::IOComponentEnum type,
               std::size_t          bufferSize,
               std::size_t          numberOfCells,
               std::size_t          numberOfPoints,
               VTUEncoding          encoding)
{
  if (bufferSize < 2 * numberOfCells)
  {
    throw MeshFileError("its cell buffer is too small for its cells");
  }
  VTUArrayEncoder connectivity(encoding, (bufferSize - 2 * numberOfCells) * sizeof(std::int64_t));
  VTUArrayEncoder offsets(encoding, numberOfCells * sizeof(std::int64_t));
  VTUArrayEncoder types(encoding, numberOfCells);
  std::int64_t    offset = 0;
  VisitCells(
    buffer, type, bufferSize, numberOfCells, [&](std::int64_t itkType, const std::vector<std::uint64_t> & points) {
      types.Push(VTKCellType(itkType, points.size()));
      for (const auto unchecked : points)
      {
        const auto point = static_cast<std::int64_t>(unchecked);
        CheckPoint(point, numberOfPoints);
        connectivity.Push(point);
      }
      offset += static_cast<std::int64_t>(points.size());
      offsets.Push(offset);
    });
  return { connectivity.Finish(), offsets.Finish(), types.Finish() };
}

EncodedVTUCells
EncodeVTUVertices(std::size_t numberOfPoints, VTUEncoding encoding)
{
  std::vector<std::int64_t> buffer;
  buffer.reserve(3 * numberOfPoints);
  for (std::size_t i = 0; i < numberOfPoints; ++i)
  {
    buffer.insert(buffer.end(),
                  { static_cast<std::int64_t>(itk::CellGeometryEnum::VERTEX_CELL), 1, static_cast<std::int64_t>(i) });
  }
  return EncodeVTUCells(buffer.data(),
                        itk::MeshIOBase::MapComponentType<std::int64_t>::CType,
                        buffer.size(),
                        numberOfPoints,
                        numberOfPoints,
                        encoding);
}
} // namespace mmm
