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
// Surfaces from files, alone and on top of a label image.
#include "CommandLineTest.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <map>

namespace
{
class CommandLineSurfaces : public CommandLine
{
public:
  /** An octahedron, divided, around a place; its upper half is left out on request. */
  std::string
  WriteSphere(const std::string & name, double x, double radius, bool isWhole = true) const
  {
    constexpr int steps = 24;
    std::ofstream file(this->Path(name));
    const auto    vertex = [&](int i, int j) {
      const double pi = std::acos(-1.0);
      const double polar = pi * i / steps;
      const double azimuth = pi * j / steps;
      file << "   vertex " << x + radius * std::sin(polar) * std::cos(azimuth) << ' '
           << 7.5 + radius * std::sin(polar) * std::sin(azimuth) << ' ' << 7.5 + radius * std::cos(polar) << '\n';
    };
    const auto triangle = [&](int i0, int j0, int i1, int j1, int i2, int j2) {
      file << " facet normal 0 0 0\n  outer loop\n";
      // the seam and the poles are to be the same to the last digit
      vertex(i0, i0 % steps == 0 ? 0 : j0 % (2 * steps));
      vertex(i1, i1 % steps == 0 ? 0 : j1 % (2 * steps));
      vertex(i2, i2 % steps == 0 ? 0 : j2 % (2 * steps));
      file << "  endloop\n endfacet\n";
    };
    file << "solid sphere\n";
    for (int i = isWhole ? 0 : steps / 2; i < steps; ++i)
    {
      for (int j = 0; j < 2 * steps; ++j)
      {
        if (i > 0)
        {
          triangle(i, j, i + 1, j, i, j + 1);
        }
        if (i < steps - 1)
        {
          triangle(i, j + 1, i + 1, j, i + 1, j + 1);
        }
      }
    }
    file << "endsolid sphere\n";
    return this->Path(name);
  }

  std::map<int, double>
  Volumes() const
  {
    std::map<int, double> volumes;
    const auto            report = nlohmann::json::parse(this->Contents("report.json"));
    for (const auto & label : report["quality"]["labels"])
    {
      volumes[label["label"]] = label["volume_mm3"];
    }
    return volumes;
  }
};

constexpr double Ball = 4.18879;
} // namespace

TEST_F(CommandLineSurfaces, AreMeshedAloneWhereLaterOnesWin)
{
  const auto result = Run({ "--surface-label",
                            "1=" + this->WriteSphere("a.stl", 7.5, 5.0),
                            "--surface-label",
                            "2=" + this->WriteSphere("b.stl", 11.0, 4.0),
                            this->Path("out.vtu"),
                            "--report",
                            this->Path("report.json"),
                            "--surface-spacing",
                            "1",
                            "--quiet" });
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.error, "");
  auto volumes = this->Volumes();
  ASSERT_EQ(volumes.size(), 2u);
  EXPECT_NEAR(volumes[2] / (Ball * 64.0), 1.0, 0.05);
  EXPECT_LT(volumes[1], 0.8 * Ball * 125.0);
  const auto report = nlohmann::json::parse(this->Contents("report.json"));
  EXPECT_EQ(report["input"]["surfaces"].size(), 2u);
}

TEST_F(CommandLineSurfaces, AreOnAGridThatIsStated)
{
  const auto file = this->WriteSphere("a.stl", 7.5, 5.0);
  const auto result = Run({ "--surface-label", "1=" + file, this->Path("out.vtu"), "--expect" });
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.error,
            "multimaterial-mesh: the surfaces are meshed on a grid of 110x110x110 voxels of 0.1 mm; "
            "--surface-spacing chooses another\n");
}

TEST_F(CommandLineSurfaces, GoOnTopOfTheLabels)
{
  // around all of the core, which has the label 5
  const auto file = this->WriteSphere("a.stl", 7.5, 3.6);
  const auto result = Run({ this->WriteBalls(),
                            this->Path("out.vtu"),
                            "--surface-label",
                            "9=" + file,
                            "--report",
                            this->Path("report.json"),
                            "--quiet" });
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.error,
            "multimaterial-mesh: warning: surfaces cover all voxels of label 5, which is not in the mesh\n");
  auto volumes = this->Volumes();
  ASSERT_EQ(volumes.size(), 2u);
  EXPECT_NEAR(volumes[9] / (Ball * std::pow(3.6, 3)), 1.0, 0.05);
}

TEST_F(CommandLineSurfaces, ThatAreOpenAreRefusedByName)
{
  const auto file = this->WriteSphere("half.stl", 7.5, 5.0, false);
  const auto result = Run({ "--surface-label", "1=" + file, this->Path("out.vtu"), "--surface-spacing", "1" });
  EXPECT_EQ(result.exitCode, 1);
  ASSERT_EQ(result.ErrorLines().size(), 1u) << result.error;
  EXPECT_NE(result.error.find(file + ": The surface is open and encloses nothing for sure: 48 edges"),
            std::string::npos)
    << result.error;
}

TEST_F(CommandLineSurfaces, ThatNoVoxelIsInAreRefusedByName)
{
  const auto file = this->WriteSphere("tiny.stl", 7.1, 0.2);
  const auto result = Run({ this->WriteBalls(), this->Path("out.vtu"), "--surface-label", "1=" + file });
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_NE(result.error.find(file + ": no voxel's centre is within the surface"), std::string::npos) << result.error;
}

TEST_F(CommandLineSurfaces, WarnWhereTheImageCutsThem)
{
  const auto file = this->WriteSphere("cut.stl", 13.0, 4.0);
  const auto result = Run({ this->WriteBalls(), this->Path("out.vtu"), "--surface-label", "1=" + file, "--quiet" });
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_NE(result.error.find(file + ": the surface is not as it should be; it goes beyond the image by 1.5 mm"),
            std::string::npos)
    << result.error;
}

TEST_F(CommandLineSurfaces, WrongUsageIsAnErrorOfUsage)
{
  this->ExpectError({ "--surface-label", "a.stl", "out.vtu" }, 2, "it has to be L=FILE, for instance 3=lh.pial");
  this->ExpectError({ "--surface-label", "1,2=a.stl", "out.vtu" }, 2, "it has to be L=FILE");
  this->ExpectError({ "--surface-label", "1=a.stl", "labels.nrrd", "out.vtu", "--surface-spacing", "1" },
                    2,
                    "--surface-spacing is for surfaces alone");
  this->ExpectError({ "labels.nrrd", "out.vtu", "--surface-ras" }, 2, "need --surface-label");
  this->ExpectError({ "--surface-label", "1=a.stl", "out.vtu", "--merge", "1=2" }, 2, "are for LABELS");
}
