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

void
ReadPhysicalNames(FileCursor & cursor, GroupNames & names)
{
  // These are text in binary files, too.
  const std::uint64_t count = cursor.SizeWord();
  for (std::uint64_t i = 0; i < count; ++i)
  {
    const int              dimension = cursor.IntWord();
    const int              tag = cursor.IntWord();
    const std::string_view line = cursor.Line();
    const auto             begin = line.find('"');
    const auto             end = line.rfind('"');
    if (begin == std::string_view::npos || begin == end)
    {
      cursor.Fail("a physical group has no name in quotation marks");
    }
    names[{ dimension, tag }] = std::string(line.substr(begin + 1, end - begin - 1));
  }
}

void
ReadSections(GmshContext & gmsh, bool isVersion2)
{
  bool hasNodes = false;
  bool hasElements = false;
  while (!gmsh.cursor.AtEnd())
  {
    const std::string section(gmsh.cursor.Word());
    if (section.size() < 2 || section.front() != '$')
    {
      gmsh.cursor.Fail(Quoted(section) + " is no section");
    }
    gmsh.cursor.Line();
    if (section == "$PhysicalNames")
    {
      ReadPhysicalNames(gmsh.cursor, gmsh.mesh.names);
    }
    else if (section == "$Entities")
    {
      if (isVersion2)
      {
        gmsh.cursor.Fail("there are $Entities, which this version does not have");
      }
      ReadEntities4(gmsh);
    }
    else if (section == "$Nodes" && !hasNodes)
    {
      hasNodes = true;
      isVersion2 ? ReadNodes2(gmsh) : ReadNodes4(gmsh);
      gmsh.nodes.Finish();
    }
    else if (section == "$Elements" && hasNodes && !hasElements)
    {
      hasElements = true;
      isVersion2 ? ReadElements2(gmsh) : ReadElements4(gmsh);
    }
    else if (section == "$Nodes" || section == "$Elements")
    {
      gmsh.cursor.Fail("there is a second section " + section + ", or one before its nodes");
    }
    else
    {
      gmsh.cursor.SkipPast("$End" + section.substr(1));
      continue;
    }
    gmsh.cursor.Expect("$End" + section.substr(1));
  }
  if (!hasNodes || !hasElements)
  {
    gmsh.cursor.Fail("the file ends without " + std::string(hasNodes ? "$Elements" : "$Nodes"));
  }
}
} // namespace

bool
ReadGmsh(std::string_view bytes, CellMesh & mesh)
{
  GmshContext  gmsh{ FileCursor(bytes), mesh, {}, {}, {} };
  FileCursor & cursor = gmsh.cursor;
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
  const bool isVersion2 = version == "2" || (version.size() == 3 && version.compare(0, 2, "2.") == 0);
  if (!isVersion2 && version != "4.1")
  {
    cursor.Fail("the version is " + Quoted(version) + "; 2.2 and 4.1 are read");
  }
  if (isBinary == 1)
  {
    ReadByteOrder(cursor);
  }
  cursor.Expect("$EndMeshFormat");
  ReadSections(gmsh, isVersion2);
  SortCells(mesh, gmsh.elementNumbers);
  return !gmsh.dropsGroups;
}
} // namespace mmm
