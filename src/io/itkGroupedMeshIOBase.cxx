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
#include "itkGroupedMeshIOBase.h"

#include "io/CellLabels.h"
#include "io/CellMesh.h"

#include "itksys/SystemTools.hxx"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <exception>
#include <limits>
#include <sstream>

namespace itk
{
namespace
{
bool
FitInts(const std::vector<std::int64_t> & values)
{
  return std::all_of(values.begin(), values.end(), [](std::int64_t value) {
    return value >= std::numeric_limits<int>::min() && value <= std::numeric_limits<int>::max();
  });
}

/** Whether any cell is in a group, or a group has a name. */
bool
HasGroups(const mmm::CellMesh & mesh)
{
  return !mesh.names.empty() || std::any_of(mesh.tags.begin(), mesh.tags.end(), [](int tag) { return tag != 0; });
}
} // namespace

GroupedMeshIOBase::GroupedMeshIOBase(const std::string & extension)
  : m_Extension(extension)
{
  this->AddSupportedReadExtension(extension.c_str());
  this->AddSupportedWriteExtension(extension.c_str());
}

GroupedMeshIOBase::~GroupedMeshIOBase() = default;

void
GroupedMeshIOBase::SetGroupNames(const GroupNamesType & names)
{
  if (names != m_GroupNames)
  {
    m_GroupNames = names;
    this->Modified();
  }
}

bool
GroupedMeshIOBase::CanReadFile(const char * fileName)
{
  return this->CanWriteFile(fileName) && itksys::SystemTools::FileExists(fileName, true);
}

bool
GroupedMeshIOBase::CanWriteFile(const char * fileName)
{
  return fileName != nullptr &&
         itksys::SystemTools::LowerCase(itksys::SystemTools::GetFilenameLastExtension(fileName)) == m_Extension;
}

void
GroupedMeshIOBase::ReadMeshInformation()
{
  m_Mesh = nullptr;
  try
  {
    auto mesh = std::make_unique<mmm::CellMesh>();
    this->ReadFile(*mesh);
    mmm::CheckCorners(*mesh);
    if (m_RAS)
    {
      mmm::TurnLPSAndRAS(*mesh);
    }
    m_GroupNames = mesh->names;

    m_PointDimension = 3;
    m_NumberOfPoints = mesh->NumberOfPoints();
    m_PointComponentType = IOComponentEnum::DOUBLE;
    m_UpdatePoints = m_NumberOfPoints > 0;

    m_NumberOfCells = mesh->shapes.size();
    m_CellBufferSize = 2 * mesh->shapes.size() + mesh->corners.size();
    m_CellComponentType = MapComponentType<IdentifierType>::CType;
    m_UpdateCells = m_NumberOfCells > 0;

    m_UpdatePointData = false;
    m_NumberOfPointPixels = 0;

    m_UpdateCellData = m_NumberOfCells > 0 && (HasGroups(*mesh) || !this->HasCellsWithoutGroup());
    const mmm::CellLabels labels = m_UpdateCellData ? mmm::GetLabels(*mesh) : mmm::CellLabels{ 1, {} };
    m_NumberOfCellPixels = m_UpdateCellData ? m_NumberOfCells : 0;
    m_NumberOfCellPixelComponents = static_cast<unsigned int>(labels.components);
    m_CellPixelComponentType = FitInts(labels.values) ? IOComponentEnum::INT : MapComponentType<std::int64_t>::CType;
    m_CellPixelType = labels.components == 1 ? IOPixelEnum::SCALAR : IOPixelEnum::FIXEDARRAY;

    m_Mesh = std::move(mesh);
  }
  catch (const std::exception & error)
  {
    itkExceptionMacro("Cannot read \"" << m_FileName << "\": " << mmm::ReasonOf(error));
  }
}

template <typename TBody>
void
GroupedMeshIOBase::ReadPart(TBody body)
{
  if (m_Mesh == nullptr)
  {
    itkExceptionMacro("ReadMeshInformation() must be called before a part of \"" << m_FileName << "\" is read");
  }
  body(*m_Mesh);
}

void
GroupedMeshIOBase::ReadPoints(void * buffer)
{
  this->ReadPart([&](const mmm::CellMesh & mesh) {
    std::copy(mesh.points.begin(), mesh.points.end(), static_cast<double *>(buffer));
  });
}

void
GroupedMeshIOBase::ReadCells(void * buffer)
{
  this->ReadPart([&](const mmm::CellMesh & mesh) {
    const auto cells = mmm::MakeCellBuffer(mesh);
    std::copy(cells.begin(), cells.end(), static_cast<IdentifierType *>(buffer));
  });
}

void
GroupedMeshIOBase::ReadPointData(void *)
{
  itkExceptionMacro("\"" << m_FileName << "\" has no data of points");
}

void
GroupedMeshIOBase::ReadCellData(void * buffer)
{
  this->ReadPart([&](const mmm::CellMesh & mesh) {
    const auto labels = mmm::GetLabels(mesh);
    if (m_CellPixelComponentType == IOComponentEnum::INT)
    {
      std::transform(labels.values.begin(), labels.values.end(), static_cast<int *>(buffer), [](std::int64_t value) {
        return static_cast<int>(value);
      });
    }
    else
    {
      std::copy(labels.values.begin(), labels.values.end(), static_cast<std::int64_t *>(buffer));
    }
  });
}

void
GroupedMeshIOBase::WriteMeshInformation()
{
  m_Mesh = std::make_unique<mmm::CellMesh>();
  m_Mesh->names = m_GroupNames;
  m_WriteError.clear();
}

template <typename TBody>
void
GroupedMeshIOBase::WritePart(TBody body)
{
  if (m_Mesh == nullptr)
  {
    itkExceptionMacro("WriteMeshInformation() must be called before the parts of \"" << m_FileName << "\" are written");
  }
  if (!m_WriteError.empty())
  {
    return;
  }
  try
  {
    body(*m_Mesh);
  }
  catch (const std::exception & error)
  {
    m_WriteError = mmm::ReasonOf(error);
  }
}

void
GroupedMeshIOBase::WritePoints(void * buffer)
{
  this->WritePart([&](mmm::CellMesh & mesh) {
    mmm::SetPoints(mesh, buffer, m_PointComponentType, m_NumberOfPoints, m_PointDimension);
  });
}

void
GroupedMeshIOBase::WriteCells(void * buffer)
{
  this->WritePart(
    [&](mmm::CellMesh & mesh) { mmm::SetCells(mesh, buffer, m_CellComponentType, m_CellBufferSize, m_NumberOfCells); });
}

void
GroupedMeshIOBase::WritePointData(void *)
{
  itkWarningMacro("The data of points are not in \"" << m_FileName << "\": such files have none");
}

void
GroupedMeshIOBase::WriteCellData(void * buffer)
{
  this->WritePart([&](mmm::CellMesh & mesh) {
    if (m_NumberOfCellPixels != mesh.shapes.size())
    {
      throw mmm::MeshFileError("it has data of " + std::to_string(m_NumberOfCellPixels) + " cells, but " +
                               std::to_string(mesh.shapes.size()) + " cells");
    }
    const auto labels = mmm::TakeLabels(buffer,
                                        m_CellPixelComponentType,
                                        m_NumberOfCellPixels * m_NumberOfCellPixelComponents,
                                        m_NumberOfCellPixelComponents);
    const auto numbered = mmm::SetTags(mesh, labels, this->GetLowestGroup());
    // That pairs of labels are numbered is what one expects.
    if (!numbered.empty() && labels.components == 1)
    {
      std::ostringstream text;
      for (const auto & [name, tag] : numbered)
      {
        text << (text.tellp() > 0 ? ", " : "") << name << " is " << tag;
      }
      itkWarningMacro("Groups of cells in \"" << m_FileName << "\" cannot have every number: " << text.str());
    }
  });
}

void
GroupedMeshIOBase::Write()
{
  this->WritePart([&](mmm::CellMesh & mesh) {
    mmm::CheckCorners(mesh);
    if (m_RAS)
    {
      mmm::TurnLPSAndRAS(mesh);
    }
    this->WriteFile(mesh);
  });
  m_Mesh = nullptr;
  if (!m_WriteError.empty())
  {
    itkExceptionMacro("Cannot write \"" << m_FileName << "\": " << m_WriteError);
  }
}

void
GroupedMeshIOBase::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "RAS: " << (m_RAS ? "On" : "Off") << std::endl;
  os << indent << "GroupNames:" << std::endl;
  for (const auto & [group, name] : m_GroupNames)
  {
    os << indent.GetNextIndent() << "dimension " << group.first << ", number " << group.second << ": " << name
       << std::endl;
  }
}
} // end namespace itk
