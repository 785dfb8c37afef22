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
void
GmshReader4::ReadEntity(int dimension)
{
  const int tag = m_Cursor.Int();
  // A point has its coordinates, all others a box.
  for (int i = 0; i < (dimension == 0 ? 3 : 6); ++i)
  {
    m_Cursor.Real();
  }
  const std::uint64_t groups = m_Cursor.Size();
  m_Cursor.CheckCount(groups, 1, 4, "physical groups of an entity");
  for (std::uint64_t i = 0; i < groups; ++i)
  {
    // The sign is that of the entity's orientation.
    const int  group = std::abs(std::max(m_Cursor.Int(), -std::numeric_limits<int>::max()));
    const bool isFirst = m_Groups.emplace(std::make_pair(dimension, tag), group).second;
    m_DropsGroups = m_DropsGroups || !isFirst;
  }
  if (dimension > 0)
  {
    const std::uint64_t bounds = m_Cursor.Size();
    m_Cursor.CheckCount(bounds, 1, 4, "bounds of an entity");
    for (std::uint64_t i = 0; i < bounds; ++i)
    {
      m_Cursor.Int();
    }
  }
}

void
GmshReader4::ReadEntities()
{
  std::uint64_t counts[4];
  for (std::uint64_t & count : counts)
  {
    count = m_Cursor.Size();
  }
  for (int dimension = 0; dimension < 4; ++dimension)
  {
    m_Cursor.CheckCount(counts[dimension], 5, 4 + 3 * 8 + 8, "entities");
    for (std::uint64_t i = 0; i < counts[dimension]; ++i)
    {
      this->ReadEntity(dimension);
    }
  }
}

void
GmshReader4::ReadNodes()
{
  const std::uint64_t blocks = m_Cursor.Size();
  const std::uint64_t count = m_Cursor.Size();
  m_Cursor.Size(); // the lowest number of a node
  m_Cursor.Size(); // the highest one
  m_Cursor.CheckCount(count, 4, 8 + 3 * 8, "nodes");
  m_Mesh.points.reserve(3 * count);
  std::vector<std::uint64_t> numbers;
  for (std::uint64_t block = 0; block < blocks; ++block)
  {
    const int dimension = m_Cursor.Int();
    m_Cursor.Int(); // the entity's tag
    const int           hasParameters = m_Cursor.Int();
    const std::uint64_t inBlock = m_Cursor.Size();
    m_Cursor.CheckCount(inBlock, 4, 8 + 3 * 8, "nodes in a block");
    numbers.clear();
    for (std::uint64_t i = 0; i < inBlock; ++i)
    {
      numbers.push_back(m_Cursor.Size());
    }
    for (const std::uint64_t number : numbers)
    {
      this->AddNode(number);
      for (int i = 0; hasParameters != 0 && i < dimension; ++i)
      {
        m_Cursor.Real();
      }
    }
  }
  if (m_Mesh.NumberOfPoints() != count)
  {
    m_Cursor.Fail("there are " + std::to_string(m_Mesh.NumberOfPoints()) + " nodes, where " + std::to_string(count) +
                  " are announced");
  }
}

void
GmshReader4::ReadElements()
{
  const std::uint64_t blocks = m_Cursor.Size();
  const std::uint64_t count = m_Cursor.Size();
  m_Cursor.Size(); // the lowest number of an element
  m_Cursor.Size(); // the highest one
  m_Cursor.CheckCount(count, 2, 16, "elements");
  m_Mesh.shapes.reserve(count);
  m_Mesh.tags.reserve(count);
  m_ElementNumbers.reserve(count);
  for (std::uint64_t block = 0; block < blocks; ++block)
  {
    const int           dimension = m_Cursor.Int();
    const int           entity = m_Cursor.Int();
    const std::uint8_t  shape = this->FindShape(m_Cursor.Int());
    const std::uint64_t inBlock = m_Cursor.Size();
    const std::size_t   corners = CellShapes[shape].corners;
    m_Cursor.CheckCount(inBlock, 1 + corners, 8 * (1 + corners), "elements in a block");
    if (dimension != CellShapes[shape].dimension)
    {
      m_Cursor.Fail("the elements of an entity of dimension " + std::to_string(dimension) + " have another one");
    }
    const auto group = m_Groups.find({ dimension, entity });
    const int  tag = group == m_Groups.end() ? 0 : group->second;
    for (std::uint64_t i = 0; i < inBlock; ++i)
    {
      m_ElementNumbers.push_back(m_Cursor.Size());
      m_Mesh.shapes.push_back(shape);
      m_Mesh.tags.push_back(tag);
      for (std::size_t corner = 0; corner < corners; ++corner)
      {
        m_Mesh.corners.push_back(m_Nodes.Find(m_Cursor.Size()));
      }
    }
  }
  if (m_Mesh.shapes.size() != count)
  {
    m_Cursor.Fail("there are " + std::to_string(m_Mesh.shapes.size()) + " elements, where " + std::to_string(count) +
                  " are announced");
  }
}
} // namespace mmm
