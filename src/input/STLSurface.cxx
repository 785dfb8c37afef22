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
#include "input/SurfaceFile.h"

#include "itkByteSwapper.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <locale>
#include <sstream>

namespace mmm
{
namespace
{
constexpr std::size_t HeaderSize = 80;
constexpr std::size_t TriangleSize = 50;

template <typename T>
T
LittleEndian(const char * bytes)
{
  T value;
  std::memcpy(&value, bytes, sizeof value);
  itk::ByteSwapper<T>::SwapFromSystemToLittleEndian(&value);
  return value;
}

/** Files have the corners of each triangle anew. */
void
AddTriangle(const std::array<itk::Point<double, 3>, 3> & corners, SurfaceTriangles & surface)
{
  const auto first = surface.points.size();
  surface.points.insert(surface.points.end(), corners.begin(), corners.end());
  surface.triangles.push_back({ { first, first + 1, first + 2 } });
}

SurfaceTriangles
ParseBinary(const std::string & bytes)
{
  SurfaceTriangles surface;
  for (std::size_t at = HeaderSize + 4; at + TriangleSize <= bytes.size(); at += TriangleSize)
  {
    // a normal comes first
    const char *                         number = bytes.data() + at + 12;
    std::array<itk::Point<double, 3>, 3> corners;
    for (auto & corner : corners)
    {
      for (unsigned int axis = 0; axis < 3; ++axis, number += 4)
      {
        corner[axis] = LittleEndian<float>(number);
      }
    }
    AddTriangle(corners, surface);
  }
  return surface;
}

SurfaceTriangles
ParseText(const std::string & fileName, const std::string & bytes)
{
  SurfaceTriangles   surface;
  std::istringstream lines(bytes);
  lines.imbue(std::locale::classic());
  std::array<itk::Point<double, 3>, 3> corners;
  std::size_t                          corner = 0;
  std::size_t                          number = 0;
  bool                                 isComplete = false;
  for (std::string line; std::getline(lines, line);)
  {
    ++number;
    std::istringstream words(line);
    words.imbue(std::locale::classic());
    std::string word;
    words >> word;
    if (word == "vertex")
    {
      if (corner == 3 || !(words >> corners[corner][0] >> corners[corner][1] >> corners[corner][2]))
      {
        ThrowDamagedSurface(fileName, "line " + std::to_string(number) + " is no corner of a triangle");
      }
      ++corner;
    }
    else if (word == "endloop")
    {
      if (corner != 3)
      {
        ThrowDamagedSurface(fileName, "the triangle before line " + std::to_string(number) + " has no three corners");
      }
      AddTriangle(corners, surface);
      corner = 0;
    }
    isComplete = isComplete || word == "endsolid";
  }
  if (!isComplete || corner != 0)
  {
    ThrowDamagedSurface(fileName, "its end is missing");
  }
  return surface;
}
} // namespace

SurfaceFile
ParseSTL(const std::string & fileName, const std::string & bytes)
{
  SurfaceFile file;
  // headers of binary files may begin like those of texts
  const bool hasHeader = bytes.size() >= HeaderSize + 4;
  const auto count = hasHeader ? LittleEndian<std::uint32_t>(bytes.data() + HeaderSize) : 0u;
  if (hasHeader && bytes.size() == HeaderSize + 4 + TriangleSize * std::size_t{ count })
  {
    file.surface = ParseBinary(bytes);
  }
  else if (bytes.compare(0, 5, "solid") == 0)
  {
    file.surface = ParseText(fileName, bytes);
  }
  else
  {
    ThrowDamagedSurface(fileName,
                        "its size is not that of the " + std::to_string(count) + " triangles that its header says");
  }
  return file;
}
} // namespace mmm
