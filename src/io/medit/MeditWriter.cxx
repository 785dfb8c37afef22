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
#include "io/FileComposer.h"
#include "io/medit/Medit.h"

#include <algorithm>
#include <iterator>

namespace mmm
{
namespace
{
/** Of those groups of the mesh whose names tell more than their tags. */
void
WriteGroups(FileComposer & file, const CellMesh & mesh)
{
  for (const auto & [group, name] : NamesInUse(mesh, "\n\r"))
  {
    if (name != "label " + std::to_string(group.second))
    {
      file.Text(std::string(meditGroupComment) + ' ' + std::to_string(group.first) + ' ' +
                std::to_string(group.second) + ": " + name + '\n');
    }
  }
}

void
WriteCells(FileComposer & file, const CellMesh & mesh, std::uint8_t shape)
{
  const auto        count = std::count(mesh.shapes.begin(), mesh.shapes.end(), shape);
  const std::size_t corners = CellShapes[shape].corners;
  if (count == 0)
  {
    return;
  }
  if (*CellShapes[shape].meditKeyword == '\0')
  {
    throw MeshFileError(
      std::string(CellShapes[shape].IsOfSecondOrder() ? "it has cells of second order" : "it has vertices as cells") +
      ", which such files have not");
  }
  file.Text(std::string(CellShapes[shape].meditKeyword) + '\n' + std::to_string(count) + '\n');
  auto corner = mesh.corners.begin();
  for (std::size_t i = 0; i < mesh.shapes.size(); ++i)
  {
    if (mesh.shapes[i] == shape)
    {
      for (std::size_t k = 0; k < corners; ++k)
      {
        file.Size(corner[k] + 1);
      }
      file.Int(mesh.GroupOf(i).second);
      file.EndLine();
    }
    corner += mesh.ShapeOf(i).corners;
  }
}
} // namespace

void
WriteMedit(const std::string & fileName, const CellMesh & mesh)
{
  FileComposer file(fileName, false);
  // Coordinates are doubles.
  file.Text("MeshVersionFormatted 2\nDimension 3\n");
  WriteGroups(file, mesh);
  file.Text("Vertices\n" + std::to_string(mesh.NumberOfPoints()) + '\n');
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    file.Real(mesh.points[i]);
    if (i % 3 == 2)
    {
      file.Int(0);
      file.EndLine();
    }
  }
  for (std::size_t shape = 0; shape < std::size(CellShapes); ++shape)
  {
    WriteCells(file, mesh, static_cast<std::uint8_t>(shape));
  }
  file.Text("End\n");
  file.Commit();
}
} // namespace mmm
