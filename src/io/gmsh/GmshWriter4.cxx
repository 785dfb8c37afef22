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
#include "io/gmsh/GmshWriter4.h"

#include "io/gmsh/GmshOrder.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <vector>

namespace mmm
{
namespace
{
/** The cells of one shape that are in one group. */
struct Block
{
  std::uint8_t             shape;
  std::vector<std::size_t> cells;
};

struct Entity
{
  int                   tag{ 0 };
  std::array<double, 3> minimum{ { 0.0, 0.0, 0.0 } };
  std::array<double, 3> maximum{ { 0.0, 0.0, 0.0 } };
  std::vector<Block>    blocks;
};

using Entities = std::map<Group, Entity>;

Block &
BlockOf(Entity & entity, std::uint8_t shape)
{
  auto block =
    std::find_if(entity.blocks.begin(), entity.blocks.end(), [&](const Block & b) { return b.shape == shape; });
  return block == entity.blocks.end() ? entity.blocks.emplace_back(Block{ shape, {} }) : *block;
}

void
Enclose(Entity & entity, bool isFirst, const double * point)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    entity.minimum[axis] = isFirst ? point[axis] : std::min(entity.minimum[axis], point[axis]);
    entity.maximum[axis] = isFirst ? point[axis] : std::max(entity.maximum[axis], point[axis]);
  }
}

Entities
FindEntities(const CellMesh & mesh, const std::vector<std::size_t> & begins)
{
  Entities entities;
  for (std::size_t i = 0; i < mesh.shapes.size(); ++i)
  {
    Entity & entity = entities[mesh.GroupOf(i)];
    for (std::size_t k = 0; k < mesh.ShapeOf(i).corners; ++k)
    {
      Enclose(entity, entity.blocks.empty() && k == 0, &mesh.points[3 * mesh.corners[begins[i] + k]]);
    }
    BlockOf(entity, mesh.shapes[i]).cells.push_back(i);
  }
  if (entities.empty() && !mesh.points.empty())
  {
    // Nodes have to belong to something.
    Enclose(entities[Group(0, 0)], true, mesh.points.data());
  }
  for (auto & [group, entity] : entities)
  {
    // Gmsh exports to other formats with the entity's number. A group of cells without number has the first free one.
    entity.tag = group.second;
    for (int tag = 1; entity.tag == 0; ++tag)
    {
      entity.tag = entities.count({ group.first, tag }) == 0 ? tag : 0;
    }
  }
  return entities;
}

void
WriteEntities(FileComposer & file, const Entities & entities)
{
  file.Text("$Entities\n");
  for (int dimension = 0; dimension < 4; ++dimension)
  {
    file.Size(std::count_if(
      entities.begin(), entities.end(), [&](const auto & entry) { return entry.first.first == dimension; }));
  }
  file.EndLine();
  for (const auto & [group, entity] : entities)
  {
    file.Int(entity.tag);
    for (const double coordinate : entity.minimum)
    {
      file.Real(coordinate);
    }
    for (const double coordinate : entity.maximum)
    {
      if (group.first > 0)
      {
        file.Real(coordinate);
      }
    }
    file.Size(group.second == 0 ? 0 : 1);
    if (group.second != 0)
    {
      file.Int(group.second);
    }
    if (group.first > 0)
    {
      // What bounds it is not told.
      file.Size(0);
    }
    file.EndLine();
  }
  file.EndNumbers();
  file.Text("$EndEntities\n");
}

/** All of them belong to the last entity, one of the highest dimension. */
void
WriteNodes(FileComposer & file, const CellMesh & mesh, const Entities & entities)
{
  const std::size_t count = mesh.NumberOfPoints();
  file.Text("$Nodes\n");
  for (const std::size_t number : { std::size_t(count > 0), count, std::size_t(count > 0), count })
  {
    file.Size(number);
  }
  file.EndLine();
  if (count > 0)
  {
    file.Int(entities.rbegin()->first.first);
    file.Int(entities.rbegin()->second.tag);
    file.Int(0);
    file.Size(count);
    file.EndLine();
    for (std::size_t i = 0; i < count; ++i)
    {
      file.Size(i + 1);
      file.EndLine();
    }
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
    {
      file.Real(mesh.points[i]);
      if (i % 3 == 2)
      {
        file.EndLine();
      }
    }
  }
  file.EndNumbers();
  file.Text("$EndNodes\n");
}

void
WriteElements(FileComposer &                   file,
              const CellMesh &                 mesh,
              const Entities &                 entities,
              const std::vector<std::size_t> & begins,
              bool                             isNumberedInOrder)
{
  std::size_t       number = 0;
  const std::size_t count = mesh.shapes.size();
  std::size_t       blocks = 0;
  for (const auto & entry : entities)
  {
    blocks += entry.second.blocks.size();
  }
  file.Text("$Elements\n");
  for (const std::size_t value : { blocks, count, std::size_t(count > 0), count })
  {
    file.Size(value);
  }
  file.EndLine();
  for (const auto & [group, entity] : entities)
  {
    for (const Block & block : entity.blocks)
    {
      file.Int(group.first);
      file.Int(entity.tag);
      const CellShape & shape = CellShapes[block.shape];
      file.Int(shape.gmshType);
      file.Size(block.cells.size());
      file.EndLine();
      for (const std::size_t cell : block.cells)
      {
        ++number;
        file.Size(isNumberedInOrder ? number : cell + 1);
        for (std::size_t k = 0; k < shape.corners; ++k)
        {
          file.Size(mesh.corners[begins[cell] + CornerOfGmsh(shape, k)] + 1);
        }
        file.EndLine();
      }
    }
  }
  file.EndNumbers();
  file.Text("$EndElements\n");
}
} // namespace

std::vector<std::size_t>
WriteGmshSections4(FileComposer & file, const CellMesh & mesh, bool isNumberedInOrder)
{
  const auto     begins = CornerBegins(mesh);
  const Entities entities = FindEntities(mesh, begins);
  WriteEntities(file, entities);
  WriteNodes(file, mesh, entities);
  WriteElements(file, mesh, entities, begins, isNumberedInOrder);
  std::vector<std::size_t> order;
  for (const auto & entry : entities)
  {
    for (const Block & block : entry.second.blocks)
    {
      order.insert(order.end(), block.cells.begin(), block.cells.end());
    }
  }
  return order;
}
} // namespace mmm
