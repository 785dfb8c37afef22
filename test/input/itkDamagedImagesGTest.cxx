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
// What becomes of damaged label images: a mesh, or an exception with words to print.
#include "itkLabelImageToTetrahedralMeshFilter.h"
#include "itkTetrahedralMeshQualityCalculator.h"
#include "itkVolumeFileReader.h"
#include "support/TestDamage.h"
#include "support/TestLabelImages.h"

#include "itkImageFileReader.h" // registers ITK's formats
#include "itkImageFileWriter.h"

#include <filesystem>
#include <fstream>
#include <sstream>

namespace
{
using LabelImage = itk::Image<int, 3>;
using Mesher = itk::LabelImageToTetrahedralMeshFilter<LabelImage>;

std::string
Contents(const std::string & fileName)
{
  std::ifstream      file(fileName, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/** The volumes of all tetrahedra of the file's mesh are positive, or it says why there is none. Returns whether it
 * does. */
bool
IsRefused(const std::string & fileName)
{
  try
  {
    const auto reader = itk::VolumeFileReader::New();
    reader->SetFileName(fileName);
    const auto mesher = Mesher::New();
    mesher->SetInput(reader->ReadLabels());
    mesher->SetMaximumNumberOfTetrahedra(100000);
    mesher->Update();
    const auto calculator = itk::TetrahedralMeshQualityCalculator<itk::LabelTetrahedralMesh>::New();
    calculator->SetMesh(mesher->GetOutput());
    calculator->Compute();
    EXPECT_EQ(calculator->GetReport().tetrahedra.nonPositive, 0u);
    return false;
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_STRNE(error.GetDescription(), "");
    return true;
  }
}
} // namespace

TEST(DamagedImages, GiveAMeshOrSayWhyNot)
{
  const std::filesystem::path folder =
    std::filesystem::temp_directory_path() / ("damaged-" + std::to_string(std::random_device()()));
  std::filesystem::create_directories(folder);
  const auto image = mmmtest::MakeBall<itk::Image<short, 3>>(8, 3.0);
  for (const char * const format : { ".nii", ".nii.gz", ".nrrd", ".mha" })
  {
    const auto name = (folder / ("image" + std::string(format))).string();
    itk::WriteImage(image, name);
    const auto [refused, all] = mmmtest::CountRejected({ Contents(name) }, 25, [&](const std::string & damaged) {
      std::ofstream(name, std::ios::binary) << damaged;
      return IsRefused(name);
    });
    EXPECT_GT(refused, all / 20) << format;
    EXPECT_LT(refused, all) << format;
  }
  std::filesystem::remove_all(folder);
}
