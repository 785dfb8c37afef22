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
// Which labels are meshed, and under which numbers.
#include "CommandLineTest.h"

#include "itkMultiMaterialMeshTypes.h"
#include "itkVTUMeshIO.h"

// Readers get their IO from the tests; ITK may not have generated the header that registers mesh IOs.
#undef ITK_IO_FACTORY_REGISTER_MANAGER
#include "itkMeshFileReader.h"

#include <fstream>

namespace
{
class CommandLineLabels : public CommandLine
{
public:
  /** The labels of the mesh of MakeBalls(), which has 0 (outside), 2 and, within it, 5. */
  std::set<int>
  LabelsWith(std::vector<std::string> options, const std::string & error = "") const
  {
    options.insert(options.begin(), { this->WriteBalls(), this->Path("out.vtu"), "--quiet" });
    const auto result = Run(options);
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.error, error.empty() ? "" : "multimaterial-mesh: warning: " + error + "\n");
    const auto reader = itk::MeshFileReader<itk::LabelTetrahedralMesh>::New();
    reader->SetMeshIO(itk::VTUMeshIO::New());
    reader->SetFileName(this->Path("out.vtu"));
    reader->Update();
    const auto & labels = reader->GetOutput()->GetCellData()->CastToSTLConstContainer();
    return { labels.begin(), labels.end() };
  }

  void
  ExpectUsageError(std::vector<std::string> options, const std::string & message) const
  {
    options.insert(options.begin(), { this->WriteBalls(), this->Path("out.vtu") });
    this->ExpectError(options, 2, message);
  }

  std::string
  WriteMap(const std::string & text) const
  {
    std::ofstream(this->Path("map.txt")) << text;
    return this->Path("map.txt");
  }
};
} // namespace

TEST_F(CommandLineLabels, ListedOnesAreMeshed)
{
  EXPECT_EQ(this->LabelsWith({ "--labels", "5" }), (std::set<int>{ 5 }));
  EXPECT_EQ(this->LabelsWith({ "--labels", "2,77" }, "no voxel has the label 77 that --labels names"),
            (std::set<int>{ 2 }));
}

TEST_F(CommandLineLabels, MergedOnesAreOne)
{
  EXPECT_EQ(this->LabelsWith({ "--merge", "9=2,5" }), (std::set<int>{ 9 }));
  EXPECT_EQ(this->LabelsWith({ "--merge", "9=2", "--merge", "8=5" }), (std::set<int>{ 8, 9 }));
  EXPECT_EQ(this->LabelsWith({ "--merge", "2=5,6" }, "no voxel has the label 6 that --merge names"),
            (std::set<int>{ 2 }));
}

TEST_F(CommandLineLabels, MapRenamesBeforeTheOthers)
{
  const auto map = this->WriteMap("# old new\n2 3 # ball\n\n4..6 -7\n");
  EXPECT_EQ(this->LabelsWith({ "--map", map }), (std::set<int>{ -7, 3 }));
  EXPECT_EQ(this->LabelsWith({ "--map", map, "--merge", "1=3", "--labels", "1" }), (std::set<int>{ 1 }));
  EXPECT_EQ(this->LabelsWith({ "--map", this->WriteMap("5 4\n* 0\n") }), (std::set<int>{ 4 }));
}

TEST_F(CommandLineLabels, WhatCannotBeUnderstoodIsRefused)
{
  this->ExpectUsageError({ "--merge", "9" }, "--merge is '9'; it has to be NEW=L,L");
  this->ExpectUsageError({ "--merge", "9=2,x" }, "--merge is '9=2,x'");
  this->ExpectUsageError({ "--merge", "9=2", "--merge", "8=2" }, "--merge names label 2 twice");
  this->ExpectUsageError({ "--labels", "2", "--exterior", "none" }, "--labels needs an exterior label");
  const auto labels = this->WriteBalls();
  const auto expectMapError = [&](const std::string & text, const std::string & message) {
    this->ExpectError({ labels, this->Path("out.vtu"), "--map", this->WriteMap(text) }, 1, message);
  };
  expectMapError("2 3\n5\n", "map.txt: line 2 is not OLD NEW");
  expectMapError("6..2 3\n", "map.txt: line 1 is not OLD NEW");
  expectMapError("1..5 3\n2 4\n", "map.txt: line 2 gives label 2 another number");
  this->ExpectError({ labels, this->Path("out.vtu"), "--map", this->Path("none.txt") }, 1, "none.txt");
}

TEST_F(CommandLineLabels, ManyLabelsOfSomeSizeAreNoIntensities)
{
  // 1,331 blocks of 4 x 4 x 4 voxels
  const auto image = MakeImage<short>(itk::Size<3>{ { 44, 44, 44 } });
  auto *     label = image->GetBufferPointer();
  for (int k = 0; k < 44; ++k)
  {
    for (int j = 0; j < 44; ++j)
    {
      for (int i = 0; i < 44; ++i)
      {
        *label++ = short(1 + i / 4 + 11 * (j / 4) + 121 * (k / 4));
      }
    }
  }
  const auto result = Run({ this->WriteImage<LabelImage>(image, "blocks.nrrd"),
                            this->Path("out.vtu"),
                            "--max-tetrahedra",
                            "1000",
                            "--exterior",
                            "none" });
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_NE(result.error.find("tetrahedra"), std::string::npos) << result.error;
  EXPECT_EQ(result.error.find("intensity"), std::string::npos) << result.error;
}
