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
#include "io/FileCursor.h"
#include "io/medit/Medit.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <limits>

namespace mmm
{
namespace
{
class MeditReader
{
public:
  MeditReader(std::string_view bytes, CellMesh & mesh)
    : m_Cursor(bytes)
    , m_Mesh(mesh)
  {}

  void
  Read()
  {
    this->ExpectKeyword("MeshVersionFormatted");
    const int version = this->Int();
    if (version < 1 || version > 4)
    {
      m_Cursor.Fail("the version is " + std::to_string(version) + "; 1 to 4 are read");
    }
    this->ExpectKeyword("Dimension");
    m_Dimension = this->Int();
    if (m_Dimension != 2 && m_Dimension != 3)
    {
      m_Cursor.Fail("the dimension is " + std::to_string(m_Dimension) + "; it has to be 2 or 3");
    }
    bool hasVertices = false;
    for (std::string keyword = this->Keyword(); keyword != "End"; keyword = this->Keyword())
    {
      if (keyword == "Vertices" && !hasVertices)
      {
        hasVertices = true;
        this->ReadVertices();
      }
      else if (keyword == "Vertices")
      {
        m_Cursor.Fail("there is a second section Vertices");
      }
      else if (const auto shape = FindShape(keyword); shape != std::end(CellShapes))
      {
        this->ReadCells(*shape);
      }
      // Of all others, the numbers are skipped by the search for the next keyword.
    }
    if (!hasVertices)
    {
      m_Cursor.Fail("there are no Vertices");
    }
  }

private:
  static const CellShape *
  FindShape(const std::string & keyword)
  {
    // Gmsh's spelling and the format's.
    const std::string name = keyword == "Hexaedra" ? "Hexahedra" : keyword;
    return std::find_if(std::begin(CellShapes), std::end(CellShapes), [&](const CellShape & shape) {
      return name == shape.meditKeyword;
    });
  }

  /** The next word that is not in a comment. */
  std::string_view
  Word()
  {
    std::string_view word = m_Cursor.Word();
    while (word.front() == '#')
    {
      this->ReadComment(word, m_Cursor.Line());
      word = m_Cursor.Word();
    }
    return word;
  }

  /** "# group 3 7: label -5" */
  void
  ReadComment(std::string_view word, std::string_view rest)
  {
    const std::string comment = std::string(word) + std::string(rest);
    const std::string start = std::string(meditGroupComment) + ' ';
    const auto        colon = comment.find(": ");
    if (comment.compare(0, start.size(), start) != 0 || colon == std::string::npos)
    {
      return;
    }
    FileCursor numbers(std::string_view(comment).substr(start.size(), colon - start.size()));
    try
    {
      const int dimension = numbers.IntWord();
      const int tag = numbers.IntWord();
      m_Mesh.names[{ dimension, tag }] = comment.substr(colon + 2);
    }
    catch (const MeshFileError &)
    {
      // Somebody else's comment.
    }
  }

  /** Skips numbers. */
  std::string
  Keyword()
  {
    std::string_view word = this->Word();
    while (!std::isalpha(static_cast<unsigned char>(word.front())))
    {
      word = this->Word();
    }
    return std::string(word);
  }

  void
  ExpectKeyword(const std::string & expected)
  {
    const std::string_view word = this->Word();
    if (word != expected)
    {
      m_Cursor.Fail(Quoted(word) + " is not " + expected);
    }
  }

  int
  Int()
  {
    return this->Number(&FileCursor::IntWord);
  }

  template <typename T>
  T
  Number(T (FileCursor::*read)())
  {
    FileCursor word(this->Word());
    try
    {
      return (word.*read)();
    }
    catch (const MeshFileError & error)
    {
      // with the line of the file instead of that of the word
      const std::string what = error.what();
      m_Cursor.Fail(what.substr(what.find(", ") + 2));
    }
  }

  std::uint64_t
  Count(std::size_t numbers, const std::string & what)
  {
    const auto count = this->Number(&FileCursor::SizeWord);
    m_Cursor.CheckCount(count, numbers, 0, what);
    return count;
  }

  void
  ReadVertices()
  {
    const std::uint64_t count = this->Count(m_Dimension + 1, "vertices");
    m_Mesh.points.reserve(3 * count);
    for (std::uint64_t i = 0; i < count; ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        m_Mesh.points.push_back(axis < m_Dimension ? this->Number(&FileCursor::RealWord) : 0.0);
      }
      this->Int(); // the vertex's reference
    }
  }

  void
  ReadCells(const CellShape & shape)
  {
    const std::uint64_t count = this->Count(shape.corners + 1, shape.meditKeyword);
    for (std::uint64_t i = 0; i < count; ++i)
    {
      m_Mesh.shapes.push_back(static_cast<std::uint8_t>(&shape - std::begin(CellShapes)));
      for (std::size_t corner = 0; corner < shape.corners; ++corner)
      {
        // 0 becomes too large and is found by CheckCorners().
        m_Mesh.corners.push_back(this->Number(&FileCursor::SizeWord) - 1);
      }
      m_Mesh.tags.push_back(this->Int());
    }
  }

  FileCursor m_Cursor;
  CellMesh & m_Mesh;
  int        m_Dimension{ 3 };
};
} // namespace

void
ReadMedit(std::string_view bytes, CellMesh & mesh)
{
  MeditReader(bytes, mesh).Read();
}
} // namespace mmm
