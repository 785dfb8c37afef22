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
#ifndef mmmGmshReader_h
#define mmmGmshReader_h

#include "io/CellMesh.h"
#include "io/FileCursor.h"
#include "io/gmsh/GmshNodes.h"

#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

namespace mmm
{
/** \brief Reads the mesh of a Gmsh file. Subclasses read the sections that differ between the format's versions. */
class GmshReader
{
public:
  virtual ~GmshReader() = default;

  /** Entities that belong to several physical groups, of which the mesh has the first. */
  bool
  DropsGroups() const
  {
    return m_DropsGroups;
  }

protected:
  GmshReader(FileCursor & cursor, CellMesh & mesh)
    : m_Cursor(cursor)
    , m_Mesh(mesh)
  {}

  virtual void
  ReadEntities() = 0;
  virtual void
  ReadNodes() = 0;
  virtual void
  ReadElements() = 0;

  /** The next numbers are those of the coordinates of this node. */
  void
  AddNode(std::uint64_t number);

  /** The place in CellShapes of Gmsh's type of element. Throws MeshFileError if it has none. */
  std::uint8_t
  FindShape(int gmshType) const;

  FileCursor &               m_Cursor;
  CellMesh &                 m_Mesh;
  GmshNodes                  m_Nodes;
  std::vector<std::uint64_t> m_ElementNumbers;
  bool                       m_DropsGroups{ false };

private:
  friend bool
  ReadGmsh(std::string_view bytes, CellMesh & mesh);

  void
  ReadPhysicalNames();
  void
  ReadSections();
};

/** Reads a .msh file of version 2.2 or 4.1, text or binary. Throws MeshFileError. Returns whether each cell is in one
 * physical group at most; if not, the first one counts. */
bool
ReadGmsh(std::string_view bytes, CellMesh & mesh);
} // namespace mmm

#endif
