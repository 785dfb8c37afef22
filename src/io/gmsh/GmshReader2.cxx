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
namespace
{
/** The count that a section begins with, in text always. */
std::uint64_t
ReadCount(FileCursor & cursor)
{
  const std::uint64_t count = cursor.SizeWord();
  if (cursor.IsBinary())
  {
    cursor.Line();
  }
  return count;
}

void
ReadElement(GmshContext & gmsh, std::uint64_t number, std::uint8_t shape, int numberOfTags)
{
  int physical = 0;
  for (int i = 0; i < numberOfTags; ++i)
  {
    const int tag = gmsh.cursor.Int();
    physical = i == 0 ? tag : physical;
  }
  gmsh.AddElement(number, shape, physical, [&] { return static_cast<std::uint32_t>(gmsh.cursor.Int()); });
}
} // namespace

void
ReadNodes2(GmshContext & gmsh)
{
  const std::uint64_t count = ReadCount(gmsh.cursor);
  gmsh.cursor.CheckCount(count, 4, 4 + 3 * 8, "nodes");
  gmsh.mesh.points.reserve(3 * count);
  for (std::uint64_t i = 0; i < count; ++i)
  {
    gmsh.AddNode(static_cast<std::uint32_t>(gmsh.cursor.Int()));
  }
}

void
ReadElements2(GmshContext & gmsh)
{
  const std::uint64_t count = ReadCount(gmsh.cursor);
  // A number and a corner at least.
  gmsh.cursor.CheckCount(count, 2, 8, "elements");
  while (gmsh.mesh.shapes.size() < count)
  {
    if (gmsh.cursor.IsBinary())
    {
      const std::uint8_t shape = gmsh.FindShape(gmsh.cursor.Int());
      const int          inBlock = gmsh.cursor.Int();
      const int          numberOfTags = gmsh.cursor.Int();
      if (inBlock < 1 || static_cast<std::uint64_t>(inBlock) > count - gmsh.mesh.shapes.size())
      {
        gmsh.cursor.Fail("a block has " + std::to_string(inBlock) +
                         " elements, which is not what the section announces");
      }
      for (int i = 0; i < inBlock; ++i)
      {
        const auto number = static_cast<std::uint32_t>(gmsh.cursor.Int());
        ReadElement(gmsh, number, shape, numberOfTags);
      }
    }
    else
    {
      const auto         number = static_cast<std::uint32_t>(gmsh.cursor.Int());
      const std::uint8_t shape = gmsh.FindShape(gmsh.cursor.Int());
      ReadElement(gmsh, number, shape, gmsh.cursor.Int());
    }
  }
}
} // namespace mmm
