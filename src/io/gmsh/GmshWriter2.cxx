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
#include "io/gmsh/GmshWriter2.h"

#include "io/gmsh/GmshOrder.h"

#include <algorithm>
#include <limits>

namespace mmm
{
namespace
{
/** Elements come in runs of one shape. */
std::size_t
EndOfRun(const CellMesh & mesh, std::size_t begin)
{
  const auto first = mesh.shapes.begin() + begin;
  return std::find_if(first, mesh.shapes.end(), [&](std::uint8_t shape) { return shape != *first; }) -
         mesh.shapes.begin();
}
} // namespace

void
WriteGmshSections2(FileComposer & file, const CellMesh & mesh, bool isBinary)
{
  constexpr std::size_t limit = std::numeric_limits<int>::max();
  if (mesh.NumberOfPoints() > limit || mesh.shapes.size() > limit)
  {
    throw MeshFileError("it has more points or cells than files of version 2.2 can number; take version 4.1");
  }
  file.Text("$Nodes\n" + std::to_string(mesh.NumberOfPoints()) + '\n');
  for (std::size_t i = 0; i < mesh.NumberOfPoints(); ++i)
  {
    file.Int(static_cast<int>(i + 1));
    for (int axis = 0; axis < 3; ++axis)
    {
      file.Real(mesh.points[3 * i + axis]);
    }
    file.EndLine();
  }
  file.EndNumbers();
  file.Text("$EndNodes\n$Elements\n" + std::to_string(mesh.shapes.size()) + '\n');

  // Each element has an elementary entity as well. Those of a physical group share one, of the same number; so do those
  // without group, for which a number is left.
  const int highest = mesh.tags.empty() ? 0 : std::max(0, *std::max_element(mesh.tags.begin(), mesh.tags.end()));
  const int spare = highest < std::numeric_limits<int>::max() ? highest + 1 : 1;
  auto      corner = mesh.corners.begin();
  for (std::size_t begin = 0, end = 0; begin < mesh.shapes.size(); begin = end)
  {
    end = EndOfRun(mesh, begin);
    const CellShape & shape = mesh.ShapeOf(begin);
    if (isBinary)
    {
      file.Int(shape.gmshType);
      file.Int(static_cast<int>(end - begin));
      file.Int(2);
    }
    for (std::size_t i = begin; i < end; ++i)
    {
      const int tag = mesh.GroupOf(i).second;
      file.Int(static_cast<int>(i + 1));
      if (!isBinary)
      {
        file.Int(shape.gmshType);
        file.Int(2);
      }
      file.Int(tag);
      file.Int(tag == 0 ? spare : tag);
      for (std::size_t k = 0; k < shape.corners; ++k)
      {
        file.Int(static_cast<int>(corner[CornerOfGmsh(shape, k)] + 1));
      }
      corner += shape.corners;
      file.EndLine();
    }
  }
  file.EndNumbers();
  file.Text("$EndElements\n");
}
} // namespace mmm
