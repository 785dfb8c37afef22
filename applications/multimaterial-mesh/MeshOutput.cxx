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

#include "MeshOutput.h"

#include "Errors.h"
#include "GroupedMesh.h"
#include "LabelCheck.h"
#include "Settings.h"
#include "TriangleOutput.h"
#include "itkGmshMeshIO.h"
#include "itkMeditMeshIO.h"
#include "itkVTUMeshIO.h"

#include "itkMeshFileWriter.h"

#include <algorithm>

namespace cli
{
namespace
{
template <typename TMesh>
void
Write(const TMesh * mesh, const std::string & fileName, itk::MeshIOBase * io, bool isText = false)
{
  auto writer = itk::MeshFileWriter<TMesh>::New();
  writer->SetInput(mesh);
  writer->SetFileName(fileName);
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

bool
EndsWith(const std::string & text, const std::string & end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

void
WriteGrouped(const GroupedMesh & grouped, const std::string & fileName, const MeshStyle & style)
{
  if (ExtensionFor(MeshKind::Volume, fileName) == ".mesh")
  {
    const auto io = itk::MeditMeshIO::New();
    io->SetRAS(style.ras);
    io->SetGroupNames(grouped.names);
    Write(grouped.mesh.GetPointer(), fileName, io, true);
    return;
  }
  const auto io = itk::GmshMeshIO::New();
  io->SetRAS(style.ras || style.IsForSimNIBS());
  io->SetVersion2(style.mshFormat.front() == '2' || style.IsForSimNIBS());
  // SimNIBS's reader wants the nodes to come first.
  io->SetWriteGroupNames(!style.IsForSimNIBS());
  io->SetGroupNames(grouped.names);
  Write(grouped.mesh.GetPointer(), fileName, io, EndsWith(style.mshFormat, "ascii"));
}

GroupedMesh
Group(const itk::LabelTetrahedralMesh * tetrahedra,
      const itk::LabelInterfaceMesh *   surface,
      const std::string &               extension,
      const MeshStyle &                 style)
{
  return extension == ".msh" && style.IsForSimNIBS() ? MakeGroupedMeshForSimNIBS(tetrahedra, surface, style.outside)
                                                     : MakeGroupedMesh(tetrahedra, surface);
}
} // namespace

void
WriteVolume(const itk::LabelTetrahedralMesh * tetrahedra,
            const itk::LabelInterfaceMesh *   surface,
            const std::string &               fileName,
            const MeshStyle &                 style)
{
  const std::string extension = ExtensionFor(MeshKind::Volume, fileName);
  if (extension == ".vtu")
  {
    Write(tetrahedra, fileName, itk::VTUMeshIO::New());
  }
  else
  {
    WriteGrouped(Group(tetrahedra, surface, extension, style), fileName, style);
  }
}

void
WriteSurface(const itk::LabelInterfaceMesh * surface, const std::string & fileName, const MeshStyle & style)
{
  const std::string extension = ExtensionFor(MeshKind::Surface, fileName);
  if (extension == ".vtu")
  {
    const auto io = itk::VTUMeshIO::New();
    io->SetCellDataNames({ "label_a", "label_b" });
    Write(surface, fileName, io);
  }
  else if (extension == ".stl")
  {
    WriteSTL(surface, fileName, style.ras);
  }
  else if (extension == ".obj")
  {
    WriteOBJ(surface, fileName, style.ras);
  }
  else if (extension == ".off")
  {
    WriteOFF(surface, fileName, style.ras);
  }
  else
  {
    WriteGrouped(Group(nullptr, surface, extension, style), fileName, style);
  }
}

void
WriteParticles(const itk::LabelParticleMesh * particles, const std::string & fileName)
{
  const auto io = itk::VTUMeshIO::New();
  io->SetPointDataNames({ "dimension", "label_a", "label_b", "label_c", "label_d" });
  Write(particles, fileName, io);
}

void
WriteJunctions(const itk::LabelJunctionMesh * junctions, const std::string & fileName)
{
  const auto io = itk::VTUMeshIO::New();
  // meshio reads it then
  io->WriteSpaceOff();
  io->SetCellDataNames({ "curve", "label_count", "label_a", "label_b", "label_c", "label_d" });
  Write(junctions, fileName, io);
}

void
CheckLabelsFit(const Settings & settings, const mmm::LabelCounts & voxels)
{
  if (!StyleOf(settings, 0).IsForSimNIBS())
  {
    return;
  }
  const auto check = [](int label, const std::string & advice) {
    if (label < 1 || label > 999)
    {
      throw Error("--msh-format simnibs: SimNIBS numbers tissues from 1 to 999, and label " + std::to_string(label) +
                  advice + ", or take another format");
    }
  };
  for (const auto & entry : voxels)
  {
    if (!settings.IsExterior(entry.first))
    {
      check(entry.first, " is to be meshed; list it in --exterior, give it another number");
    }
  }
  if (const auto air = LabelOfAir(settings, voxels))
  {
    check(*air, " is that of the air; leave out --fill-exterior and --air-margin, give it another number");
  }
}
} // namespace cli
