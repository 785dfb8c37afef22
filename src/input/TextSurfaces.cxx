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

#include <locale>
#include <sstream>

namespace mmm
{
namespace
{
/** The lines of a text, without comments and empty ones. */
class Lines
{
public:
  Lines(const std::string & fileName, const std::string & text)
    : m_FileName(fileName)
    , m_Text(text)
  {}

  bool
  Next()
  {
    for (std::string line; std::getline(m_Text, line);)
    {
      ++m_Number;
      m_Words = std::istringstream(line.substr(0, line.find('#')));
      m_Words.imbue(std::locale::classic());
      if (!(m_Words >> std::ws).eof())
      {
        return true;
      }
    }
    return false;
  }

  /** The next line, which has to be there. */
  void
  Need()
  {
    if (!this->Next())
    {
      ThrowDamagedSurface(m_FileName, "its end is missing");
    }
  }

  template <typename T>
  T
  Read(const char * what)
  {
    T value{};
    if (!(m_Words >> value))
    {
      this->Fail(what);
    }
    return value;
  }

  itk::Point<double, 3>
  ReadPoint()
  {
    itk::Point<double, 3> point;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      point[axis] = this->Read<double>("point");
    }
    return point;
  }

  /** Whether there is more on the line. */
  bool
  HasMore()
  {
    return !m_Words.eof() && !(m_Words >> std::ws).eof();
  }

  [[noreturn]] void
  Fail(const std::string & what) const
  {
    ThrowDamagedSurface(m_FileName, "line " + std::to_string(m_Number) + " is no " + what);
  }

private:
  const std::string & m_FileName;
  std::istringstream  m_Text;
  std::istringstream  m_Words;
  std::size_t         m_Number{ 0 };
};
} // namespace

SurfaceFile
ParseOBJ(const std::string & fileName, const std::string & bytes)
{
  SurfaceFile file;
  auto &      points = file.surface.points;
  Lines       lines(fileName, bytes);
  while (lines.Next())
  {
    const auto kind = lines.Read<std::string>("line");
    if (kind == "v")
    {
      points.push_back(lines.ReadPoint());
    }
    else if (kind == "f")
    {
      std::vector<itk::IdentifierType> corners;
      while (lines.HasMore())
      {
        // numbers of a texture and a normal may follow, as in 7/1/3
        std::istringstream corner(lines.Read<std::string>("face"));
        long long          number = 0;
        if (!(corner >> number) || number == 0)
        {
          lines.Fail("face");
        }
        // those below 0 count from the last point back
        corners.push_back(
          static_cast<itk::IdentifierType>(number > 0 ? number - 1 : static_cast<long long>(points.size()) + number));
      }
      CheckCorners(fileName, file.surface.triangles.size(), corners.size());
      file.surface.triangles.push_back({ { corners[0], corners[1], corners[2] } });
    }
  }
  return file;
}

SurfaceFile
ParseOFF(const std::string & fileName, const std::string & bytes)
{
  SurfaceFile file;
  Lines       lines(fileName, bytes);
  lines.Need();
  if (lines.Read<std::string>("header of OFF") != "OFF")
  {
    lines.Fail("header of OFF");
  }
  if (!lines.HasMore())
  {
    lines.Need();
  }
  const auto numberOfPoints = lines.Read<std::size_t>("number of points");
  const auto numberOfCells = lines.Read<std::size_t>("number of faces");
  for (std::size_t n = 0; n < numberOfPoints; ++n)
  {
    lines.Need();
    file.surface.points.push_back(lines.ReadPoint());
  }
  for (std::size_t n = 0; n < numberOfCells; ++n)
  {
    lines.Need();
    CheckCorners(fileName, n, lines.Read<std::size_t>("face"));
    std::array<itk::IdentifierType, 3> corners;
    for (auto & corner : corners)
    {
      corner = lines.Read<itk::IdentifierType>("face");
    }
    file.surface.triangles.push_back(corners);
  }
  return file;
}
} // namespace mmm
