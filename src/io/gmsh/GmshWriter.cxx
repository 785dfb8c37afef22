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
#include "io/gmsh/GmshWriter.h"
#include "io/FileComposer.h"
#include "io/gmsh/GmshElementData.h"
#include "io/gmsh/GmshWriter2.h"
#include "io/gmsh/GmshWriter4.h"

#include <numeric>

namespace mmm
{
namespace
{
/** Those of the groups that the mesh has. */
void
WritePhysicalNames(FileComposer & file, const CellMesh & mesh)
{
  std::string names;
  std::size_t count = 0;
  for (const auto & [group, name] : NamesInUse(mesh, "\"\n\r"))
  {
    if (group.second != 0)
    {
      names += std::to_string(group.first) + ' ' + std::to_string(group.second) + " \"" + name + "\"\n";
      ++count;
    }
  }
  if (count > 0)
  {
    file.Text("$PhysicalNames\n" + std::to_string(count) + '\n' + names + "$EndPhysicalNames\n");
  }
}
} // namespace

void
WriteGmsh(const std::string & fileName, const CellMesh & mesh, const CellArrays & arrays, const GmshFormat & format)
{
  FileComposer file(fileName, format.isBinary);
  file.Text("$MeshFormat\n" + std::string(format.isVersion2 ? "2.2 " : "4.1 ") + (format.isBinary ? "1 8\n" : "0 8\n"));
  if (format.isBinary)
  {
    // tells the order of bytes
    file.Int(1);
    file.EndNumbers();
  }
  file.Text("$EndMeshFormat\n");
  if (format.hasNames)
  {
    WritePhysicalNames(file, mesh);
  }
  std::vector<std::size_t> order;
  if (format.isVersion2)
  {
    WriteGmshSections2(file, mesh, format.isBinary);
    order.resize(mesh.shapes.size());
    std::iota(order.begin(), order.end(), std::size_t{ 0 });
  }
  else
  {
    order = WriteGmshSections4(file, mesh, !arrays.empty());
  }
  WriteGmshElementData(file, arrays, order);
  file.Commit();
}
} // namespace mmm
