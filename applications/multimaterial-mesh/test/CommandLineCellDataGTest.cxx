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
// Numbers of tetrahedra: conductivities and other images.
#include "CommandLineTest.h"

#include "itkMultiMaterialMeshTypes.h"
#include "itkVTUMeshIO.h"

#include "itkMesh.h"
#include "itkSymmetricSecondRankTensor.h"
// Readers get their IO from the tests; ITK may not have generated the header that registers mesh IOs.
#undef ITK_IO_FACTORY_REGISTER_MANAGER
#include "itkMeshFileReader.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <map>

namespace
{
/** MakeBalls() has 0 outside, 2 and, within it, 5. */
class CommandLineCellData : public CommandLine
{
public:
  using DataMesh = itk::Mesh<double, 3, itk::DefaultStaticMeshTraits<double, 3, 3, double>>;

  std::string
  WriteText(const std::string & name, const std::string & text) const
  {
    std::ofstream(this->Path(name)) << text;
    return this->Path(name);
  }

  DataMesh::Pointer
  Read(const std::string & array) const
  {
    const auto io = itk::VTUMeshIO::New();
    io->SetCellDataNames({ array });
    const auto reader = itk::MeshFileReader<DataMesh>::New();
    reader->SetMeshIO(io);
    reader->SetFileName(this->Path("out.vtu"));
    reader->Update();
    return reader->GetOutput();
  }

  std::vector<double>
  Values(const std::string & array) const
  {
    return this->Read(array)->GetCellData()->CastToSTLConstContainer();
  }

  RunResult
  Mesh(std::vector<std::string> options) const
  {
    options.insert(options.begin(), { this->WriteBalls(), this->Path("out.vtu"), "--quiet" });
    auto result = Run(options);
    EXPECT_EQ(result.exitCode, 0) << result.error;
    return result;
  }

  /** 1 + the distance to the left of voxel 0, on a grid that begins at `first` voxels of the balls' image. */
  std::string
  WriteRamp(const std::string & name, double first = -2.0) const
  {
    const auto   image = MakeImage<float>(itk::Size<3>{ { 50, 40, 40 } });
    const double spacing[] = { 0.5, 0.5, 0.5 };
    const double origin[] = { first, -2.0, -2.0 };
    image->SetSpacing(spacing);
    image->SetOrigin(origin);
    for (std::size_t n = 0; n < 50 * 40 * 40; ++n)
    {
      image->GetBufferPointer()[n] = float(1.0 + first + 0.5 * double(n % 50));
    }
    return this->WriteImage<itk::Image<float, 3>>(image, name);
  }
};
} // namespace

TEST_F(CommandLineCellData, ConductivityIsThatOfTheLabel)
{
  const auto names = this->WriteText("names.txt", "2 gray matter\n5 core\n");
  for (const std::string & text : { std::string("# S/m\n2 0.33\n5: 1.79  # CSF\n77 1\n"),
                                    std::string("gray matter = 0.33\n\"core\"\t1.79\n"),
                                    std::string("{\"gray matter\": 0.33, \"5\": 1.79}") })
  {
    EXPECT_EQ(this->Mesh({ "--names", names, "--conductivity", this->WriteText("sigma", text) }).error, "");
    const auto labels = this->Values("label");
    const auto values = this->Values("conductivity");
    ASSERT_EQ(values.size(), labels.size());
    for (std::size_t n = 0; n < values.size(); ++n)
    {
      ASSERT_EQ(values[n], labels[n] == 5.0 ? 1.79 : 0.33);
    }
  }
}

TEST_F(CommandLineCellData, ConductivityOfAirIsThatOfTheExteriorsLabel)
{
  this->Mesh({ "--fill-exterior", "--conductivity", this->WriteText("sigma", "0 1e-15\n2 0.33\n5 1\n") });
  const auto values = this->Values("conductivity");
  EXPECT_EQ(*std::min_element(values.begin(), values.end()), 1e-15);
}

TEST_F(CommandLineCellData, ConductivitiesThatCannotBeAreRefused)
{
  const auto expect = [&](const std::string & text, const std::string & message) {
    this->ExpectError({ this->WriteBalls(), this->Path("out.vtu"), "--conductivity", this->WriteText("sigma", text) },
                      1,
                      this->Path("sigma") + ": " + message);
  };
  expect("2 0.33\n", "there is no conductivity of label 5");
  expect("2 0.33\n5 -1\n", "line 2 has a conductivity of -1 S/m; it has to be above 0");
  expect("2 0\n", "line 1 has a conductivity of 0 S/m");
  expect("2 nan\n", "line 1 is not LABEL S/M or NAME S/M");
  expect("\n0.33\n", "line 2 is not LABEL S/M or NAME S/M");
  expect("2 0.33\n2 0.4\n", "line 2 gives label 2 another conductivity");
  expect("{\"2\": \"x\"}", "'2' is not followed by a number");
  expect("{\"2\": 1", "this is not JSON");
  this->ExpectError({ this->WriteBalls(), this->Path("out.vtu"), "--conductivity", this->Path("none") }, 1, "none: ");
}

TEST_F(CommandLineCellData, NamesThatNoLabelHasAreTold)
{
  const auto sigma = this->WriteText("sigma", "2 0.33\n5 1\ncsf 1.79\n");
  EXPECT_EQ(this->Mesh({ "--conductivity", sigma }).error,
            "multimaterial-mesh: warning: " + sigma +
              ": line 3 is of no label, as none is called 'csf'; --names FILE has names\n");
}

TEST_F(CommandLineCellData, ImagesAreSampledWhereTheMeshIs)
{
  const auto ramp = this->WriteRamp("ramp.nrrd");
  EXPECT_EQ(this
              ->Mesh({ "--cell-data",
                       "x=" + ramp,
                       "--cell-data",
                       "center=" + ramp + ":linear",
                       "--cell-data",
                       "voxel=" + ramp + ":nearest",
                       "--report",
                       this->Path("report.json") })
              .error,
            "");
  const auto mesh = this->Read("x");
  const auto means = this->Values("x");
  const auto centers = this->Values("center");
  const auto voxels = this->Values("voxel");
  for (std::size_t n = 0; n < means.size(); ++n)
  {
    double       x = 0.0;
    auto * const cell = mesh->GetCells()->ElementAt(n);
    for (auto point = cell->PointIdsBegin(); point != cell->PointIdsEnd(); ++point)
    {
      x += 0.25 * mesh->GetPoints()->ElementAt(*point)[0];
    }
    ASSERT_NEAR(means[n], 1.0 + x, 1e-4);
    ASSERT_NEAR(centers[n], 1.0 + x, 1e-4);
    ASSERT_NEAR(voxels[n], 1.0 + x, 0.25 + 1e-4);
  }
  const auto data = nlohmann::json::parse(this->Contents("report.json"))["cell_data"];
  ASSERT_EQ(data.size(), 3u);
  EXPECT_EQ(data[1]["name"], "center");
  EXPECT_EQ(data[1]["file"], ramp);
  EXPECT_EQ(data[1]["mode"], "linear");
  EXPECT_EQ(data[1]["tetrahedra_outside"], 0);
  EXPECT_NEAR(data[1]["minimum"].get<double>(), *std::min_element(centers.begin(), centers.end()), 1e-9);
}

TEST_F(CommandLineCellData, OutsideOfAnImageIsTold)
{
  const auto ramp = this->WriteRamp("ramp.nrrd", 7.5);
  const auto result = this->Mesh({ "--cell-data", "x=" + ramp });
  const auto values = this->Values("x");
  const auto outside = std::count_if(values.begin(), values.end(), [](double value) { return std::isnan(value); });
  EXPECT_GT(outside, 0);
  EXPECT_LT(outside, std::ptrdiff_t(values.size()));
  ASSERT_EQ(result.ErrorLines().size(), 2u) << result.error;
  EXPECT_EQ(result.ErrorLines()[0],
            "multimaterial-mesh: warning: " + ramp + ": " + std::to_string(outside) + " of " +
              std::to_string(values.size()) + " tetrahedra are outside of the image; their x is NaN");
  EXPECT_NE(result.ErrorLines()[1].find("are partly outside of the image"), std::string::npos);
}

TEST_F(CommandLineCellData, TensorsThatAreNotPositiveAreTold)
{
  using TensorImage = itk::Image<itk::SymmetricSecondRankTensor<float, 3>, 3>;
  const auto image = TensorImage::New();
  image->SetRegions(itk::Size<3>{ { 16, 16, 16 } });
  image->Allocate();
  TensorImage::PixelType tensor;
  for (unsigned int c = 0; c < 6; ++c)
  {
    // 1 2 3, 2 4 5, 3 5 6 has a negative determinant
    tensor[c] = static_cast<float>(c + 1);
  }
  image->FillBuffer(tensor);
  const auto file = this->WriteImage<TensorImage>(image, "tensors.nrrd");
  const auto result = this->Mesh({ "--cell-data", "sigma=" + file });
  const auto count = std::to_string(this->Values("label").size());
  ASSERT_EQ(result.ErrorLines().size(), 1u) << result.error;
  EXPECT_EQ(result.error.rfind("multimaterial-mesh: warning: " + file + ": the tensor is not positive definite in " +
                                 count + " of " + count + " tetrahedra (the first one at ",
                               0),
            0u)
    << result.error;
  EXPECT_NE(this->Contents("out.vtu").find("Name=\"sigma\" NumberOfComponents=\"9\""), std::string::npos);
}

TEST_F(CommandLineCellData, WhatCannotBeUnderstoodIsRefused)
{
  const auto labels = this->WriteBalls();
  const auto expect = [&](const std::string & output, std::vector<std::string> options, const std::string & message) {
    options.insert(options.begin(), { labels, this->Path(output) });
    this->ExpectError(options, 2, message);
  };
  expect("out.vtu", { "--cell-data", "x" }, "--cell-data is 'x'; it has to be NAME=IMAGE");
  expect("out.vtu", { "--cell-data", "=x.nrrd" }, "--cell-data is '=x.nrrd'");
  expect("out.vtu", { "--cell-data", "label=x.nrrd" }, "'label' is the name of the labels");
  expect("out.vtu", { "--cell-data", "x=a.nrrd", "--cell-data", "x=b.nrrd" }, "two cell data of the name 'x'");
  expect("out.mesh", { "--cell-data", "x=a.nrrd" }, "--cell-data is for .vtu and .msh");
  expect("out.mesh", { "--conductivity", "a" }, "--conductivity is for .vtu and .msh");
  expect("out.vtu", { "--surface-only", "--conductivity", "a" }, "--surface-only leaves out");
  this->ExpectError({ labels, this->Path("out.vtu"), "--cell-data", "x=" + this->Path("none.nrrd:mean") },
                    1,
                    this->Path("none.nrrd") + ": there is no such file");
}
