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
// Elements of second order.
#include "CommandLineTest.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace
{
class CommandLineOrder : public CommandLine
{
public:
  RunResult
  RunOnBalls(std::vector<std::string> options) const
  {
    options.insert(options.begin(), this->WriteBalls());
    return Run(options);
  }
};
} // namespace

TEST_F(CommandLineOrder, TellsHowEdgesAreCurved)
{
  const auto result =
    this->RunOnBalls({ this->Path("out.vtu"), "--order", "2", "--report", this->Path("report.json") });
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_NE(result.output.find("edges on interfaces are curved"), std::string::npos);
  const auto report = nlohmann::json::parse(this->Contents("report.json"));
  EXPECT_EQ(report["parameters"]["order"], 2);
  const auto & section = report["second_order"];
  EXPECT_GT(section["edges_on_interfaces"], 100);
  EXPECT_GT(section["smallest_relative_jacobian"], 0.0);
  // curved tetrahedra fill what the voxels fill; those of the report's quality are straight
  for (std::size_t n = 0; n < 2; ++n)
  {
    EXPECT_EQ(section["labels"][n]["label"], report["quality"]["labels"][n]["label"]);
    const double voxels = report["input"]["labels"][n + 1]["voxels"];
    EXPECT_NEAR(section["labels"][n]["volume_mm3"], voxels, 0.02 * voxels);
  }
}

TEST_F(CommandLineOrder, OfFirstOrderTellsNothing)
{
  this->RunOnBalls({ this->Path("out.vtu"), "--report", this->Path("report.json") });
  EXPECT_TRUE(nlohmann::json::parse(this->Contents("report.json"))["second_order"].is_null());
}

TEST_F(CommandLineOrder, WritesTenNodesAndSix)
{
  const auto result = this->RunOnBalls(
    { this->Path("out.msh"), "--order", "2", "--msh-format", "2.2-ascii", "--surface", this->Path("s.msh") });
  EXPECT_EQ(result.exitCode, 0);
  // element, type, number of tags
  EXPECT_NE(this->Contents("out.msh").find(" 11 2 2 2 "), std::string::npos);
  EXPECT_NE(this->Contents("out.msh").find(" 9 2 1001 1001 "), std::string::npos);
  EXPECT_EQ(this->Contents("out.msh").find(" 4 2 2 2 "), std::string::npos);
  EXPECT_NE(this->Contents("s.msh").find(" 9 2 1001 1001 "), std::string::npos);
}

TEST_F(CommandLineOrder, TellsOnceOfFilesWithFlatTriangles)
{
  const auto result = this->RunOnBalls({ this->Path("out.vtu"),
                                         "--order",
                                         "2",
                                         "--surface",
                                         this->Path("flat.stl"),
                                         "--hull",
                                         this->Path("hull.vtu") + "=2,5" });
  EXPECT_EQ(result.exitCode, 0);
  const auto warnings = result.ErrorLines();
  EXPECT_EQ(std::count_if(warnings.begin(),
                          warnings.end(),
                          [&](const std::string & line) {
                            return line.find("flat.stl, " + this->Path("hull.vtu") + " are flat") != std::string::npos;
                          }),
            1)
    << result.error;
}

TEST_F(CommandLineOrder, FilesThatCannotHaveItAreRefused)
{
  const std::string balls = this->WriteBalls();
  this->ExpectError({ balls, this->Path("out.mesh"), "--order", "2" }, 2, "--order 2 is for .vtu and .msh files");
  this->ExpectError({ balls, this->Path("out.msh"), "--order", "2", "--msh-format", "simnibs" },
                    2,
                    "SimNIBS has elements of first order");
  this->ExpectError({ balls, this->Path("out.vtu"), "--order", "3" }, 2, "--order is '3'");
}

TEST_F(CommandLineOrder, TheOptimizerRefusesItsFiles)
{
  this->RunOnBalls({ this->Path("out.vtu"), "--order", "2" });
  const auto result = Start({ OPTIMIZE_TETRAHEDRAL_MESH, this->Path("out.vtu"), this->Path("better.vtu") });
  EXPECT_NE(result.exitCode, 0);
  EXPECT_NE(result.error.find("quadratic tetrahedron"), std::string::npos) << result.error;
}
