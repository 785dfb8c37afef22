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
#ifndef mmmCellMesh_h
#define mmmCellMesh_h

#include "io/MeshFileError.h"

#include "itkCommonEnums.h"
#include "itkIntTypes.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace mmm
{
/** A kind of cell that Gmsh's files have. Their corners are in the same order as ITK's or, for second order, VTK's; see
 * GmshOrder.h. Those of second order are written only: ITK has no tetrahedron of ten nodes. */
struct CellShape
{
  itk::CellGeometryEnum itkType;
  std::size_t           corners;
  int                   dimension;
  int                   gmshType;
  /** Empty if Medit's files have no such cells, or not from us. */
  const char * meditKeyword;

  constexpr bool
  IsOfSecondOrder() const
  {
    return corners == 6 || corners == 10;
  }
};

/** In the order of the dimension. */
constexpr CellShape CellShapes[] = {
  { itk::CellGeometryEnum::VERTEX_CELL, 1, 0, 15, "" },
  { itk::CellGeometryEnum::LINE_CELL, 2, 1, 1, "Edges" },
  { itk::CellGeometryEnum::TRIANGLE_CELL, 3, 2, 2, "Triangles" },
  { itk::CellGeometryEnum::QUADRILATERAL_CELL, 4, 2, 3, "Quadrilaterals" },
  { itk::CellGeometryEnum::QUADRATIC_TRIANGLE_CELL, 6, 2, 9, "" },
  { itk::CellGeometryEnum::TETRAHEDRON_CELL, 4, 3, 4, "Tetrahedra" },
  { itk::CellGeometryEnum::TETRAHEDRON_CELL, 10, 3, 11, "" },
  { itk::CellGeometryEnum::HEXAHEDRON_CELL, 8, 3, 5, "Hexahedra" },
};

/** A group of cells: their dimension and tag. */
using Group = std::pair<int, int>;
using GroupNames = std::map<Group, std::string>;

/** \brief A mesh as Gmsh's and Medit's files have it: each cell has a tag, which says to which group it belongs. */
struct CellMesh
{
  /** Three coordinates each. */
  std::vector<double> points;
  /** Of each cell, the place in CellShapes. */
  std::vector<std::uint8_t> shapes;
  /** Of all cells, one after the other. */
  std::vector<std::uint64_t> corners;
  /** Of each cell; all or none have one. */
  std::vector<int> tags;
  GroupNames       names;

  const CellShape &
  ShapeOf(std::size_t cell) const
  {
    return CellShapes[shapes[cell]];
  }

  Group
  GroupOf(std::size_t cell) const
  {
    return { this->ShapeOf(cell).dimension, tags.empty() ? 0 : tags[cell] };
  }

  std::size_t
  NumberOfPoints() const
  {
    return points.size() / 3;
  }
};

/** Throws MeshFileError if a cell refers to a point that is none. */
void
CheckCorners(const CellMesh & mesh);

/** Where the corners of each cell begin. */
std::vector<std::size_t>
CornerBegins(const CellMesh & mesh);

/** The names of the groups that cells have, with blanks for some characters. */
GroupNames
NamesInUse(const CellMesh & mesh, const std::string & characters);

/** Orders the cells by `keys`, one per cell; those with equal keys stay as they are. */
void
SortCells(CellMesh & mesh, const std::vector<std::uint64_t> & keys);

/** Takes points as itk::MeshIOBase passes them. */
void
SetPoints(CellMesh &           mesh,
          const void *         buffer,
          itk::IOComponentEnum type,
          std::size_t          numberOfPoints,
          unsigned int         dimension);

/** Takes cells as itk::MeshIOBase passes them. Throws MeshFileError if it cannot; CheckCorners() finds the rest. */
void
SetCells(CellMesh &           mesh,
         const void *         buffer,
         itk::IOComponentEnum type,
         std::size_t          bufferSize,
         std::size_t          numberOfCells);

/** The cells as itk::MeshIOBase passes them: type, number of points, point identifiers, type, ... */
std::vector<itk::IdentifierType>
MakeCellBuffer(const CellMesh & mesh);

/** From LPS to RAS, and back. */
void
TurnLPSAndRAS(CellMesh & mesh);
} // namespace mmm

#endif
