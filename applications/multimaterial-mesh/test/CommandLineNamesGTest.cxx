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
// What labels are called, and where their names end up.
#include "CommandLineTest.h"

#include "itkGmshMeshIO.h"

#include <nlohmann/json.hpp>

#include <fstream>

namespace
{
/** MakeBalls() has 0 outside, 2 and, within it, 5. */
class CommandLineNames : public CommandLine
{
public:
  std::string
  WriteText(const std::string & name, const std::string & text) const
  {
    std::ofstream(this->Path(name)) << text;
    return this->Path(name);
  }

  std::string
  WriteTable() const
  {
    return this->WriteText("names.txt", "0 outside\n2 gray/white  matter 255 0 0 0\n5 core\n");
  }

  RunResult
  Mesh(const std::string & output, std::vector<std::string> options, const std::string & error = "") const
  {
    options.insert(options.begin(), { this->WriteBalls(), this->Path(output) });
    auto result = Run(options);
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_EQ(result.error, error.empty() ? "" : "multimaterial-mesh: warning: " + error + "\n");
    return result;
  }

  itk::GroupedMeshIOBase::GroupNamesType
  GroupsIn(const std::string & name) const
  {
    const auto io = itk::GmshMeshIO::New();
    io->SetFileName(this->Path(name));
    io->ReadMeshInformation();
    return io->GetGroupNames();
  }
};
} // namespace

TEST_F(CommandLineNames, ReachThePage)
{
  const std::string names = this->WriteText("names.txt", "2 mantle\n5 kernel<7>\n");
  this->Mesh("out.vtu", { "--names", names, "--report", this->Path("page.html") });
  const std::string page = this->Contents("page.html");
  EXPECT_NE(page.find("mantle"), std::string::npos);
  EXPECT_NE(page.find("kernel&lt;7&gt;"), std::string::npos);
}

TEST_F(CommandLineNames, ReachFilesSummaryAndReport)
{
  const auto result = this->Mesh("out.msh",
                                 { "--names",
                                   this->WriteTable(),
                                   "--surface-per-label",
                                   this->Path("part-.obj"),
                                   "--surface",
                                   this->Path("surface.vtu"),
                                   "--report",
                                   this->Path("report.json") });
  EXPECT_NE(result.output.find("label 2 (gray/white matter): "), std::string::npos) << result.output;
  EXPECT_NE(result.output.find("label 5 (core): "), std::string::npos) << result.output;
  const auto groups = this->GroupsIn("out.msh");
  EXPECT_EQ(groups.at({ 3, 2 }), "gray/white matter");
  EXPECT_EQ(groups.at({ 3, 5 }), "core");
  EXPECT_EQ(groups.at({ 2, 1001 }), "outside|gray/white matter");
  EXPECT_EQ(groups.at({ 2, 1002 }), "gray/white matter|core");
  EXPECT_TRUE(this->Files().count("part-2-gray_white_matter.obj"));
  EXPECT_TRUE(this->Files().count("part-5-core.obj"));
  EXPECT_NE(this->Contents("surface.vtu").find("Name=\"gray/white matter\""), std::string::npos);
  const auto names = nlohmann::json::parse(this->Contents("report.json"))["label_names"];
  EXPECT_EQ(names["file"], this->Path("names.txt"));
  ASSERT_EQ(names["labels"].size(), 3u) << names;
  EXPECT_EQ(names["labels"][1]["label"], 2);
  EXPECT_EQ(names["labels"][1]["name"], "gray/white matter");
  EXPECT_EQ(names["labels"][1]["color"], nlohmann::json({ 1.0, 0.0, 0.0 }));
}

TEST_F(CommandLineNames, AreFoundBesideTheImageUnlessThereAreOthers)
{
  this->WriteText("x_dseg.tsv", "index\tname\n2\tshell\n5\tcore\n");
  const auto image = this->WriteImage<LabelImage>(MakeBalls(), "x_dseg.nii.gz");
  const auto run = [&](std::vector<std::string> options) {
    options.insert(options.begin(), { image, this->Path("out.msh"), "--quiet" });
    const auto result = Run(options);
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.error, "");
    return this->GroupsIn("out.msh").at({ 3, 2 });
  };
  EXPECT_EQ(run({}), "shell");
  EXPECT_EQ(run({ "--names", this->WriteTable() }), "gray/white matter");
  EXPECT_EQ(run({ "--names", "none" }), "label 2");
}

TEST_F(CommandLineNames, OfTheImageFollowItsLabels)
{
  this->WriteText("x_dseg.tsv", "index\tname\n2\tshell\n5\tcore\n7\tother\n");
  const auto image = this->WriteImage<LabelImage>(MakeBalls(), "x_dseg.nii.gz");
  const auto run = [&](std::vector<std::string> options) {
    options.insert(options.begin(), { image, this->Path("out.msh"), "--quiet" });
    return Run(options);
  };
  EXPECT_EQ(run({ "--map", this->WriteText("map.txt", "2 5\n5 7\n") }).error, "");
  EXPECT_EQ(this->GroupsIn("out.msh").at({ 3, 5 }), "shell");
  EXPECT_EQ(this->GroupsIn("out.msh").at({ 3, 7 }), "core");
  const auto joined = run({ "--merge", "7=2,5" });
  EXPECT_EQ(joined.error,
            "multimaterial-mesh: warning: " + this->Path("x_dseg.tsv") +
              " has no name for label 7; --names FILE names what --map and --merge join\n");
  EXPECT_EQ(this->GroupsIn("out.msh").at({ 3, 7 }), "label 7");
  // the table that is given has the names of the new labels
  EXPECT_EQ(run({ "--merge", "7=2,5", "--names", this->WriteText("names.json", "{\"7\": \"ball\"}") }).error, "");
  EXPECT_EQ(this->GroupsIn("out.msh").at({ 3, 7 }), "ball");
}

TEST_F(CommandLineNames, LabelsWithoutAreTold)
{
  const auto table = this->WriteText("names.txt", "2 shell\n");
  this->Mesh("out.vtu", { "--names", table }, table + " has no name for label 5");
}

TEST_F(CommandLineNames, BrokenTablesAreRefusedOrLeftOut)
{
  const auto broken = this->WriteText("names.txt", "2 shell\nx\n");
  this->ExpectError(
    { this->WriteBalls(), this->Path("out.vtu"), "--names", broken }, 1, broken + ": line 2 is not LABEL NAME");
  this->ExpectError(
    { this->WriteBalls(), this->Path("out.vtu"), "--names", this->Path("none") }, 1, "there is no such file");
  const auto table = this->WriteText("x_dseg.tsv", "index\tname\ntwo\tshell\n");
  const auto image = this->WriteImage<LabelImage>(MakeBalls(), "x_dseg.nii.gz");
  const auto result = Run({ image, this->Path("out.vtu"), "--quiet" });
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.error,
            "multimaterial-mesh: warning: labels have no names: " + table +
              ": line 2 has no whole number in the column 'index', or no 'name'\n");
}

TEST_F(CommandLineNames, FilesOfLabelsDoNotMeetOthers)
{
  this->ExpectError({ this->WriteBalls(),
                      this->Path("part-5-core.vtu"),
                      "--surface-per-label",
                      this->Path("part-.vtu"),
                      "--names",
                      this->WriteTable() },
                    2,
                    "--surface-per-label could write to");
}
