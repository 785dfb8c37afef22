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
#include "output/TriangleFile.h"

#include "itkOutputFile.h"

#include "itkByteSwapper.h"
#include "itkNumberToString.h"

#include <array>
#include <cstdint>
#include <limits>

namespace mmm
{
namespace
{
using Mesh = itk::LabelInterfaceMesh;
using Vector = itk::Vector<double, 3>;

constexpr std::size_t HeaderSize = 80;

Vector
PointOf(const Mesh & mesh, itk::IdentifierType id, bool ras)
{
  Vector point = mesh.GetPoint(id).GetVectorFromOrigin();
  if (ras)
  {
    point[0] = -point[0];
    point[1] = -point[1];
  }
  return point;
}

std::string
SpaceComment(bool ras)
{
  return std::string("multimaterial-mesh SPACE=") + (ras ? "RAS" : "LPS");
}

template <typename T>
void
Append(std::string & bytes, T value)
{
  itk::ByteSwapper<T>::SwapFromSystemToLittleEndian(&value);
  bytes.append(reinterpret_cast<const char *>(&value), sizeof value);
}

template <typename T>
void
AppendBigEndian(std::string & bytes, T value)
{
  itk::ByteSwapper<T>::SwapFromSystemToBigEndian(&value);
  bytes.append(reinterpret_cast<const char *>(&value), sizeof value);
}

void
AppendVector(std::string & bytes, const Vector & vector)
{
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    Append(bytes, static_cast<float>(vector[axis]));
  }
}

/** Lines of coordinates, then of corners, which are counted from `first`. */
std::string
TextOf(const Mesh & mesh, bool ras, const std::string & pointWord, const std::string & cellWord, int first)
{
  const itk::NumberToString<double> toText;
  std::string                       text;
  for (itk::IdentifierType i = 0; i < mesh.GetNumberOfPoints(); ++i)
  {
    const Vector point = PointOf(mesh, i, ras);
    text += pointWord + toText(point[0]) + ' ' + toText(point[1]) + ' ' + toText(point[2]) + '\n';
  }
  for (auto cell = mesh.GetCells()->Begin(); cell != mesh.GetCells()->End(); ++cell)
  {
    text += cellWord;
    for (auto id = cell.Value()->PointIdsBegin(); id != cell.Value()->PointIdsEnd(); ++id)
    {
      text += ' ' + std::to_string(*id + first);
    }
    text += '\n';
  }
  return text;
}
} // namespace

void
WriteSTL(const Mesh * mesh, const std::string & fileName, bool ras)
{
  const std::size_t count = mesh->GetNumberOfCells();
  if (count > std::numeric_limits<std::uint32_t>::max())
  {
    itkGenericExceptionMacro("cannot write " << fileName << ": it has more triangles than STL can count");
  }
  std::string bytes = SpaceComment(ras);
  bytes.resize(HeaderSize, ' ');
  Append(bytes, static_cast<std::uint32_t>(count));
  for (auto cell = mesh->GetCells()->Begin(); cell != mesh->GetCells()->End(); ++cell)
  {
    std::array<Vector, 3> corners;
    auto *                corner = corners.data();
    for (auto id = cell.Value()->PointIdsBegin(); id != cell.Value()->PointIdsEnd(); ++id)
    {
      *corner++ = PointOf(*mesh, *id, ras);
    }
    auto normal = itk::CrossProduct(corners[1] - corners[0], corners[2] - corners[0]);
    normal.Normalize();
    AppendVector(bytes, normal);
    for (const Vector & point : corners)
    {
      AppendVector(bytes, point);
    }
    Append(bytes, std::uint16_t{ 0 });
  }
  itk::OutputFile::WriteWhole(fileName, bytes);
}

void
WriteOBJ(const Mesh * mesh, const std::string & fileName, bool ras)
{
  itk::OutputFile::WriteWhole(fileName, "# " + SpaceComment(ras) + '\n' + TextOf(*mesh, ras, "v ", "f", 1));
}

void
WriteOFF(const Mesh * mesh, const std::string & fileName, bool ras)
{
  itk::OutputFile::WriteWhole(fileName,
                              "OFF\n" + std::to_string(mesh->GetNumberOfPoints()) + ' ' +
                                std::to_string(mesh->GetNumberOfCells()) + " 0\n" + TextOf(*mesh, ras, "", "3", 0));
}

void
WriteFreeSurfer(const Mesh * mesh, const std::string & fileName)
{
  const std::size_t largest = std::numeric_limits<std::int32_t>::max();
  if (mesh->GetNumberOfPoints() > largest || mesh->GetNumberOfCells() > largest)
  {
    itkGenericExceptionMacro("cannot write " << fileName
                                             << ": it has more points or triangles than FreeSurfer can count");
  }
  std::string bytes = "\xFF\xFF\xFE" + SpaceComment(true) + "\n\n";
  AppendBigEndian(bytes, static_cast<std::int32_t>(mesh->GetNumberOfPoints()));
  AppendBigEndian(bytes, static_cast<std::int32_t>(mesh->GetNumberOfCells()));
  for (itk::IdentifierType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const Vector point = PointOf(*mesh, i, true);
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      AppendBigEndian(bytes, static_cast<float>(point[axis]));
    }
  }
  for (auto cell = mesh->GetCells()->Begin(); cell != mesh->GetCells()->End(); ++cell)
  {
    for (auto id = cell.Value()->PointIdsBegin(); id != cell.Value()->PointIdsEnd(); ++id)
    {
      AppendBigEndian(bytes, static_cast<std::int32_t>(*id));
    }
  }
  itk::OutputFile::WriteWhole(fileName, bytes);
}
} // namespace mmm
