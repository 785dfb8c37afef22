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
// The writer gets its IO from here. ITK generates no header that registers mesh IOs if none of its own are in use.
#undef ITK_IO_FACTORY_REGISTER_MANAGER

#include "itkLabelMeshFileWriter.h"

#include "itkGmshMeshIO.h"
#include "itkMeditMeshIO.h"
#include "itkVTUMeshIO.h"
#include "output/GroupedMesh.h"
#include "output/LabelNames.h"
#include "output/SecondOrder.h"
#include "output/TriangleFile.h"

#include "itkMeshFileWriter.h"

#include <algorithm>
#include <limits>
#include <set>

namespace itk
{
namespace
{
bool
EndsWith(const std::string & text, const std::string & end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}
} // namespace

const std::vector<std::string> &
LabelMeshFileWriter::GetMshFormats()
{
  static const std::vector<std::string> formats{ "4.1", "4.1-ascii", "2.2", "2.2-ascii", "simnibs" };
  return formats;
}

const std::vector<std::string> &
LabelMeshFileWriter::GetVolumeExtensions()
{
  static const std::vector<std::string> extensions{ ".vtu", ".msh", ".mesh" };
  return extensions;
}

const std::vector<std::string> &
LabelMeshFileWriter::GetSurfaceExtensions()
{
  static const std::vector<std::string> extensions{ ".vtu", ".msh", ".mesh", ".stl", ".obj", ".off", ".surf" };
  return extensions;
}

std::string
LabelMeshFileWriter::FindExtension(const std::string & fileName, const std::vector<std::string> & extensions)
{
  const auto found = std::find_if(extensions.begin(), extensions.end(), [&](const std::string & extension) {
    return fileName.size() > extension.size() && EndsWith(fileName, extension);
  });
  return found == extensions.end() ? "" : *found;
}

const std::vector<std::string> &
LabelMeshFileWriter::GetCellDataExtensions()
{
  static const std::vector<std::string> extensions{ ".vtu", ".msh" };
  return extensions;
}

void
LabelMeshFileWriter::SetLabelTable(const mmm::LabelTable & table)
{
  m_LabelTable = table;
  this->Modified();
}

void
LabelMeshFileWriter::SetLabelName(int label, const std::string & name)
{
  m_LabelTable[label].name = name;
  this->Modified();
}

void
LabelMeshFileWriter::AddCellData(const std::string & name, const std::vector<double> & values)
{
  m_CellData[name] = values;
  this->Modified();
}

mmm::LabelTable
LabelMeshFileWriter::NamesInUse() const
{
  std::set<int> labels;
  if (m_LabelTable.empty())
  {
    return {};
  }
  if (m_Tetrahedra && m_Tetrahedra->GetCellData())
  {
    const auto & ofTetrahedra = m_Tetrahedra->GetCellData()->CastToSTLConstContainer();
    labels.insert(ofTetrahedra.begin(), ofTetrahedra.end());
  }
  if (m_Surface && m_Surface->GetCellData())
  {
    for (const auto & sides : m_Surface->GetCellData()->CastToSTLConstContainer())
    {
      labels.insert({ sides[0], sides[1] });
    }
  }
  return mmm::NamesForFiles(m_LabelTable, labels);
}

void
LabelMeshFileWriter::CheckCellData(const std::string & extension) const
{
  const auto & extensions = GetCellDataExtensions();
  if (m_CellData.empty())
  {
    return;
  }
  if (!m_Tetrahedra)
  {
    itkExceptionMacro("There are data of tetrahedra, '" << m_CellData.begin()->first << "', but no tetrahedra.");
  }
  if (std::find(extensions.begin(), extensions.end(), extension) == extensions.end())
  {
    itkExceptionMacro("'" << m_FileName << "' cannot have data of tetrahedra, '" << m_CellData.begin()->first
                          << "'; .vtu and .msh files can.");
  }
  for (const auto & [name, values] : m_CellData)
  {
    if (name.empty() || name == "label")
    {
      itkExceptionMacro("Data of tetrahedra need a name, other than 'label'; it is '" << name << "'.");
    }
    const std::size_t count = m_Tetrahedra->GetNumberOfCells();
    if (values.size() != count && values.size() != 3 * count && values.size() != 9 * count)
    {
      itkExceptionMacro("The data '" << name << "' are " << values.size() << " numbers for " << count
                                     << " tetrahedra; each has 1, 3 or 9.");
    }
  }
}

bool
LabelMeshFileWriter::IsForSimNIBS() const
{
  return m_MshFormat == "simnibs";
}

template <typename TMesh>
void
LabelMeshFileWriter::WriteBy(MeshIOBase * io, const TMesh * mesh, bool isText) const
{
  const auto writer = MeshFileWriter<TMesh>::New();
  if (m_MidNodes)
  {
    writer->SetInput(mmm::MakeSecondOrder(mesh, m_MidNodes.GetPointer()));
  }
  else
  {
    writer->SetInput(mesh);
  }
  writer->SetFileName(m_FileName);
  writer->SetMeshIO(io);
  writer->UseCompressionOn();
  if (isText)
  {
    writer->SetFileTypeAsASCII();
  }
  else
  {
    writer->SetFileTypeAsBINARY();
  }
  writer->Update();
}

void
LabelMeshFileWriter::WriteGroups(const std::string & extension) const
{
  const bool isMedit = extension == ".mesh";
  const auto grouped = this->IsForSimNIBS() && !isMedit
                         ? mmm::MakeGroupedMeshForSimNIBS(m_Tetrahedra, m_Surface, m_OutsideLabel)
                         : mmm::MakeGroupedMesh(m_Tetrahedra, m_Surface, this->NamesInUse());
  if (isMedit)
  {
    const auto io = MeditMeshIO::New();
    io->SetRAS(m_RAS);
    io->SetGroupNames(grouped.names);
    this->WriteBy(io.GetPointer(), grouped.mesh.GetPointer(), true);
    return;
  }
  const auto io = GmshMeshIO::New();
  io->SetRAS(m_RAS || this->IsForSimNIBS());
  io->SetVersion2(m_MshFormat.front() == '2' || this->IsForSimNIBS());
  // SimNIBS's reader wants the nodes to come first.
  io->SetWriteGroupNames(!this->IsForSimNIBS());
  io->SetGroupNames(grouped.names);
  // the triangles come first
  auto arrays = m_CellData;
  for (auto & array : arrays)
  {
    const std::size_t components = array.second.size() / std::max<std::size_t>(m_Tetrahedra->GetNumberOfCells(), 1);
    array.second.insert(
      array.second.begin(), components * m_Surface->GetNumberOfCells(), std::numeric_limits<double>::quiet_NaN());
  }
  io->SetCellArrays(arrays);
  this->WriteBy(io.GetPointer(), grouped.mesh.GetPointer(), EndsWith(m_MshFormat, "ascii"));
}

void
LabelMeshFileWriter::Write() const
{
  const auto &      formats = GetMshFormats();
  const std::string extension =
    FindExtension(m_FileName, m_Tetrahedra ? GetVolumeExtensions() : GetSurfaceExtensions());
  if (extension.empty())
  {
    itkExceptionMacro("The file name '" << m_FileName << "' has no extension that "
                                        << (m_Tetrahedra ? "tetrahedra" : "surfaces") << " are written to.");
  }
  if (std::find(formats.begin(), formats.end(), m_MshFormat) == formats.end())
  {
    itkExceptionMacro("There is no MshFormat '" << m_MshFormat << "'.");
  }
  this->CheckCellData(extension);
  if (m_MidNodes && (extension == ".mesh" || (extension == ".msh" && this->IsForSimNIBS())))
  {
    itkExceptionMacro("The file " << m_FileName << (extension == ".mesh" ? "" : " for SimNIBS")
                                  << " cannot have elements of second order; .vtu and other .msh files can.");
  }
  const auto vtu = VTUMeshIO::New();
  vtu->SetWriteSpace(m_WriteSpace);
  vtu->SetLabelTable(this->NamesInUse());
  vtu->SetCellArrays(m_CellData);
  if (m_Tetrahedra && extension == ".vtu")
  {
    this->WriteBy(vtu.GetPointer(), m_Tetrahedra.GetPointer());
    return;
  }
  if (!m_Surface)
  {
    itkExceptionMacro("The file " << m_FileName << " needs the surface, and there is none.");
  }
  if (extension == ".vtu")
  {
    vtu->SetCellDataNames({ "label_a", "label_b" });
    this->WriteBy(vtu.GetPointer(), m_Surface.GetPointer());
  }
  else if (extension == ".stl")
  {
    mmm::WriteSTL(m_Surface, m_FileName, m_RAS);
  }
  else if (extension == ".obj")
  {
    mmm::WriteOBJ(m_Surface, m_FileName, m_RAS);
  }
  else if (extension == ".off")
  {
    mmm::WriteOFF(m_Surface, m_FileName, m_RAS);
  }
  else if (extension == ".surf")
  {
    mmm::WriteFreeSurfer(m_Surface, m_FileName);
  }
  else
  {
    this->WriteGroups(extension);
  }
}

void
LabelMeshFileWriter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Tetrahedra: " << m_Tetrahedra.GetPointer() << '\n';
  os << indent << "Surface: " << m_Surface.GetPointer() << '\n';
  os << indent << "MidNodes: " << m_MidNodes.GetPointer() << '\n';
  os << indent << "FileName: " << m_FileName << '\n';
  os << indent << "MshFormat: " << m_MshFormat << '\n';
  os << indent << "RAS: " << (m_RAS ? "On" : "Off") << '\n';
  os << indent << "WriteSpace: " << (m_WriteSpace ? "On" : "Off") << '\n';
  os << indent << "OutsideLabel: " << m_OutsideLabel << '\n';
  os << indent << "LabelTable: " << m_LabelTable.size() << " labels\n";
  os << indent << "CellData:";
  for (const auto & data : m_CellData)
  {
    os << ' ' << data.first;
  }
  os << '\n';
}
} // end namespace itk
