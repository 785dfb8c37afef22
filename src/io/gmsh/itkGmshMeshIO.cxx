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
#include "itkGmshMeshIO.h"

#include "io/FileCursor.h"
#include "io/gmsh/GmshElementData.h"
#include "io/gmsh/GmshReader.h"
#include "io/gmsh/GmshWriter.h"

namespace itk
{
GmshMeshIO::GmshMeshIO()
  : Superclass(".msh")
{
  m_FileType = IOFileEnum::BINARY;
}

GmshMeshIO::~GmshMeshIO() = default;

void
GmshMeshIO::SetCellArrays(const CellArraysType & arrays)
{
  m_CellArrays = arrays;
  this->Modified();
}

void
GmshMeshIO::ReadFile(mmm::CellMesh & mesh)
{
  const std::string bytes = mmm::ReadWholeFile(m_FileName);
  if (!mmm::ReadGmsh(bytes, mesh))
  {
    itkWarningMacro("In \"" << m_FileName
                            << "\", some cells belong to several physical groups; the first one of each counts");
  }
}

void
GmshMeshIO::WriteFile(const mmm::CellMesh & mesh)
{
  CellArraysType arrays = m_CellArrays;
  if (this->GetRAS())
  {
    mmm::TurnLPSAndRAS(arrays, mesh.shapes.size());
  }
  mmm::WriteGmsh(m_FileName, mesh, arrays, { m_Version2, m_FileType != IOFileEnum::ASCII, m_WriteGroupNames });
}

void
GmshMeshIO::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Version2: " << (m_Version2 ? "On" : "Off") << std::endl;
  os << indent << "WriteGroupNames: " << (m_WriteGroupNames ? "On" : "Off") << std::endl;
  os << indent << "CellArrays:";
  for (const auto & array : m_CellArrays)
  {
    os << ' ' << array.first;
  }
  os << std::endl;
}
} // end namespace itk
