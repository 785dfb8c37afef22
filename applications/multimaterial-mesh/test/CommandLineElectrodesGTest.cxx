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
// Electrodes from a file: their names in the output, their contacts in the report, and what is wrong with them.
#include "CommandLineTest.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

namespace
{
class CommandLineElectrodes : public CommandLine
{
public:
  /** The ball of MakeBalls() has its middle at 7.5. */
  std::string
  Write(const std::string & electrodes) const
  {
    std::ofstream(this->Path("cap.json")) << R"({"space": "LPS", "electrodes": [)" << electrodes << "]}";
    return this->Path("cap.json");
  }

  static std::string
  Disc(const std::string & name, const std::string & position, const std::string & label, double radius = 3.0)
  {
    return R"({"name": ")" + name + R"(", "label": )" + label + R"(, "shape": "disc", "thickness": 2, "radius": )" +
           std::to_string(radius) + R"(, "position": )" + position + '}';
  }
};

const char * const Top = "[7.5, 7.5, 15]";
} // namespace

TEST_F(CommandLineElectrodes, HaveNamesAndContacts)
{
  const auto cap = this->Write(Disc("Cz", Top, "101") + ", " + Disc("T7", "[15, 7.5, 7.5]", "102"));
  const auto result = Run({ this->WriteBalls(),
                            this->Path("out.msh"),
                            "--electrodes",
                            cap,
                            "--report",
                            this->Path("report.json"),
                            "--quiet" });
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.error, "");
  EXPECT_NE(this->Contents("out.msh").find("\"Cz\""), std::string::npos);
  const auto report = nlohmann::json::parse(this->Contents("report.json"));
  ASSERT_EQ(report["electrodes"].size(), 2u);
  const auto & cz = report["electrodes"][0];
  EXPECT_EQ(cz["name"], "Cz");
  EXPECT_NEAR(cz["contact_area_mm2"].get<double>() / cz["expected_area_mm2"].get<double>(), 1.0, 0.04);
  EXPECT_LT(cz["projection_mm"], 3.0);
  EXPECT_TRUE(cz["gel_contact_area_mm2"].is_null());
  EXPECT_EQ(report["label_names"]["labels"].size(), 2u);
  for (const auto & label : report["input"]["labels"])
  {
    EXPECT_GT(label["voxels"], 0) << label;
  }
}

TEST_F(CommandLineElectrodes, ThatOverlapAreWarnedOf)
{
  const auto cap = this->Write(Disc("first", Top, "101") + ", " + Disc("second", "[9.5, 7.5, 15]", "102"));
  const auto result = Run({ this->WriteBalls(), this->Path("out.vtu"), "--electrodes", cap, "--quiet" });
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_NE(result.error.find(cap + ": electrodes[1]: 'second' overlaps 'first', which is before it and gives way"),
            std::string::npos)
    << result.error;
}

TEST_F(CommandLineElectrodes, ErrorsAreALineWithTheirPlace)
{
  const auto expect = [this](const std::string & electrodes, const std::string & words) {
    const auto result =
      Run({ this->WriteBalls(), this->Path("out.vtu"), "--electrodes", this->Write(electrodes), "--quiet" });
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_NE(result.error.find("cap.json: " + words), std::string::npos) << result.error;
    EXPECT_EQ(std::count(result.error.begin(), result.error.end(), '\n'), 1) << result.error;
  };
  expect(Disc("a", Top, "101", -1.0), "electrodes[0].radius: -1 mm is not positive");
  expect(Disc("a", Top, "5"), "electrodes[0].label: the image has the label 5 already; choose another one");
  expect(Disc("a", "[7.5, 7.5, 60]", "101"), "electrodes[0].position: the skin is ");
  expect(Disc("a", Top, "101") + ", {}", "electrodes[1].shape: it is missing");
  this->ExpectError(
    { "--indicators", "a.nrrd", "out.vtu", "--electrodes", "cap.json" }, 2, "--electrodes are for LABELS");
}
