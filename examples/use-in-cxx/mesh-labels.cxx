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
// Meshes a label image: mesh-labels LABELS OUTPUT.vtu
#include "itkLabelImageToTetrahedralMeshFilter.h"
#include "itkVTUMeshIOFactory.h"

#include "itkImageFileReader.h"
#include "itkMeshFileWriter.h"

#include <cstdlib>
#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 3)
  {
    std::cerr << "usage: mesh-labels LABELS OUTPUT.vtu\n";
    return EXIT_FAILURE;
  }
  itk::VTUMeshIOFactory::RegisterOneFactory();
  try
  {
    using LabelImageType = itk::Image<short, 3>;
    const auto labels = itk::ReadImage<LabelImageType>(argv[1]);

    auto mesher = itk::LabelImageToTetrahedralMeshFilter<LabelImageType>::New();
    mesher->SetInput(labels);
    mesher->SetExteriorLabels({ 0 });
    mesher->Update();

    auto writer = itk::MeshFileWriter<itk::LabelTetrahedralMesh>::New();
    writer->SetInput(mesher->GetOutput());
    writer->SetFileName(argv[2]);
    writer->SetFileTypeAsBINARY();
    writer->UseCompressionOn();
    writer->Update();

    std::cout << mesher->GetOutput()->GetNumberOfCells() << " tetrahedra, "
              << mesher->GetSurface()->GetNumberOfCells() << " triangles between labels\n";
  }
  catch (const itk::ExceptionObject & exception)
  {
    std::cerr << exception.GetDescription() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
