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
// Reader and writer get their IO from here. ITK generates no header that registers mesh IOs if none of its own are in
// use.
#undef ITK_IO_FACTORY_REGISTER_MANAGER

#include "console/Errors.h"
#include "itkGmshMeshIO.h"
#include "itkMeditMeshIO.h"
#include "itkOptimizeTetrahedralMeshFilter.h"
#include "itkOutputFile.h"
#include "itkVTUMeshIO.h"
#include "MultiMaterialMeshingQuality.h"

#include "itkMeshFileReader.h"
#include "itkMeshFileWriter.h"
#include "itkMultiThreaderBase.h"

#include <CLI/CLI.hpp>

#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <string>

namespace
{
using Mesh = itk::LabelTetrahedralMesh;

constexpr int UsageFailure = 2;

struct Settings
{
  std::string   input;
  std::string   output;
  double        tolerance{ itk::OptimizeTetrahedralMeshFilter<Mesh>::Automatic };
  double        featureAngle{ 40.0 };
  int           rounds{ 10 };
  std::uint16_t threads{ 0 };
  bool          quiet{ false };
};

void
PrintError(const std::string & text)
{
  std::cerr << "optimize-tetrahedral-mesh: error: " << text << std::endl;
}

bool
EndsWith(const std::string & text, const std::string & end)
{
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

itk::MeshIOBase::Pointer
MakeIO(const std::string & fileName)
{
  if (EndsWith(fileName, ".vtu"))
  {
    return itk::VTUMeshIO::New().GetPointer();
  }
  if (EndsWith(fileName, ".msh"))
  {
    return itk::GmshMeshIO::New().GetPointer();
  }
  if (EndsWith(fileName, ".mesh"))
  {
    return itk::MeditMeshIO::New().GetPointer();
  }
  throw CLI::ValidationError("'" + fileName + "' is none of .vtu, .msh (Gmsh) and .mesh (Medit)");
}

/** Cells other than tetrahedra do not count. */
void
PrintQuality(const char * title, const Mesh * mesh)
{
  using Reader = itk::TetrahedronReader<Mesh>;
  const Reader contents(mesh, Reader::OtherCells::LeaveOut);
  const auto   quality = mmm::ComputeMeshQuality(contents.arrays, mmm::MeshQualityOptions()).tetrahedra;
  std::cout << std::fixed << title << quality.count << " tetrahedra, radius ratio " << std::setprecision(3)
            << quality.radiusRatio.average << " on average, dihedral angles " << std::setprecision(1)
            << quality.smallestAngle.minimum << " to " << quality.largestAngle << " degrees, " << quality.below[1]
            << " tetrahedra below 10 and " << quality.above[0] << " above 165" << std::endl;
}

void
Optimize(const Settings & settings)
{
  const auto reader = itk::MeshFileReader<Mesh>::New();
  const auto writer = itk::MeshFileWriter<Mesh>::New();
  reader->SetMeshIO(MakeIO(settings.input));
  writer->SetMeshIO(MakeIO(settings.output));
  if (itk::OutputFile::IsSame(settings.input, settings.output))
  {
    // triangles and other cells of the input are not in the output
    throw cli::UsageError("INPUT and OUTPUT are the same file, " + settings.output + "; choose another name");
  }
  itk::OutputFile::CheckWritable(settings.output);
  if (settings.threads > 0)
  {
    itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(settings.threads);
  }

  reader->SetFileName(settings.input);
  const auto filter = itk::OptimizeTetrahedralMeshFilter<Mesh>::New();
  filter->SetInput(reader->GetOutput());
  filter->SetTolerance(settings.tolerance);
  filter->SetFeatureAngle(settings.featureAngle);
  filter->SetMaximumNumberOfRounds(settings.rounds);
  filter->Update();
  if (!settings.quiet)
  {
    if (filter->GetNumberOfCellsLeftOut() > 0)
    {
      std::cout << "left out: " << filter->GetNumberOfCellsLeftOut() << " cells of lower dimension" << std::endl;
    }
    PrintQuality("before: ", reader->GetOutput());
    PrintQuality("after: ", filter->GetOutput());
    std::cout << "tolerance, at most: " << std::defaultfloat << std::setprecision(3) << filter->GetLargestTolerance()
              << std::endl;
  }

  writer->SetInput(filter->GetOutput());
  writer->SetFileName(settings.output);
  writer->SetFileTypeAsBINARY();
  writer->UseCompressionOn();
  writer->Update();
}
} // namespace

int
main(int argc, char * argv[])
{
  Settings settings;
  CLI::App parser(
    "Improves the tetrahedra of a labelled mesh; its interfaces stay where they are, within a tolerance.");
  parser
    .add_option("INPUT", settings.input, "Mesh of tetrahedra with labels: .vtu (cell array 'label'), .msh or .mesh")
    ->required();
  parser.add_option("OUTPUT", settings.output, "Tetrahedra with labels, in one of these formats")->required();
  parser
    .add_option("--tolerance",
                settings.tolerance,
                "How far interfaces may leave their place, in the mesh's unit [0.07 of the edges' length there]")
    ->type_name("D")
    ->check(CLI::PositiveNumber);
  parser.add_option("--feature-angle", settings.featureAngle, "Edges of interfaces that are sharper stay, in degrees")
    ->type_name("A")
    ->check(CLI::Range(0.0, 180.0))
    ->capture_default_str();
  parser.add_option("--rounds", settings.rounds, "Rounds of optimization at most")
    ->type_name("N")
    ->check(CLI::Range(0, 1000))
    ->capture_default_str();
  parser.add_option("--threads", settings.threads, "Number of threads; it does not change the result [all cores]")
    ->type_name("N")
    ->check(CLI::Range(1, 1024));
  parser.add_flag("--quiet", settings.quiet, "Print errors only");
  try
  {
    parser.parse(argc, argv);
    Optimize(settings);
    return EXIT_SUCCESS;
  }
  catch (const CLI::CallForHelp & request)
  {
    return parser.exit(request);
  }
  catch (const CLI::ParseError & error)
  {
    PrintError(cli::ToOneLine(error.what()));
    return UsageFailure;
  }
  catch (const cli::UsageError & error)
  {
    PrintError(error.what());
    return UsageFailure;
  }
  catch (...)
  {
    PrintError(cli::DescribeCurrentException());
  }
  return EXIT_FAILURE;
}
