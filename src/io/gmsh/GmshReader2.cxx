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
#include "io/gmsh/GmshReader2.h"

namespace mmm
{
void
GmshReader2::ReadEntities()
{
  m_Cursor.Fail("there are $Entities, which this version does not have");
}

void
GmshReader2::ReadNodes()
{
  const std::uint64_t count = m_Cursor.SizeWord();
  if (m_Cursor.IsBinary())
  {
    m_Cursor.Line();
  }
  m_Cursor.CheckCount(count, 4, 4 + 3 * 8, "nodes");
  m_Mesh.points.reserve(3 * count);
  for (std::uint64_t i = 0; i < count; ++i)
  {
    this->AddNode(static_cast<std::uint32_t>(m_Cursor.Int()));
  }
}

void
GmshReader2::ReadElement(std::uint8_t shape, int numberOfTags)
{
  int physical = 0;
  for (int i = 0; i < numberOfTags; ++i)
  {
    const int tag = m_Cursor.Int();
    physical = i == 0 ? tag : physical;
  }
  m_Mesh.shapes.push_back(shape);
  m_Mesh.tags.push_back(physical);
  for (std::size_t corner = 0; corner < CellShapes[shape].corners; ++corner)
  {
    m_Mesh.corners.push_back(m_Nodes.Find(static_cast<std::uint32_t>(m_Cursor.Int())));
  }
}

void
GmshReader2::ReadElements()
{
  const std::uint64_t count = m_Cursor.SizeWord();
  if (m_Cursor.IsBinary())
  {
    m_Cursor.Line();
  }
  // A number and a corner at least.
  m_Cursor.CheckCount(count, 2, 8, "elements");
  while (m_Mesh.shapes.size() < count)
  {
    if (m_Cursor.IsBinary())
    {
      const std::uint8_t shape = this->FindShape(m_Cursor.Int());
      const int          inBlock = m_Cursor.Int();
      const int          numberOfTags = m_Cursor.Int();
      if (inBlock < 1 || static_cast<std::uint64_t>(inBlock) > count - m_Mesh.shapes.size())
      {
        m_Cursor.Fail("a block has " + std::to_string(inBlock) + " elements, which is not what the section announces");
      }
      for (int i = 0; i < inBlock; ++i)
      {
        m_ElementNumbers.push_back(static_cast<std::uint32_t>(m_Cursor.Int()));
        this->ReadElement(shape, numberOfTags);
      }
    }
    else
    {
      m_ElementNumbers.push_back(static_cast<std::uint32_t>(m_Cursor.Int()));
      const std::uint8_t shape = this->FindShape(m_Cursor.Int());
      this->ReadElement(shape, m_Cursor.Int());
    }
  }
}
} // namespace mmm
