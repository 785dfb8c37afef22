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
// Images of indicators or probabilities in place of a label image.
#include "CommandLineTest.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <functional>
#include <limits>

namespace
{
using FloatImage = itk::Image<float, 3>;

class CommandLineIndicators : public CommandLine
{
public:
  /** An image of 16 x 16 x 16 voxels of a function of the distance to its centre. */
  std::string
  WriteMap(const std::string & name, const std::function<double(double)> & function, itk::SizeValueType size = 16) const
  {
    const auto image = MakeImage<float, 3>(itk::Size<3>{ { size, 16, 16 } });
    float *    value = image->GetBufferPointer();
    for (int k = 0; k < 16; ++k)
    {
      for (int j = 0; j < 16; ++j)
      {
        for (int i = 0; i < int(size); ++i)
        {
          *value++ = float(function(std::hypot(i - 7.5, j - 7.5, k - 7.5)));
        }
      }
    }
    return this->WriteImage(image.GetPointer(), name);
  }

  /** The probability of being in a ball. */
  static double
  Ball(double radius, double distance)
  {
    return 1.0 / (1.0 + std::exp(2.0 * (distance - radius)));
  }

  std::string
  WriteCore() const
  {
    return this->WriteMap("core.nrrd", [](double d) { return Ball(3.0, d); });
  }
  std::string
  WriteShell() const
  {
    return this->WriteMap("shell.nrrd", [](double d) { return Ball(6.0, d) - Ball(3.0, d); });
  }
  std::string
  WriteOutside() const
  {
    return this->WriteMap("outside.nrrd", [](double d) { return 1.0 - Ball(6.0, d); });
  }

  /** Volumes by label. */
  std::map<int, double>
  Mesh(std::vector<std::string> arguments) const
  {
    arguments.insert(arguments.end(), { "--report", this->Path("report.json"), "--quiet" });
    const auto result = Run(arguments);
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.error, "");
    std::map<int, double> volumes;
    const auto            report = nlohmann::json::parse(this->Contents("report.json"));
    for (const auto & label : report["quality"]["labels"])
    {
      volumes[label["label"]] = label["volume_mm3"];
    }
    return volumes;
  }
};

constexpr double SmallBall = 113.1;
constexpr double LargeBall = 904.8;
} // namespace

TEST_F(CommandLineIndicators, GetTheLabelsOneTwoThreeAndTheRestIsExterior)
{
  const auto volumes = this->Mesh({ "--indicators", this->WriteCore(), this->WriteShell(), this->Path("out.vtu") });
  ASSERT_EQ(volumes.size(), 2u);
  EXPECT_NEAR(volumes.at(1) / SmallBall, 1.0, 0.05);
  EXPECT_NEAR((volumes.at(1) + volumes.at(2)) / LargeBall, 1.0, 0.05);
}

TEST_F(CommandLineIndicators, MasksAreMeshedWithAWarning)
{
  const auto mask = this->WriteMap("mask.nrrd", [](double d) { return d < 6.0 ? 1.0 : 0.0; });
  const auto result = Run({ "--indicators", mask, this->Path("out.vtu"), "--quiet" });
  EXPECT_EQ(result.exitCode, 0);
  ASSERT_EQ(result.ErrorLines().size(), 1u) << result.error;
  EXPECT_NE(result.error.find("mask.nrrd: the image has two values only"), std::string::npos) << result.error;
}

TEST_F(CommandLineIndicators, HaveLabelsOfTheirOwn)
{
  const auto volumes = this->Mesh({ "--indicators",
                                    this->WriteOutside(),
                                    this->WriteCore(),
                                    this->WriteShell(),
                                    "--indicator-labels",
                                    "0,7,-4",
                                    this->Path("out.vtu") });
  EXPECT_EQ(volumes.size(), 2u);
  EXPECT_NEAR(volumes.at(7) / SmallBall, 1.0, 0.05);
  EXPECT_TRUE(volumes.count(-4));
}

TEST_F(CommandLineIndicators, OutputMayComeBeforeBetweenAndAfterThem)
{
  const auto core = this->WriteCore();
  const auto shell = this->WriteShell();
  this->Mesh({ "--indicators", core, shell, this->Path("after.vtu") });
  this->Mesh({ this->Path("before.vtu"), "--indicators", core, shell });
  this->Mesh({ "--indicators", core, shell, "--seed", "1", this->Path("between.vtu") });
  EXPECT_TRUE(this->Contents("before.vtu") == this->Contents("after.vtu"));
  EXPECT_TRUE(this->Contents("between.vtu") == this->Contents("after.vtu"));
}

TEST_F(CommandLineIndicators, AreInTheReport)
{
  const auto core = this->WriteCore();
  this->Mesh({ "--indicators", core, this->Path("out.vtu") });
  const auto input = nlohmann::json::parse(this->Contents("report.json"))["input"];
  EXPECT_EQ(input["indicators"], nlohmann::json::array({ core }));
  EXPECT_FALSE(input.contains("file"));
}

TEST_F(CommandLineIndicators, ThatAreLargestNowhereAreToldOf)
{
  const auto faint = this->WriteMap("faint.nrrd", [](double d) { return 0.1 * Ball(3.0, d); });
  const auto result = Run({ "--indicators", this->WriteShell(), faint, this->Path("out.vtu"), "--quiet" });
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.error,
            "multimaterial-mesh: warning: " + faint +
              ": the image is the largest nowhere, so label 2 is not in the mesh\n");
}

TEST_F(CommandLineIndicators, AreNotThereTogetherWithLabels)
{
  this->ExpectError({ this->WriteBalls(), this->Path("out.vtu"), "--indicators", this->WriteCore() },
                    2,
                    "there are LABELS, " + this->Path("labels.nrrd") + ", and --indicators; give one of the two");
}

TEST_F(CommandLineIndicators, NeedAnOutput)
{
  this->ExpectError({ "--indicators", this->Path("out.vtu") }, 2, "An image after --indicators is required");
  this->ExpectError({ "--indicators", this->WriteCore(), this->WriteShell() }, 2, "meshes are written as .vtu");
}

TEST_F(CommandLineIndicators, AreNotTheOptionThatFollows)
{
  this->ExpectError({ "--indicators", "--seed", "1", this->Path("out.vtu") },
                    2,
                    "--indicators is '--seed', which looks like an option; a file of that name is ./--seed");
}

TEST_F(CommandLineIndicators, AreNotSmoothed)
{
  this->ExpectError(
    { "--indicators", this->WriteCore(), this->Path("out.vtu"), "--radius", "1" }, 2, "--radius is for LABELS");
}

TEST_F(CommandLineIndicators, NeedALabelEach)
{
  this->ExpectError({ "--indicators", this->WriteCore(), this->Path("out.vtu"), "--indicator-labels", "1,2" },
                    2,
                    "--indicator-labels has 2 labels for 1 indicators");
  this->ExpectError(
    { this->WriteBalls(), this->Path("out.vtu"), "--indicator-labels", "1" }, 2, "--indicator-labels is for");
}

TEST_F(CommandLineIndicators, AreOnOneGrid)
{
  const auto wide = this->WriteMap("wide.nrrd", [](double d) { return Ball(3.0, d); }, 18);
  this->ExpectError({ "--indicators", this->WriteCore(), wide, this->Path("out.vtu") },
                    1,
                    "Indicator image 2 (" + wide + ") has [18, 16, 16] voxels and the first one [16, 16, 16]");
}

TEST_F(CommandLineIndicators, AreNumbersThatDiffer)
{
  const auto zero = this->WriteMap("zero.nrrd", [](double) { return 0.0; });
  this->ExpectError(
    { "--indicators", this->WriteCore(), zero, this->Path("out.vtu") }, 1, "(" + zero + ") has the value 0 everywhere");
  const auto hole = this->WriteMap(
    "hole.nrrd", [](double d) { return d < 2.0 ? std::numeric_limits<double>::quiet_NaN() : Ball(5.0, d); });
  this->ExpectError({ "--indicators", hole, this->Path("out.vtu") }, 1, "(" + hole + ") has the value nan");
}

TEST_F(CommandLineIndicators, AreProbabilitiesOrSigned)
{
  const auto percent = this->WriteMap("percent.nrrd", [](double d) { return 100.0 * Ball(5.0, d); });
  this->ExpectError({ "--indicators", percent, this->Path("out.vtu") }, 1, "have to be probabilities from 0 to 1");
}
