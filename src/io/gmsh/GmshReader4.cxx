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
#include "io/gmsh/GmshReader4.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace mmm
{
namespace
{
void
ReadEntity(GmshContext & gmsh, int dimension)
{
  const int tag = gmsh.cursor.Int();
  // A point has its coordinates, all others a box.
  for (int i = 0; i < (dimension == 0 ? 3 : 6); ++i)
  {
    gmsh.cursor.Real();
  }
  const std::uint64_t groups = gmsh.cursor.Size();
  gmsh.cursor.CheckCount(groups, 1, 4, "physical groups of an entity");
  for (std::uint64_t i = 0; i < groups; ++i)
  {
    // The sign is that of the entity's orientation.
    const int  group = std::abs(std::max(gmsh.cursor.Int(), -std::numeric_limits<int>::max()));
    const bool isFirst = gmsh.groups.emplace(std::make_pair(dimension, tag), group).second;
    gmsh.dropsGroups = gmsh.dropsGroups || !isFirst;
  }
  if (dimension > 0)
  {
    const std::uint64_t bounds = gmsh.cursor.Size();
    gmsh.cursor.CheckCount(bounds, 1, 4, "bounds of an entity");
    for (std::uint64_t i = 0; i < bounds; ++i)
    {
      gmsh.cursor.Int();
    }
  }
}

} // namespace

void
ReadEntities4(GmshContext & gmsh)
{
  std::uint64_t counts[4];
  for (std::uint64_t & count : counts)
  {
    count = gmsh.cursor.Size();
  }
  for (int dimension = 0; dimension < 4; ++dimension)
  {
    gmsh.cursor.CheckCount(counts[dimension], 5, 4 + 3 * 8 + 8, "entities");
    for (std::uint64_t i = 0; i < counts[dimension]; ++i)
    {
      ReadEntity(gmsh, dimension);
    }
  }
}

void
ReadNodes4(GmshContext & gmsh)
{
  const std::uint64_t blocks = gmsh.cursor.Size();
  const std::uint64_t count = gmsh.cursor.Size();
  gmsh.cursor.Size(); // the lowest number of a node
  gmsh.cursor.Size(); // the highest one
  gmsh.cursor.CheckCount(count, 4, 8 + 3 * 8, "nodes");
  gmsh.mesh.points.reserve(3 * count);
  std::vector<std::uint64_t> numbers;
  for (std::uint64_t block = 0; block < blocks; ++block)
  {
    const int dimension = gmsh.cursor.Int();
    gmsh.cursor.Int(); // the entity's tag
    const int           hasParameters = gmsh.cursor.Int();
    const std::uint64_t inBlock = gmsh.cursor.Size();
    gmsh.cursor.CheckCount(inBlock, 4, 8 + 3 * 8, "nodes in a block");
    numbers.clear();
    for (std::uint64_t i = 0; i < inBlock; ++i)
    {
      numbers.push_back(gmsh.cursor.Size());
    }
    for (const std::uint64_t number : numbers)
    {
      gmsh.AddNode(number);
      for (int i = 0; hasParameters != 0 && i < dimension; ++i)
      {
        gmsh.cursor.Real();
      }
    }
  }
  if (gmsh.mesh.NumberOfPoints() != count)
  {
    gmsh.cursor.Fail("there are " + std::to_string(gmsh.mesh.NumberOfPoints()) + " nodes, where " +
                     std::to_string(count) + " are announced");
  }
}

void
ReadElements4(GmshContext & gmsh)
{
  const std::uint64_t blocks = gmsh.cursor.Size();
  const std::uint64_t count = gmsh.cursor.Size();
  gmsh.cursor.Size(); // the lowest number of an element
  gmsh.cursor.Size(); // the highest one
  gmsh.cursor.CheckCount(count, 2, 16, "elements");
  gmsh.mesh.shapes.reserve(count);
  gmsh.mesh.tags.reserve(count);
  gmsh.elementNumbers.reserve(count);
  for (std::uint64_t block = 0; block < blocks; ++block)
  {
    const int           dimension = gmsh.cursor.Int();
    const int           entity = gmsh.cursor.Int();
    const std::uint8_t  shape = gmsh.FindShape(gmsh.cursor.Int());
    const std::uint64_t inBlock = gmsh.cursor.Size();
    const std::size_t   corners = CellShapes[shape].corners;
    gmsh.cursor.CheckCount(inBlock, 1 + corners, 8 * (1 + corners), "elements in a block");
    if (dimension != CellShapes[shape].dimension)
    {
      gmsh.cursor.Fail("the elements of an entity of dimension " + std::to_string(dimension) + " have another one");
    }
    const auto group = gmsh.groups.find({ dimension, entity });
    const int  tag = group == gmsh.groups.end() ? 0 : group->second;
    for (std::uint64_t i = 0; i < inBlock; ++i)
    {
      const std::uint64_t number = gmsh.cursor.Size();
      gmsh.AddElement(number, shape, tag, [&] { return gmsh.cursor.Size(); });
    }
  }
  if (gmsh.mesh.shapes.size() != count)
  {
    gmsh.cursor.Fail("there are " + std::to_string(gmsh.mesh.shapes.size()) + " elements, where " +
                     std::to_string(count) + " are announced");
  }
}
} // namespace mmm
