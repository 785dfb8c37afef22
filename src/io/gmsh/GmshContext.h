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
#ifndef mmmGmshContext_h
#define mmmGmshContext_h

#include "io/CellMesh.h"
#include "io/FileCursor.h"
#include "io/gmsh/GmshNodes.h"

#include <algorithm>
#include <iterator>

namespace mmm
{
/** \brief What the sections of a Gmsh file are read from and into. */
struct GmshContext
{
  FileCursor                 cursor;
  CellMesh &                 mesh;
  GmshNodes                  nodes;
  std::vector<std::uint64_t> elementNumbers;
  /** The first physical group of an entity, by its dimension and tag; version 4.1 has such. */
  std::map<std::pair<int, int>, int> groups;
  /** Whether an entity belongs to several physical groups, of which the mesh has the first. */
  bool dropsGroups{ false };

  /** The next numbers are those of the coordinates of this node. */
  void
  AddNode(std::uint64_t number)
  {
    nodes.Add(number);
    for (int axis = 0; axis < 3; ++axis)
    {
      mesh.points.push_back(cursor.Real());
    }
  }

  /** The place in CellShapes of Gmsh's type of element. Throws MeshFileError if it has none. */
  std::uint8_t
  FindShape(int gmshType) const
  {
    const auto shape = std::find_if(std::begin(CellShapes), std::end(CellShapes), [&](const CellShape & candidate) {
      return candidate.gmshType == gmshType && !candidate.IsOfSecondOrder();
    });
    if (shape == std::end(CellShapes))
    {
      cursor.Fail("there is an element of Gmsh's type " + std::to_string(gmshType) +
                  "; points, lines, triangles, quadrangles, tetrahedra and hexahedra of first order are read");
    }
    return static_cast<std::uint8_t>(shape - std::begin(CellShapes));
  }

  /** The next numbers are those of the corners of an element. */
  template <typename TReadNumber>
  void
  AddElement(std::uint64_t number, std::uint8_t shape, int tag, const TReadNumber & readNumber)
  {
    elementNumbers.push_back(number);
    mesh.shapes.push_back(shape);
    mesh.tags.push_back(tag);
    for (std::size_t corner = 0; corner < CellShapes[shape].corners; ++corner)
    {
      mesh.corners.push_back(nodes.Find(readNumber()));
    }
  }
};
} // namespace mmm

#endif
