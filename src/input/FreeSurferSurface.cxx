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

#include <cmath>
#include <cstdint>
#include <cstring>
#include <locale>
#include <map>
#include <sstream>

namespace mmm
{
namespace
{
const char * const TriangleMagic = "\xFF\xFF\xFE";

/** The numbers of a file, which are big-endian. */
class Cursor
{
public:
  Cursor(const std::string & fileName, const std::string & bytes, std::size_t at)
    : m_FileName(fileName)
    , m_Bytes(bytes)
    , m_At(at)
  {}

  std::size_t
  Rest() const
  {
    return m_Bytes.size() - m_At;
  }

  std::string
  RestAsText() const
  {
    return m_Bytes.substr(m_At);
  }

  template <typename T>
  T
  Next()
  {
    if (this->Rest() < sizeof(T))
    {
      ThrowDamagedSurface(m_FileName, "its end is missing");
    }
    T value;
    std::memcpy(&value, m_Bytes.data() + m_At, sizeof value);
    m_At += sizeof value;
    itk::ByteSwapper<T>::SwapFromSystemToBigEndian(&value);
    return value;
  }

private:
  const std::string & m_FileName;
  const std::string & m_Bytes;
  std::size_t         m_At;
};

using Vector = itk::Vector<double, 3>;

/** From FreeSurfer's space of a volume, whose axes are fixed, to the scanner's. */
struct VolumeSpace
{
  std::map<std::string, Vector> vectors;

  bool
  IsComplete() const
  {
    return vectors.size() == 4;
  }

  itk::Point<double, 3>
  ToScanner(const itk::Point<double, 3> & x) const
  {
    return itk::Point<double, 3>(vectors.at("cras").GetDataPointer()) + vectors.at("xras") * -x[0] +
           vectors.at("yras") * -x[2] + vectors.at("zras") * x[1];
  }
};

/** From lines such as "cras   = 1.5 -20 7". */
VolumeSpace
ParseVolumeSpace(const std::string & text)
{
  VolumeSpace        space;
  std::istringstream lines(text);
  bool               isValid = false;
  for (std::string line; std::getline(lines, line);)
  {
    std::istringstream words(line);
    words.imbue(std::locale::classic());
    std::string name;
    std::string equals;
    words >> name >> equals;
    if (name == "valid")
    {
      isValid = words.get() != 0 && words.peek() == '1';
    }
    if (name.size() == 4 && name.substr(1) == "ras")
    {
      Vector vector;
      if (words >> vector[0] >> vector[1] >> vector[2])
      {
        space.vectors[name] = vector;
      }
    }
  }
  return isValid ? space : VolumeSpace{};
}

/** Whether points are in the scanner's space already, and else the way there. */
bool
ReadPlace(Cursor & cursor, VolumeSpace & space)
{
  constexpr std::int32_t useScannerSpace = 2;
  constexpr std::int32_t volumeSpace = 20;

  bool isInScannerSpace = false;
  while (cursor.Rest() >= 8)
  {
    const auto tag = cursor.Next<std::int32_t>();
    if (tag == useScannerSpace)
    {
      isInScannerSpace = cursor.Next<std::int32_t>() != 0;
      continue;
    }
    if (tag == volumeSpace)
    {
      space = ParseVolumeSpace(cursor.RestAsText());
    }
    break;
  }
  return isInScannerSpace;
}
} // namespace

bool
IsFreeSurferSurface(const std::string & bytes)
{
  return bytes.compare(0, 3, TriangleMagic) == 0;
}

SurfaceFile
ParseFreeSurfer(const std::string & fileName, const std::string & bytes)
{
  const auto comment = bytes.find("\n\n");
  if (comment == std::string::npos)
  {
    ThrowDamagedSurface(fileName, "its first lines have no end");
  }
  Cursor     cursor(fileName, bytes, comment + 2);
  const auto numberOfPoints = cursor.Next<std::int32_t>();
  const auto numberOfTriangles = cursor.Next<std::int32_t>();
  if (numberOfPoints < 0 || numberOfTriangles < 0 ||
      cursor.Rest() < 12 * (std::size_t(numberOfPoints) + std::size_t(numberOfTriangles)))
  {
    ThrowDamagedSurface(fileName,
                        "it is too short for the " + std::to_string(numberOfPoints) + " points and " +
                          std::to_string(numberOfTriangles) + " triangles that its header says");
  }
  SurfaceFile file;
  file.isInRAS = true;
  file.surface.points.resize(numberOfPoints);
  for (auto & point : file.surface.points)
  {
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      point[axis] = cursor.Next<float>();
    }
  }
  file.surface.triangles.resize(numberOfTriangles);
  for (auto & triangle : file.surface.triangles)
  {
    for (auto & corner : triangle)
    {
      corner = static_cast<itk::IdentifierType>(cursor.Next<std::int32_t>());
    }
  }
  VolumeSpace space;
  if (!ReadPlace(cursor, space))
  {
    if (space.IsComplete())
    {
      for (auto & point : file.surface.points)
      {
        point = space.ToScanner(point);
      }
    }
    else
    {
      file.notes.emplace_back("it does not say which volume it belongs to; its points are taken to be in the scanner's "
                              "space");
    }
  }
  return file;
}
} // namespace mmm
