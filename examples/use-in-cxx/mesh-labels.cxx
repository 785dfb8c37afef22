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
// Meshes a label image, shows the stages and can be interrupted: mesh-labels LABELS OUTPUT.vtu
#include "itkLabelImageToTetrahedralMeshFilter.h"
#include "itkVTUMeshIOFactory.h"

#include "itkImageFileReader.h"
#include "itkMeshFileWriter.h"

#include <csignal>
#include <cstdlib>
#include <iostream>

namespace
{
using LabelImageType = itk::Image<int, 3>;
using MesherType = itk::LabelImageToTetrahedralMeshFilter<LabelImageType>;

volatile std::sig_atomic_t isInterrupted = 0;

// itk::ReadImage() would take the first volume of a series, and cut off what is behind the point.
LabelImageType::Pointer
ReadLabels(const std::string & fileName)
{
  const auto io = itk::ImageIOFactory::CreateImageIO(fileName.c_str(), itk::IOFileModeEnum::ReadMode);
  if (io.IsNull())
  {
    itkGenericExceptionMacro(<< fileName << " is not there, or no image.");
  }
  io->SetFileName(fileName);
  io->ReadImageInformation();
  const auto type = io->GetComponentType();
  if (type == itk::IOComponentEnum::FLOAT || type == itk::IOComponentEnum::DOUBLE)
  {
    itkGenericExceptionMacro(<< fileName << " has floating-point values; labels are integers.");
  }
  if (io->GetNumberOfDimensions() != 3 || io->GetNumberOfComponents() != 1)
  {
    itkGenericExceptionMacro(<< fileName << " has " << io->GetNumberOfDimensions() << " dimensions and "
                             << io->GetNumberOfComponents() << " values per voxel; a label image has 3 and 1.");
  }
  return itk::ReadImage<LabelImageType>(fileName);
}

/** Prints each stage as it begins, and passes on that the user wants no more. */
void
Observe(MesherType * mesher)
{
  std::string last;
  mesher->AddObserver(itk::ProgressEvent(), [mesher, last](const itk::EventObject &) mutable {
    if (mesher->GetCurrentStage() != last)
    {
      last = mesher->GetCurrentStage();
      std::cout << static_cast<int>(100.0f * mesher->GetProgress()) << "% " << last << std::endl;
    }
    if (isInterrupted)
    {
      mesher->AbortGenerateDataOn();
    }
  });
}
} // namespace

int
main(int argc, char * argv[])
{
  if (argc != 3)
  {
    std::cerr << "usage: mesh-labels LABELS OUTPUT.vtu\n";
    return EXIT_FAILURE;
  }
  std::signal(SIGINT, [](int) { isInterrupted = 1; });
  itk::VTUMeshIOFactory::RegisterOneFactory();
  try
  {
    auto mesher = MesherType::New();
    mesher->SetInput(ReadLabels(argv[1]));
    mesher->SetExteriorLabels({ 0 });
    Observe(mesher);
    mesher->Update();

    auto writer = itk::MeshFileWriter<itk::LabelTetrahedralMesh>::New();
    writer->SetInput(mesher->GetOutput());
    writer->SetFileName(argv[2]);
    writer->SetFileTypeAsBINARY();
    writer->UseCompressionOn();
    writer->Update();

    std::cout << mesher->GetOutput()->GetNumberOfCells() << " tetrahedra, " << mesher->GetSurface()->GetNumberOfCells()
              << " triangles between labels\n";
  }
  catch (const itk::ProcessAborted &)
  {
    std::cerr << "interrupted\n";
    return 128 + SIGINT;
  }
  catch (const itk::ExceptionObject & exception)
  {
    std::cerr << exception.GetDescription() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
