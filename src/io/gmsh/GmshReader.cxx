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
#include "io/gmsh/GmshReader.h"
#include "io/gmsh/GmshReader2.h"
#include "io/gmsh/GmshReader4.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>

namespace mmm
{
namespace
{
/** A binary file has the number 1, as the machine that wrote it has it. */
void
ReadByteOrder(FileCursor & cursor)
{
  cursor.Line();
  cursor.SetBinary(false);
  const int value = cursor.Int();
  if (value != 1 && value != 1 << 24)
  {
    cursor.Fail("there is no number 1 to tell the order of bytes");
  }
  cursor.SetBinary(value != 1);
}
} // namespace

void
GmshReader::AddNode(std::uint64_t number)
{
  m_Nodes.Add(number);
  for (int axis = 0; axis < 3; ++axis)
  {
    m_Mesh.points.push_back(m_Cursor.Real());
  }
}

std::uint8_t
GmshReader::FindShape(int gmshType) const
{
  const auto shape = std::find_if(std::begin(CellShapes), std::end(CellShapes), [&](const CellShape & candidate) {
    return candidate.gmshType == gmshType;
  });
  if (shape == std::end(CellShapes))
  {
    m_Cursor.Fail("there is an element of Gmsh's type " + std::to_string(gmshType) +
                  "; points, lines, triangles, quadrangles, tetrahedra and hexahedra of first order are read");
  }
  return static_cast<std::uint8_t>(shape - std::begin(CellShapes));
}

void
GmshReader::ReadPhysicalNames()
{
  // These are text in binary files, too.
  const std::uint64_t count = m_Cursor.SizeWord();
  for (std::uint64_t i = 0; i < count; ++i)
  {
    const int              dimension = m_Cursor.IntWord();
    const int              tag = m_Cursor.IntWord();
    const std::string_view line = m_Cursor.Line();
    const auto             begin = line.find('"');
    const auto             end = line.rfind('"');
    if (begin == std::string_view::npos || begin == end)
    {
      m_Cursor.Fail("a physical group has no name in quotation marks");
    }
    m_Mesh.names[{ dimension, tag }] = std::string(line.substr(begin + 1, end - begin - 1));
  }
}

void
GmshReader::ReadSections()
{
  bool hasNodes = false;
  bool hasElements = false;
  while (!m_Cursor.AtEnd())
  {
    const std::string section(m_Cursor.Word());
    if (section.size() < 2 || section.front() != '$')
    {
      m_Cursor.Fail(Quoted(section) + " is no section");
    }
    m_Cursor.Line();
    if (section == "$PhysicalNames")
    {
      this->ReadPhysicalNames();
    }
    else if (section == "$Entities")
    {
      this->ReadEntities();
    }
    else if (section == "$Nodes" && !hasNodes)
    {
      hasNodes = true;
      this->ReadNodes();
      m_Nodes.Finish();
    }
    else if (section == "$Elements" && hasNodes && !hasElements)
    {
      hasElements = true;
      this->ReadElements();
    }
    else if (section == "$Nodes" || section == "$Elements")
    {
      m_Cursor.Fail("there is a second section " + section + ", or one before its nodes");
    }
    else
    {
      m_Cursor.SkipPast("$End" + section.substr(1));
      continue;
    }
    m_Cursor.Expect("$End" + section.substr(1));
  }
  if (!hasNodes || !hasElements)
  {
    m_Cursor.Fail("the file ends without " + std::string(hasNodes ? "$Elements" : "$Nodes"));
  }
}

bool
ReadGmsh(std::string_view bytes, CellMesh & mesh)
{
  FileCursor cursor(bytes);
  cursor.Expect("$MeshFormat");
  const std::string version(cursor.Word());
  const int         isBinary = cursor.IntWord();
  const int         dataSize = cursor.IntWord();
  if (dataSize != 8)
  {
    cursor.Fail("numbers have " + std::to_string(dataSize) + " bytes; files with 8 are read");
  }
  if (isBinary != 0 && isBinary != 1)
  {
    cursor.Fail("the file type is " + std::to_string(isBinary) + "; it has to be 0 (text) or 1 (binary)");
  }
  std::unique_ptr<GmshReader> reader;
  if (version == "4.1")
  {
    reader = std::make_unique<GmshReader4>(cursor, mesh);
  }
  else if (version == "2" || (version.size() == 3 && version.compare(0, 2, "2.") == 0))
  {
    reader = std::make_unique<GmshReader2>(cursor, mesh);
  }
  else
  {
    cursor.Fail("the version is " + Quoted(version) + "; 2.2 and 4.1 are read");
  }
  if (isBinary == 1)
  {
    ReadByteOrder(cursor);
  }
  cursor.Expect("$EndMeshFormat");
  reader->ReadSections();
  SortCells(mesh, reader->m_ElementNumbers);
  return !reader->DropsGroups();
}
} // namespace mmm
