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
#include "itkVTUMeshIO.h"

#include "itkMeshFileWriter.h"

namespace cli
{
namespace
{
template <typename TMesh>
void
Write(const TMesh * mesh, const std::string & fileName, itk::VTUMeshIO * io)
{
  auto writer = itk::MeshFileWriter<TMesh>::New();
  writer->SetInput(mesh);
  writer->SetFileName(fileName);
  writer->SetMeshIO(io);
  writer->SetFileTypeAsBINARY();
  writer->UseCompressionOn();
  writer->Update();
}
} // namespace

void
WriteMesh(const itk::LabelTetrahedralMesh * mesh, const std::string & fileName)
{
  Write(mesh, fileName, itk::VTUMeshIO::New());
}

void
WriteMesh(const itk::LabelInterfaceMesh * mesh, const std::string & fileName)
{
  const auto io = itk::VTUMeshIO::New();
  io->SetCellDataNames({ "label_a", "label_b" });
  Write(mesh, fileName, io);
}

void
WriteMesh(const itk::LabelParticleMesh * mesh, const std::string & fileName)
{
  const auto io = itk::VTUMeshIO::New();
  io->SetPointDataNames({ "dimension", "label_a", "label_b", "label_c", "label_d" });
  Write(mesh, fileName, io);
}
} // namespace cli
