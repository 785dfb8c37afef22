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
#include "itkSurfaceFileReader.h"

#include "input/GzipFile.h"
#include "input/ImageChecks.h"
#include "input/SurfaceFile.h"

#include "itkMeshIOFactory.h"
#include "itkTriangleCell.h"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <vector>

namespace mmm
{
void
ThrowDamagedSurface(const std::string & fileName, const std::string & reason)
{
  itkGenericExceptionMacro(<< fileName << ": the surface cannot be read, it may be damaged: " << reason);
}

void
CheckCorners(const std::string & fileName, std::size_t cell, std::size_t corners)
{
  if (corners != 3)
  {
    itkGenericExceptionMacro(<< fileName << ": cell " << cell << " has " << corners
                             << " points; triangulate the surface first");
  }
}
} // namespace mmm

namespace itk
{
namespace
{
std::string
ReadBytes(const std::string & fileName)
{
  std::ifstream stream(std::filesystem::u8path(fileName), std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
}

/** Extensions of what is read here, and of the registered MeshIO, some of which only say what they write. */
std::string
ListFormats()
{
  std::set<std::string> extensions;
  for (const auto & object : ObjectFactoryBase::CreateAllInstance("itkMeshIOBase"))
  {
    if (const auto * const io = dynamic_cast<const MeshIOBase *>(object.GetPointer()))
    {
      extensions.insert(io->GetSupportedReadExtensions().begin(), io->GetSupportedReadExtensions().end());
      extensions.insert(io->GetSupportedWriteExtensions().begin(), io->GetSupportedWriteExtensions().end());
    }
  }
  std::string formats = "FreeSurfer's, .stl, .obj, .off";
  for (const auto & extension : extensions)
  {
    formats += formats.find(extension) == std::string::npos ? ", " + extension : "";
  }
  return formats;
}

/** Calls body(number) with a number of the type that is meant. */
template <typename TBody>
void
WithComponent(const std::string & fileName, IOComponentEnum type, const TBody & body)
{
  switch (type)
  {
    case IOComponentEnum::FLOAT:
      return body(float{});
    case IOComponentEnum::DOUBLE:
      return body(double{});
    case IOComponentEnum::INT:
      return body(int{});
    case IOComponentEnum::UINT:
      return body(static_cast<unsigned int>(0));
    case IOComponentEnum::LONG:
      return body(long{});
    case IOComponentEnum::ULONG:
      return body(static_cast<unsigned long>(0));
    case IOComponentEnum::LONGLONG:
      return body(static_cast<long long>(0));
    case IOComponentEnum::ULONGLONG:
      return body(static_cast<unsigned long long>(0));
    default:
      mmm::ThrowDamagedSurface(fileName, "its numbers are of a type that is not read");
  }
}

void
ReadPoints(MeshIOBase & io, mmm::SurfaceTriangles & surface)
{
  WithComponent(io.GetFileName(), io.GetPointComponentType(), [&](auto number) {
    std::vector<decltype(number)> values(3 * io.GetNumberOfPoints());
    io.ReadPoints(values.data());
    surface.points.resize(io.GetNumberOfPoints());
    for (std::size_t n = 0; n < values.size(); ++n)
    {
      surface.points[n / 3][n % 3] = static_cast<double>(values[n]);
    }
  });
}

void
ReadTriangles(MeshIOBase & io, mmm::SurfaceTriangles & surface)
{
  const std::string fileName = io.GetFileName();
  WithComponent(fileName, io.GetCellComponentType(), [&](auto number) {
    // of each cell its kind, the number of its points, and these
    std::vector<decltype(number)> values(io.GetCellBufferSize());
    io.ReadCells(values.data());
    std::size_t at = 0;
    for (SizeValueType cell = 0; cell < io.GetNumberOfCells(); ++cell)
    {
      if (at + 1 >= values.size() || values[at + 1] < 0 || at + 2 + std::size_t(values[at + 1]) > values.size())
      {
        mmm::ThrowDamagedSurface(fileName, "it ends in cell " + std::to_string(cell));
      }
      const auto points = static_cast<std::size_t>(values[at + 1]);
      mmm::CheckCorners(fileName, cell, points);
      surface.triangles.push_back({ { static_cast<IdentifierType>(values[at + 2]),
                                      static_cast<IdentifierType>(values[at + 3]),
                                      static_cast<IdentifierType>(values[at + 4]) } });
      at += 2 + points;
    }
  });
}

mmm::SurfaceFile
ReadByITK(const std::string & fileName, const std::string & bytes, MeshIOBase & io)
{
  if (bytes.find("\nOFFSETS ") != std::string::npos)
  {
    itkGenericExceptionMacro(<< fileName
                             << ": this is VTK's format of version 5, which is not read; save it as version 4.2, or as "
                                ".stl");
  }
  // zlib cannot do more
  constexpr double highestCompression = 1032.0;
  mmm::SurfaceFile file;
  try
  {
    io.SetFileName(fileName);
    io.ReadMeshInformation();
    const double numbers = 3.0 * double(io.GetNumberOfPoints()) + double(io.GetCellBufferSize());
    if (numbers > highestCompression * double(bytes.size()))
    {
      mmm::ThrowDamagedSurface(fileName, "it is too short for the points and triangles that it says it has");
    }
    if (io.GetNumberOfPoints() > 0 && io.GetPointDimension() != 3)
    {
      mmm::ThrowDamagedSurface(fileName, "its points are not of three coordinates");
    }
    if (io.GetNumberOfPoints() > 0 && io.GetNumberOfCells() > 0)
    {
      ReadPoints(io, file.surface);
      ReadTriangles(io, file.surface);
    }
  }
  catch (const ExceptionObject & exception)
  {
    const std::string text = exception.GetDescription();
    if (text.find(fileName + ": ") != std::string::npos)
    {
      throw;
    }
    mmm::ThrowDamagedSurface(fileName, text);
  }
  return file;
}

mmm::SurfaceFile
ReadSurface(const std::string & fileName)
{
  mmm::CheckFile(fileName);
  const std::string bytes = ReadBytes(fileName);
  mmm::SurfaceFile  file;
  if (mmm::IsFreeSurferSurface(bytes))
  {
    file = mmm::ParseFreeSurfer(fileName, bytes);
  }
  else if (mmm::HasExtension(fileName, { ".stl" }))
  {
    file = mmm::ParseSTL(fileName, bytes);
  }
  else if (mmm::HasExtension(fileName, { ".obj" }))
  {
    file = mmm::ParseOBJ(fileName, bytes);
  }
  else if (mmm::HasExtension(fileName, { ".off" }))
  {
    file = mmm::ParseOFF(fileName, bytes);
  }
  else if (const MeshIOBase::Pointer io =
             MeshIOFactory::CreateMeshIO(fileName.c_str(), CommonEnums::IOFileMode::ReadMode))
  {
    file = ReadByITK(fileName, bytes, *io);
    file.isInRAS = mmm::HasExtension(fileName, { ".gii" });
  }
  else
  {
    itkGenericExceptionMacro(<< fileName << ": this is not a surface of triangles, or one of a format that cannot be "
                             << "read; supported are " << ListFormats());
  }
  constexpr std::size_t head = 256;
  file.isInRAS = file.isInRAS || bytes.substr(0, head).find("SPACE=RAS") != std::string::npos;
  return file;
}

void
CheckSurface(const std::string & fileName, const mmm::SurfaceTriangles & surface)
{
  if (surface.triangles.empty())
  {
    itkGenericExceptionMacro(<< fileName << ": the file has no triangles");
  }
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    for (const auto corner : surface.triangles[t])
    {
      if (corner >= surface.points.size())
      {
        mmm::ThrowDamagedSurface(fileName,
                                 "triangle " + std::to_string(t) + " has a point that is not among its " +
                                   std::to_string(surface.points.size()) + " points");
      }
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        if (!std::isfinite(surface.points[corner][axis]))
        {
          mmm::ThrowDamagedSurface(fileName,
                                   "point " + std::to_string(corner) + " has a coordinate that is no finite number");
        }
      }
    }
  }
}
} // namespace

auto
SurfaceFileReader::Read() -> MeshType::Pointer
{
  const auto file = ReadSurface(m_FileName);
  CheckSurface(m_FileName, file.surface);
  for (const auto & note : file.notes)
  {
    itkWarningMacro(<< m_FileName << ": " << note);
  }
  const double sign = file.isInRAS || m_FilesAreInRAS ? -1.0 : 1.0;
  const auto   mesh = MeshType::New();
  const auto   points = MeshType::PointsContainer::New();
  points->Reserve(file.surface.points.size());
  for (std::size_t p = 0; p < file.surface.points.size(); ++p)
  {
    auto point = file.surface.points[p];
    point[0] *= sign;
    point[1] *= sign;
    points->SetElement(p, point);
  }
  mesh->SetPoints(points);
  mesh->SetCellsAllocationMethod(MeshEnums::MeshClassCellsAllocationMethod::CellsAllocatedDynamicallyCellByCell);
  const auto cells = MeshType::CellsContainer::New();
  for (const auto & triangle : file.surface.triangles)
  {
    auto * const cell = new TriangleCell<MeshType::CellType>;
    cell->SetPointIds(triangle.data(), triangle.data() + 3);
    cells->InsertElement(cells->Size(), cell);
  }
  mesh->SetCells(cells);
  return mesh;
}

void
SurfaceFileReader::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << m_FileName << std::endl;
  os << indent << "FilesAreInRAS: " << (m_FilesAreInRAS ? "On" : "Off") << std::endl;
}
} // end namespace itk
