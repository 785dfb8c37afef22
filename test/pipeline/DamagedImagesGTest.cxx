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
#include "support/TestFiles.h"
#include "support/TestLabelImages.h"
#include "support/TestSeeds.h"

#include "itkImageFileReader.h" // registers ITK's formats
#include "itkImageFileWriter.h"

#include <filesystem>

namespace
{
using LabelImage = itk::Image<int, 3>;
using Mesher = itk::LabelImageToTetrahedralMeshFilter<LabelImage>;

/** The volumes of all tetrahedra of the file's mesh are positive, or it says why there is none. Returns whether there
 * is one. */
bool
IsMeshed(const std::string & fileName)
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
    return true;
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_STRNE(error.GetDescription(), "");
    std::cout << "refused: " << error.GetDescription() << '\n';
    return false;
  }
}

class DamagedImages : public ::testing::TestWithParam<int>
{};
} // namespace

TEST_P(DamagedImages, GiveAMeshOrSayWhyNot)
{
  const int         seed = GetParam();
  const std::string formats[] = { ".nii", ".nii.gz", ".nrrd", ".mha" };
  const std::string name = ::testing::TempDir() + "damaged-" + std::to_string(seed) + formats[seed % 4];
  itk::WriteImage(mmmtest::MakeBall<itk::Image<short, 3>>(8, 3.0), name);
  ASSERT_TRUE(IsMeshed(name));
  const std::string whole = mmmtest::Content(name);
  std::mt19937      random(static_cast<unsigned int>(seed));
  mmmtest::Save(name, mmmtest::DamageAtRandom(whole, random));
  IsMeshed(name);
  std::filesystem::remove(name);
}

INSTANTIATE_TEST_SUITE_P(Seeds,
                         DamagedImages,
                         ::testing::ValuesIn(mmmtest::Seeds(40)),
                         ::testing::PrintToStringParamName());
