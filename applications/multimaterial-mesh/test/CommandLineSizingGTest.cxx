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
// Sizes, limits and air from the command line.
#include "CommandLineTest.h"

#include "itkImageRegionIteratorWithIndex.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>

namespace
{
using FloatImage = itk::Image<float, 3>;

class CommandLineSizing : public CommandLine
{
public:
  void
  ExpectFailure(std::vector<std::string> options, int exitCode, const std::string & message) const
  {
    options.insert(options.begin(), { this->WriteBalls(), this->Path("out.vtu") });
    options.emplace_back("--quiet");
    this->ExpectError(options, exitCode, message);
  }

  /** The report of a run with these options. */
  nlohmann::json
  Report(std::vector<std::string> options) const
  {
    options.insert(options.begin(),
                   { this->WriteBalls(), this->Path("out.vtu"), "--report", this->Path("report.json"), "--quiet" });
    const auto result = Run(options);
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_EQ(result.error, "");
    return nlohmann::json::parse(this->Contents("report.json"));
  }

  std::size_t
  CountTetrahedra(const std::vector<std::string> & options = {}) const
  {
    return this->Report(options)["counts"]["tetrahedra"];
  }

  /** A mask that is 1 in the slices k < 8 of MakeBalls(). */
  std::string
  WriteMask() const
  {
    const auto image = MakeImage<short>(itk::Size<3>{ { 16, 16, 16 } });
    std::fill_n(image->GetBufferPointer(), 16 * 16 * 8, short(1));
    return this->WriteImage<LabelImage>(image, "mask.nrrd");
  }

  std::string
  WriteSizes(float size) const
  {
    const auto image = MakeImage<float>(itk::Size<3>{ { 16, 16, 16 } });
    image->FillBuffer(size);
    return this->WriteImage<FloatImage>(image, "size.nrrd");
  }
};
} // namespace

TEST_F(CommandLineSizing, OptionsReachTheMesh)
{
  const auto standard = this->CountTetrahedra();
  EXPECT_GT(this->CountTetrahedra({ "--label-size", "5:max=0.7" }), standard);
  EXPECT_GT(this->CountTetrahedra({ "--roi", this->WriteMask(), "--roi-max-size", "0.7" }), standard);
  const auto sizes = this->WriteSizes(3.0f);
  EXPECT_EQ(this->CountTetrahedra({ "--sizing-image", sizes }), standard);
  EXPECT_LT(this->CountTetrahedra({ "--sizing-image", sizes, "--sizing-mode", "replace" }), standard);
}

TEST_F(CommandLineSizing, ErrorsOfASolutionReachTheMesh)
{
  const auto standard = this->CountTetrahedra({ "--cell-data", "error=" + this->WriteSizes(1.0f) });
  std::filesystem::copy_file(this->Path("out.vtu"), this->Path("errors.vtu"));
  const auto twice = this->CountTetrahedra({ "--refine-by", this->Path("errors.vtu") });
  EXPECT_NEAR(double(twice) / double(standard), 2.0, 0.6);
  EXPECT_GT(this->CountTetrahedra({ "--refine-by", this->Path("errors.vtu"), "--refine-factor", "4" }), twice);
}

TEST_F(CommandLineSizing, ErrorsThatAreNoneAreRefused)
{
  this->CountTetrahedra();
  const std::string without = this->Path("out.vtu");
  std::filesystem::copy_file(without, this->Path("plain.vtu"));
  this->ExpectFailure({ "--refine-by", this->Path("plain.vtu") }, 1, "has no cell data array 'error'");
  this->ExpectFailure({ "--refine-by", this->Path("no.vtu") }, 1, "no.vtu");
  this->ExpectFailure({ "--refine-factor", "2" }, 2, "--refine-factor needs --refine-by");
  this->ExpectFailure({ "--refine-by", without, "--refine-factor", "1" }, 2, "--refine-factor");
  this->ExpectFailure(
    { "--refine-by", without, "--sizing-image", this->WriteSizes(3.0f) }, 2, "leave out --sizing-image");
}

TEST_F(CommandLineSizing, ReportHasParametersAndExpectation)
{
  const auto report = this->Report({ "--label-size", "5:factor=0.5:max=2", "--max-volume", "3", "--air-margin", "1" });
  EXPECT_EQ(report["parameters"]["label_size"], "5:factor=0.5:max=2");
  EXPECT_EQ(report["parameters"]["sizing_mode"], "minimum");
  EXPECT_EQ(report["parameters"]["fill_exterior"], true);
  EXPECT_EQ(report["parameters"]["air_margin_mm"], 1.0);
  EXPECT_EQ(report["parameters"]["max_tetrahedra"], nullptr);
  EXPECT_LE(report["quality"]["overall"]["largest_volume_mm3"].get<double>(), 3.0);
  const double tetrahedra = report["counts"]["tetrahedra"];
  EXPECT_NEAR(report["expected"]["tetrahedra"].get<double>(), tetrahedra, 0.5 * tetrahedra);
  EXPECT_GT(report["expected"]["memory_gb"].get<double>(), 0.0);
}

TEST_F(CommandLineSizing, ExpectationIsPrintedBeforeTheLongStages)
{
  const auto result = Run({ this->WriteBalls(), this->Path("out.vtu") });
  EXPECT_EQ(result.exitCode, 0);
  const auto expectation = result.output.find("\nexpect about ");
  ASSERT_NE(expectation, std::string::npos) << result.output;
  EXPECT_LT(result.output.find("\nsizing ..."), expectation);
  EXPECT_LT(expectation, result.output.find("\nsurface ..."));
}

TEST_F(CommandLineSizing, ExpectationAloneIsPrintedWithoutAMesh)
{
  const auto result = Run({ this->WriteBalls(), this->Path("none.vtu"), "--expect", "--max-tetrahedra", "1" });
  EXPECT_EQ(result.exitCode, 0) << result.error;
  EXPECT_EQ(result.output.find("expect about "), 0u) << result.output;
  EXPECT_EQ(result.output.find('\n'), result.output.size() - 1);
  EXPECT_FALSE(std::filesystem::exists(this->Path("none.vtu")));
}

TEST_F(CommandLineSizing, MeshesBeyondALimitAreRefused)
{
  this->ExpectFailure({ "--max-tetrahedra", "100" }, 1, "more than the limit of 100 tetrahedra");
  this->ExpectFailure({ "--max-memory", "0.001" }, 1, "more than the limit of 0.001 GB");
  this->ExpectFailure({ "--max-tetrahedra", "0" }, 2, "--max-tetrahedra is '0'");
  this->ExpectFailure({ "--max-memory", "0" }, 2, "--max-memory is '0'; it has to be a number above 0 (GB)");
}

TEST_F(CommandLineSizing, ExteriorIsFilled)
{
  const auto report = this->Report({ "--fill-exterior" });
  EXPECT_NEAR(report["quality"]["overall"]["volume_mm3"].get<double>(), 4096.0, 1e-6);
  EXPECT_EQ(report["quality"]["labels"].size(), 3u);
}

TEST_F(CommandLineSizing, BorderInTheReportIsThatOfTheMeshedBox)
{
  // noise in thick slices, of which some tetrahedra are poor, far from the border of the image
  const auto   image = MakeImage<short>(itk::Size<3>{ { 16, 16, 16 } });
  const double spacing[] = { 1.0, 1.0, 6.0 };
  image->SetSpacing(spacing);
  std::mt19937 random(1);
  for (itk::ImageRegionIteratorWithIndex<LabelImage> it(image, image->GetBufferedRegion()); !it.IsAtEnd(); ++it)
  {
    const auto & index = it.GetIndex();
    const bool   isInside = std::all_of(index.begin(), index.end(), [](auto i) { return i >= 4 && i < 12; });
    it.Set(isInside ? short(1 + random() % 4) : short(0));
  }
  const auto labels = this->WriteImage<LabelImage>(image, "noise.nrrd");
  for (const char * const margin : { "0", "3" })
  {
    const auto result = Run({ labels,
                              this->Path("out.vtu"),
                              "--air-margin",
                              margin,
                              "--min-island",
                              "0",
                              "--report",
                              this->Path("report.json"),
                              "--keep-slices",
                              "--quiet" });
    EXPECT_EQ(result.exitCode, 0) << result.error;
    const auto   report = nlohmann::json::parse(this->Contents("report.json"));
    const auto & worst = report["quality"]["worst_tetrahedra"];
    const auto   count = std::count_if(worst.begin(), worst.end(), [](const auto & tetrahedron) {
      return tetrahedron["on_image_border"].template get<bool>();
    });
    EXPECT_EQ(count > 0, std::string(margin) == "0") << worst.size();
  }
}

TEST_F(CommandLineSizing, MarginBeyondTheLimitOfMemoryIsRefused)
{
  this->ExpectFailure(
    { "--air-margin", "5000", "--max-memory", "8" }, 1, "With an air margin of 5000 mm, the image has");
}

TEST_F(CommandLineSizing, ExteriorThatIsNotThereCannotBeFilled)
{
  this->ExpectFailure({ "--exterior", "none", "--fill-exterior" }, 2, "leave out --exterior none");
  this->ExpectFailure({ "--exterior", "none", "--air-margin", "3" }, 2, "leave out --exterior none");
  this->ExpectFailure({ "--air-margin", "-3" }, 2, "--air-margin is '-3'; it has to be a number of at least 0 (mm)");
}

TEST_F(CommandLineSizing, SizesOfLabelsThatCannotBe)
{
  this->ExpectFailure(
    { "--label-size", "7:max=2" }, 1, "Sizes are given for 7, which is no label here. The labels are 0, 2, 5");
  this->ExpectFailure(
    { "--label-size", "bone:max=2" }, 2, "--label-size is 'bone:max=2'; The sizes of labels have 'bone'");
  this->ExpectFailure(
    { "--label-size", "5:min=3:max=2" }, 2, "--label-size is '5:min=3:max=2'; The smallest size in label 5");
  this->ExpectFailure({ "--label-size", "5:factor=-1" }, 2, "The factor of label 5 is -1");
}

TEST_F(CommandLineSizing, RegionsThatCannotBe)
{
  this->ExpectFailure({ "--roi-max-size", "2" }, 2, "--roi needs --roi-min-size or --roi-max-size");
  const auto mask = this->WriteMask();
  const auto run = [&](std::vector<std::string> options, const std::string & message, int exitCode) {
    options.insert(options.begin(), { this->WriteBalls(), this->Path("out.vtu") });
    const auto result = Run(options);
    EXPECT_EQ(result.exitCode, exitCode);
    EXPECT_NE(result.error.find(message), std::string::npos) << result.error;
  };
  run({ "--roi", mask }, "--roi needs --roi-min-size or --roi-max-size", 2);
  run({ "--roi", mask, "--roi-min-size", "3", "--roi-max-size", "2" }, "--roi-min-size is 3 mm, but --roi-max-size", 2);
  run({ "--roi", this->Path("none.nrrd"), "--roi-max-size", "2" }, "there is no such file", 1);
  const auto empty = this->WriteImage<LabelImage>(MakeImage<short>(itk::Size<3>{ { 16, 16, 16 } }), "empty.nrrd");
  run({ "--roi", empty, "--roi-max-size", "2" }, "No voxel of the region of interest is in what is meshed", 1);
  const auto small = MakeImage<short>(itk::Size<3>{ { 16, 16, 8 } });
  run({ "--roi", this->WriteImage<LabelImage>(small, "small.nrrd"), "--roi-max-size", "2" },
      "They must be on the same grid",
      1);
}

TEST_F(CommandLineSizing, SizingImagesThatCannotBe)
{
  this->ExpectFailure({ "--sizing-mode", "replace" }, 2, "--sizing-mode replace needs --sizing-image");
  this->ExpectFailure({ "--sizing-mode", "maximum" }, 2, "it has to be one of minimum, replace");
  const auto result = Run({ this->WriteBalls(),
                            this->Path("out.vtu"),
                            "--sizing-image",
                            this->WriteSizes(std::numeric_limits<float>::quiet_NaN()) });
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_NE(result.error.find("The sizing image has the value nan at [0, 0, 0]"), std::string::npos) << result.error;
}

TEST_F(CommandLineSizing, VolumeGoesOverTheAutomaticSmallestSize)
{
  const auto report = this->Report({ "--max-volume", "0.3" });
  EXPECT_LE(report["quality"]["overall"]["largest_volume_mm3"].get<double>(), 0.3);
}

TEST_F(CommandLineSizing, VolumeBelowTheSmallestSize)
{
  this->ExpectFailure({ "--max-volume", "0" }, 2, "--max-volume is '0'; it has to be a number above 0 (mm^3)");
  this->ExpectFailure({ "--max-volume", "0.1", "--min-size", "2" }, 1, "which is below the smallest size, 2 mm");
}
