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
// What the program writes and prints.
#include "CommandLineTest.h"

#include "options/OptionTable.h"
#include "itkMultiMaterialMeshTypes.h"
#include "itkVTUMeshIO.h"

#include "itkImageFileReader.h"
#include "itkImageRegionIteratorWithIndex.h"
// Readers get their IO from the tests; ITK may not have generated the header that registers mesh IOs.
#undef ITK_IO_FACTORY_REGISTER_MANAGER
#include "itkMeshFileReader.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

namespace
{
using FloatImage = itk::Image<float, 3>;

class CommandLineOutput : public CommandLine
{
public:
  /** Meshes MakeBalls() to out.vtu without complaint. */
  RunResult
  Mesh(std::vector<std::string> options = {}) const
  {
    options.insert(options.begin(), { this->WriteBalls(), this->Path("out.vtu") });
    auto result = Run(options);
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.error, "");
    EXPECT_TRUE(this->Files().count("out.vtu"));
    return result;
  }

  nlohmann::json
  Report() const
  {
    return nlohmann::json::parse(this->Contents("report.json"));
  }

  template <typename TMesh>
  typename TMesh::Pointer
  ReadMesh(const std::string & name, const std::vector<std::string> & pointDataNames = {}) const
  {
    auto reader = itk::MeshFileReader<TMesh>::New();
    auto io = itk::VTUMeshIO::New();
    if (!pointDataNames.empty())
    {
      io->SetPointDataNames(pointDataNames);
    }
    reader->SetMeshIO(io);
    reader->SetFileName(this->Path(name));
    reader->Update();
    typename TMesh::Pointer mesh = reader->GetOutput();
    mesh->DisconnectPipeline();
    return mesh;
  }

  /** Tetrahedra by label. */
  std::map<int, std::size_t>
  CountLabels(const std::string & name) const
  {
    std::map<int, std::size_t> counts;
    const auto                 mesh = this->ReadMesh<itk::LabelTetrahedralMesh>(name);
    for (const int label : mesh->GetCellData()->CastToSTLConstContainer())
    {
      ++counts[label];
    }
    return counts;
  }
};
} // namespace

TEST_F(CommandLineOutput, MeshHasTheLabelsOfTheImage)
{
  this->Mesh();
  const auto counts = this->CountLabels("out.vtu");
  EXPECT_EQ(counts.size(), 2u);
  EXPECT_EQ(counts.count(2), 1u);
  EXPECT_EQ(counts.count(5), 1u);
}

TEST_F(CommandLineOutput, LeavesNoOtherFiles)
{
  this->Mesh();
  EXPECT_EQ(this->Files(), (std::set<std::string>{ "labels.nrrd", "out.vtu" }));
}

TEST_F(CommandLineOutput, ReplacesAnOlderFile)
{
  std::ofstream(this->Path("out.vtu")) << "old";
  this->Mesh();
  EXPECT_GT(std::filesystem::file_size(this->Path("out.vtu")), 1000u);
}

#ifndef _WIN32
TEST_F(CommandLineOutput, SymbolicLinkIsWrittenThrough)
{
  const std::vector<std::string> arguments{ this->WriteBalls(), this->Path("out.vtu"), "--quiet" };
  std::filesystem::create_directory(this->Path("store"));
  std::ofstream(this->Path("store/mesh.vtu")) << "old";
  std::filesystem::create_symlink("store/mesh.vtu", this->Path("out.vtu"));
  EXPECT_EQ(Run(arguments).exitCode, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(this->Path("out.vtu")));
  EXPECT_GT(std::filesystem::file_size(this->Path("store/mesh.vtu")), 1000u);
  // also to a file that there is not yet
  std::filesystem::remove(this->Path("store/mesh.vtu"));
  EXPECT_EQ(Run(arguments).exitCode, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(this->Path("out.vtu")));
  EXPECT_GT(std::filesystem::file_size(this->Path("store/mesh.vtu")), 1000u);
}

TEST_F(CommandLineOutput, PermissionsOfAnOlderFileAreKept)
{
  using std::filesystem::perms;
  const auto mode = perms::owner_read | perms::owner_write | perms::group_read | perms::group_write;
  for (const char * const name : { "out.vtu", "report.json" })
  {
    std::ofstream(this->Path(name)) << "old";
    std::filesystem::permissions(this->Path(name), mode);
  }
  this->Mesh({ "--quiet", "--report", this->Path("report.json") });
  EXPECT_EQ(std::filesystem::status(this->Path("out.vtu")).permissions(), mode);
  EXPECT_EQ(std::filesystem::status(this->Path("report.json")).permissions(), mode);
}
#endif

TEST_F(CommandLineOutput, SummaryListsFilesLabelsAndTime)
{
  const auto result = this->Mesh({ "--surface-per-label", this->Path("part"), "--report", this->Path("report.json") });
  for (const char * const text :
       { "out.vtu, ", "part2.stl, ", "part5.stl, ", "report.json\n", "label 2: ", "label 5: " })
  {
    EXPECT_NE(result.output.find(text), std::string::npos) << text;
  }
  const auto time = result.output.find("time: ");
  ASSERT_NE(time, std::string::npos);
  EXPECT_GT(std::stod(result.output.substr(time + 6)), 0.0);
  // the ball of label 2 is some 1,000 mm^3
  const auto percent = result.output.find(" mm^3, ", result.output.find("label 2: "));
  ASSERT_NE(percent, std::string::npos);
  EXPECT_LT(std::abs(std::stod(result.output.substr(percent + 7))), 5.0);
}

TEST_F(CommandLineOutput, ReportHasTheAffine)
{
  this->Mesh({ "--quiet", "--report", this->Path("report.json") });
  const auto affine = this->Report()["input"]["affine_mm"];
  EXPECT_EQ(affine, nlohmann::json::parse("[[1,0,0,0],[0,1,0,0],[0,0,1,0]]"));
}

TEST_F(CommandLineOutput, ExteriorNoneMeshesEverything)
{
  this->Mesh({ "--exterior", "none" });
  EXPECT_EQ(this->CountLabels("out.vtu").count(0), 1u);
}

TEST_F(CommandLineOutput, ExteriorReplacesTheDefault)
{
  this->Mesh({ "--exterior", "5" });
  const auto counts = this->CountLabels("out.vtu");
  EXPECT_EQ(counts.count(0), 1u);
  EXPECT_EQ(counts.count(5), 0u);
}

TEST_F(CommandLineOutput, WarnsOfALabelThatLosesMuchAsIslands)
{
  // 27 voxels, and three islands of one
  const auto image = MakeBalls();
  for (itk::ImageRegionIteratorWithIndex<LabelImage> it(image, image->GetBufferedRegion()); !it.IsAtEnd(); ++it)
  {
    const auto & at = it.GetIndex();
    const auto   isWithin = [&](int first, int last) {
      return std::all_of(at.begin(), at.end(), [=](auto i) { return i >= first && i <= last; });
    };
    const bool isIsland = at[0] == 10 && at[1] == 10 && at[2] % 2 == 0;
    it.Set(!isWithin(3, 12) ? 0 : (isWithin(4, 6) || (isIsland && isWithin(5, 11)) ? 5 : 2));
  }
  const auto labels = this->WriteImage<LabelImage>(image, "islands.nrrd");
  const auto result = Run({ labels, this->Path("out.vtu"), "--quiet" });
  EXPECT_EQ(result.error,
            "multimaterial-mesh: warning: label 5 loses 3 of its 30 voxels as islands of fewer voxels than "
            "--min-island; --min-island 0 keeps them\n");
  EXPECT_EQ(Run({ labels, this->Path("out.vtu"), "--quiet", "--min-island", "0" }).error, "");
}

TEST_F(CommandLineOutput, AbsentExteriorWarns)
{
  const auto result = Run({ this->WriteBalls(), this->Path("out.vtu"), "--exterior", "0,77", "--quiet" });
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.error, "multimaterial-mesh: warning: no voxel has the exterior label 77\n");
}

TEST_F(CommandLineOutput, AbsentDefaultExteriorWarns)
{
  const auto image = MakeBalls();
  std::replace(image->GetBufferPointer(), image->GetBufferPointer() + 16 * 16 * 16, 0, 1);
  const auto result = Run({ this->WriteImage<LabelImage>(image, "one.nrrd"), this->Path("out.vtu"), "--quiet" });
  EXPECT_EQ(result.exitCode, 0);
  ASSERT_EQ(result.ErrorLines().size(), 1u);
  EXPECT_NE(result.error.find("warning: no voxel has the exterior label 0, so everything is meshed"),
            std::string::npos);
  EXPECT_EQ(this->CountLabels("out.vtu").size(), 3u);
}

TEST_F(CommandLineOutput, ExteriorThatAirAddsIsNotAbsent)
{
  const auto image = MakeBalls();
  std::replace(image->GetBufferPointer(), image->GetBufferPointer() + 16 * 16 * 16, 0, 1);
  const auto labels = this->WriteImage<LabelImage>(image, "one.nrrd");
  const auto error = [&](const std::vector<std::string> & options) {
    std::vector<std::string> arguments{ labels, this->Path("out.vtu"), "--quiet" };
    arguments.insert(arguments.end(), options.begin(), options.end());
    const auto result = Run(arguments);
    EXPECT_EQ(result.exitCode, 0);
    return result.error;
  };
  EXPECT_EQ(error({ "--air-margin", "2" }), "");
  EXPECT_EQ(this->CountLabels("out.vtu").count(0), 1u);
  EXPECT_NE(error({ "--air-margin", "0" }).find("no voxel has the exterior label 0, so there is no air"),
            std::string::npos);
  EXPECT_NE(error({ "--fill-exterior" }).find("no voxel has the exterior label 0, so there is no air"),
            std::string::npos);
}

TEST_F(CommandLineOutput, WhatHasNoEffectWarns)
{
  const auto result = Run({ this->WriteBalls(), this->Path("out.vtu"), "--msh-format", "2.2", "--quiet" });
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.error, "multimaterial-mesh: warning: --msh-format 2.2 has no effect, as no .msh file is written\n");
}

TEST_F(CommandLineOutput, LongVoxelsAreDividedOrWarn)
{
  const auto   image = MakeBalls();
  const double spacing[] = { 1.0, 1.0, 6.0 };
  image->SetSpacing(spacing);
  const auto input = this->WriteImage<LabelImage>(image, "long.nrrd");
  const auto divided = Run({ input, this->Path("out.vtu"), "--quiet" });
  EXPECT_EQ(divided.exitCode, 0);
  ASSERT_EQ(divided.ErrorLines().size(), 1u) << divided.error;
  EXPECT_NE(divided.error.find("warning: Voxels of 1 x 1 x 6 mm are divided into 1 x 1 x 3"), std::string::npos)
    << divided.error;
  const auto kept = Run({ input, this->Path("out.vtu"), "--quiet", "--keep-slices" });
  EXPECT_EQ(kept.exitCode, 0);
  ASSERT_EQ(kept.ErrorLines().size(), 1u) << kept.error;
  EXPECT_NE(kept.error.find("warning: voxels are 6 times as long as wide"), std::string::npos) << kept.error;
}

TEST_F(CommandLineOutput, ShearedImageIsMeshedWhereItIs)
{
  const auto                image = MakeBalls();
  LabelImage::DirectionType direction;
  direction.SetIdentity();
  direction(0, 1) = 0.6;
  direction(1, 1) = 0.8;
  image->SetDirection(direction);
  const auto result = Run({ this->WriteImage<LabelImage>(image, "sheared.nrrd"),
                            this->Path("out.vtu"),
                            "--quiet",
                            "--report",
                            this->Path("report.json") });
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_NE(result.error.find("its axes are not at right angles (53.1 degrees)"), std::string::npos) << result.error;
  const auto report = this->Report();
  double     meshed = 0.0;
  for (const auto & label : report["quality"]["labels"])
  {
    meshed += label["volume_mm3"].get<double>();
    EXPECT_EQ(label["non_positive"], 0);
  }
  double voxels = 0.0;
  for (const auto & label : report["input"]["labels"])
  {
    voxels += label["label"] == 0 ? 0.0 : label["voxels"].get<double>();
  }
  EXPECT_NEAR(meshed / (0.8 * voxels), 1.0, 0.03);
}

TEST_F(CommandLineOutput, QuietIsQuiet) { EXPECT_EQ(this->Mesh({ "--quiet" }).output, ""); }

TEST_F(CommandLineOutput, StagesAndSummaryArePlainLines)
{
  const auto result = this->Mesh();
  EXPECT_NE(result.output.find("sizing ... "), std::string::npos);
  EXPECT_NE(result.output.find(" tetrahedra"), std::string::npos);
  EXPECT_EQ(result.output.find('\r'), std::string::npos);
}

TEST_F(CommandLineOutput, ReportHasTheCountsOfTheFiles)
{
  this->Mesh({ "--report", this->Path("report.json"), "--surface", this->Path("surface.vtu") });
  const auto report = this->Report();
  const auto mesh = this->ReadMesh<itk::LabelTetrahedralMesh>("out.vtu");
  const auto surface = this->ReadMesh<itk::LabelInterfaceMesh>("surface.vtu");
  EXPECT_EQ(report["counts"]["tetrahedra"], mesh->GetNumberOfCells());
  EXPECT_EQ(report["counts"]["points"], mesh->GetNumberOfPoints());
  EXPECT_EQ(report["counts"]["triangles"], surface->GetNumberOfCells());
  EXPECT_EQ(report["counts"]["surface_points"], surface->GetNumberOfPoints());
  EXPECT_EQ(report["quality"]["overall"]["tetrahedra"], mesh->GetNumberOfCells());
  const auto counts = this->CountLabels("out.vtu");
  ASSERT_EQ(report["quality"]["labels"].size(), counts.size());
  for (const auto & label : report["quality"]["labels"])
  {
    EXPECT_EQ(label["tetrahedra"], counts.at(label["label"]));
  }
}

TEST_F(CommandLineOutput, ReportTellsTheQualityOfTriangles)
{
  this->Mesh({ "--report", this->Path("report.json") });
  const auto   quality = this->Report()["quality"]["triangle_radius_ratio"];
  const double average = quality["average"];
  const double percentile = quality["first_percentile"];
  const double minimum = quality["minimum"];
  EXPECT_GT(minimum, 0.3);
  EXPECT_GT(percentile, minimum);
  EXPECT_GT(average, percentile);
  EXPECT_LT(average, 1.0);
}

TEST_F(CommandLineOutput, ReportTellsInputAndParameters)
{
  const auto image = MakeBalls();
  image->SetSpacing(itk::Vector<double, 3>(std::array<double, 3>{ { 2.0, 2.5, 3.0 } }.data()));
  const auto labels = this->WriteImage<LabelImage>(image, "coarse.nrrd");
  const auto result = Run({ labels,
                            this->Path("out.vtu"),
                            "--report",
                            this->Path("report.json"),
                            "--exterior",
                            "0,9",
                            "--max-size",
                            "12",
                            "--quiet" });
  EXPECT_EQ(result.exitCode, 0);
  const auto report = this->Report();
  EXPECT_EQ(report["input"]["file"], labels);
  EXPECT_EQ(report["input"]["size"], (nlohmann::json{ 16, 16, 16 }));
  EXPECT_EQ(report["input"]["spacing_mm"], (nlohmann::json{ 2.0, 2.5, 3.0 }));
  ASSERT_EQ(report["input"]["labels"].size(), 3u);
  EXPECT_EQ(report["input"]["labels"][2]["label"], 5);
  EXPECT_EQ(report["parameters"]["radius_mm"], 1.0);
  EXPECT_EQ(report["parameters"]["tolerance_mm"], 0.2);
  EXPECT_EQ(report["parameters"]["min_size_mm"], 2.0);
  EXPECT_EQ(report["parameters"]["max_size_mm"], 12.0);
  EXPECT_EQ(report["parameters"]["exterior"], (nlohmann::json{ 0, 9 }));
  EXPECT_EQ(report["exterior_labels_absent"], nlohmann::json{ 9 });
}

TEST_F(CommandLineOutput, ReportHasTimeAndMemoryPerStage)
{
  this->Mesh({ "--report", this->Path("report.json") });
  const auto stages = this->Report()["stages"];
  EXPECT_GT(stages.size(), 5u);
  for (const auto & stage : stages)
  {
    EXPECT_FALSE(std::string(stage["name"]).empty());
    EXPECT_GE(double(stage["seconds"]), 0.0);
  }
  EXPECT_EQ(stages.front()["name"], "reading");
  EXPECT_EQ(stages.back()["name"], "writing");
}

TEST_F(CommandLineOutput, ReportTellsOfMergedIslands)
{
  const auto image = MakeBalls();
  image->SetPixel({ { 7, 7, 2 } }, 5);
  const auto labels = this->WriteImage<LabelImage>(image, "speckled.nrrd");
  const auto report = this->Path("report.json");
  EXPECT_EQ(Run({ labels, this->Path("out.vtu"), "--report", report, "--quiet" }).exitCode, 0);
  const auto islands = this->Report()["islands_merged"];
  ASSERT_EQ(islands.size(), 1u);
  EXPECT_EQ(islands[0]["label"], 5);
  EXPECT_EQ(islands[0]["voxels"], 1);
  EXPECT_EQ(islands[0]["went_to"][0]["label"], 2);

  EXPECT_EQ(Run({ labels, this->Path("out.vtu"), "--report", report, "--quiet", "--min-island", "0" }).exitCode, 0);
  EXPECT_TRUE(this->Report()["islands_merged"].empty());
}

TEST_F(CommandLineOutput, SurfaceOnly)
{
  this->Mesh({ "--surface-only", "--report", this->Path("report.json") });
  const auto surface = this->ReadMesh<itk::LabelInterfaceMesh>("out.vtu");
  EXPECT_GT(surface->GetNumberOfCells(), 100u);
  const auto report = this->Report();
  EXPECT_EQ(report["counts"]["triangles"], surface->GetNumberOfCells());
  EXPECT_EQ(report["counts"]["tetrahedra"], 0);
}

TEST_F(CommandLineOutput, SurfaceIsThatOfTheTetrahedra)
{
  this->Mesh({ "--surface", this->Path("surface.vtu") });
  std::set<std::pair<int, int>> pairs;
  const auto                    surface = this->ReadMesh<itk::LabelInterfaceMesh>("surface.vtu");
  for (const auto & labels : surface->GetCellData()->CastToSTLConstContainer())
  {
    pairs.insert({ labels[0], labels[1] });
  }
  EXPECT_EQ(pairs, (std::set<std::pair<int, int>>{ { 0, 2 }, { 2, 5 } }));
}

TEST_F(CommandLineOutput, Particles)
{
  this->Mesh({ "--particles", this->Path("particles.vtu"), "--report", this->Path("report.json") });
  const auto counts = this->Report()["counts"];
  const int  expected =
    int(counts["particles_on_0_cells"]) + int(counts["particles_on_1_cells"]) + int(counts["particles_on_2_cells"]);
  const auto particles = this->ReadMesh<itk::LabelParticleMesh>(
    "particles.vtu", { "dimension", "label_a", "label_b", "label_c", "label_d" });
  ASSERT_EQ(particles->GetNumberOfPoints(), std::size_t(expected));
  for (const auto & particle : particles->GetPointData()->CastToSTLConstContainer())
  {
    EXPECT_EQ(particle[0], 2);
    EXPECT_TRUE((particle[1] == 0 && particle[2] == 2) || (particle[1] == 2 && particle[2] == 5));
  }
}

TEST_F(CommandLineOutput, Junctions)
{
  this->Mesh({ "--exterior", "none", "--junctions", this->Path("junctions.vtu") });
  const auto reader = itk::MeshFileReader<itk::LabelJunctionMesh>::New();
  const auto io = itk::VTUMeshIO::New();
  io->SetCellDataNames({ "curve", "label_count", "label_a", "label_b", "label_c", "label_d" });
  reader->SetMeshIO(io);
  reader->SetFileName(this->Path("junctions.vtu"));
  reader->Update();
  // the edges and corners of the image's box, where label 0 meets the outside, -1
  std::set<int> curves;
  for (const auto & cell : reader->GetOutput()->GetCellData()->CastToSTLConstContainer())
  {
    curves.insert(cell[0]);
    EXPECT_EQ(cell[1], 2);
    EXPECT_EQ(cell[2], -1);
    EXPECT_EQ(cell[3], 0);
  }
  EXPECT_EQ(curves.size(), 13u);
}

TEST_F(CommandLineOutput, JunctionsMayBeNone)
{
  this->Mesh({ "--junctions", this->Path("junctions.vtu") });
  EXPECT_EQ(this->ReadMesh<itk::LabelTetrahedralMesh>("junctions.vtu")->GetNumberOfPoints(), 0u);
}

TEST_F(CommandLineOutput, Indicators)
{
  this->Mesh({ "--save-indicators", this->Path("f") });
  EXPECT_EQ(this->Files(), (std::set<std::string>{ "f0.nrrd", "f2.nrrd", "f5.nrrd", "labels.nrrd", "out.vtu" }));
  const auto    indicator = itk::ReadImage<FloatImage>(this->Path("f5.nrrd"));
  itk::Index<3> index;
  ASSERT_TRUE(indicator->TransformPhysicalPointToIndex(itk::Point<double, 3>(7.0), index));
  EXPECT_GT(indicator->GetPixel(index), 1.0f);
}

TEST_F(CommandLineOutput, SizingCanBeSavedAndReused)
{
  for (const char * const name : { "size.nrrd", "size.nii.gz", "size.mha" })
  {
    this->Mesh({ "--save-sizing", this->Path(name) });
    const auto sizing = itk::ReadImage<FloatImage>(this->Path(name));
    EXPECT_EQ(sizing->GetLargestPossibleRegion().GetSize(), (itk::Size<3>{ { 16, 16, 16 } }));
    this->Mesh({ "--sizing-image", this->Path(name) });
  }
}

TEST_F(CommandLineOutput, SizingImageIsNotExceeded)
{
  this->Mesh({ "--max-size", "4" });
  const auto coarse = this->ReadMesh<itk::LabelTetrahedralMesh>("out.vtu")->GetNumberOfCells();
  const auto image = MakeImage<float>(itk::Size<3>{ { 16, 16, 16 } });
  image->FillBuffer(1.0f);
  this->Mesh({ "--sizing-image", this->WriteImage<FloatImage>(image, "size.nrrd") });
  EXPECT_GT(this->ReadMesh<itk::LabelTetrahedralMesh>("out.vtu")->GetNumberOfCells(), 2 * coarse);
}

TEST_F(CommandLineOutput, ThreadsDoNotMatter)
{
  this->Mesh({ "--threads", "1" });
  const auto one = this->Contents("out.vtu");
  this->Mesh({ "--threads", "3" });
  EXPECT_TRUE(this->Contents("out.vtu") == one);
}

TEST_F(CommandLineOutput, SeedMatters)
{
  this->Mesh({ "--seed", "1" });
  const auto first = this->Contents("out.vtu");
  this->Mesh({ "--seed", "2" });
  EXPECT_FALSE(this->Contents("out.vtu") == first);
}

TEST_F(CommandLineOutput, RotatedImageGivesTheRotatedMesh)
{
  this->Mesh();
  const auto straight = this->ReadMesh<itk::LabelTetrahedralMesh>("out.vtu");

  const auto                image = MakeBalls();
  LabelImage::DirectionType direction;
  const double              c = std::cos(0.5);
  const double              s = std::sin(0.5);
  const double              values[3][3] = { { c, -s, 0.0 }, { s, c, 0.0 }, { 0.0, 0.0, -1.0 } };
  std::copy_n(&values[0][0], 9, direction.GetVnlMatrix().data_block());
  image->SetDirection(direction);
  image->SetOrigin(itk::Point<double, 3>(std::array<double, 3>{ { 10.0, -20.0, 30.0 } }.data()));
  const auto result = Run({ this->WriteImage<LabelImage>(image, "rotated.nrrd"), this->Path("rotated.vtu") });
  EXPECT_EQ(result.error, "");
  const auto rotated = this->ReadMesh<itk::LabelTetrahedralMesh>("rotated.vtu");

  ASSERT_EQ(rotated->GetNumberOfPoints(), straight->GetNumberOfPoints());
  EXPECT_EQ(rotated->GetNumberOfCells(), straight->GetNumberOfCells());
  for (unsigned int p = 0; p < straight->GetNumberOfPoints(); ++p)
  {
    const auto expected =
      direction * straight->GetPoint(p).GetVectorFromOrigin() + image->GetOrigin().GetVectorFromOrigin();
    EXPECT_LT((rotated->GetPoint(p).GetVectorFromOrigin() - expected).GetNorm(), 1e-9);
  }
}
