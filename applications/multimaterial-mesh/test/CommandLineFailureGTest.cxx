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
// What becomes of files when the program cannot finish. The means to make it fail are those of POSIX.
#include "CommandLineTest.h"

#include <filesystem>
#include <fstream>

namespace
{
class CommandLineFailure : public CommandLine
{
public:
  /** Runs the program after a command of the shell. */
  static RunResult
  RunAfter(const std::string & shellCommand, const std::vector<std::string> & arguments)
  {
    std::vector<std::string> command{ "/bin/sh", "-c", shellCommand + "; exec \"$@\"", "sh", MULTIMATERIAL_MESH };
    command.insert(command.end(), arguments.begin(), arguments.end());
    return Start(command);
  }

  static void
  ExpectOneLine(const RunResult & result, const std::string & message)
  {
    EXPECT_EQ(result.exitCode, 1);
    ASSERT_EQ(result.ErrorLines().size(), 1u) << result.error;
    EXPECT_EQ(result.error.rfind("multimaterial-mesh: error: ", 0), 0u) << result.error;
    EXPECT_NE(result.error.find(message), std::string::npos) << result.error;
  }

  static void
  ExpectOneWarning(const RunResult & result, const std::string & message)
  {
    EXPECT_EQ(result.exitCode, 0);
    ASSERT_EQ(result.ErrorLines().size(), 1u) << result.error;
    EXPECT_EQ(result.error.rfind("multimaterial-mesh: warning: ", 0), 0u) << result.error;
    EXPECT_NE(result.error.find(message), std::string::npos) << result.error;
  }

  /** With a disk that has room for the mesh but not for another, larger file. */
  void
  ExpectTooLarge(const std::string & option, const std::string & name) const
  {
    const std::vector<std::string> arguments{ this->WriteBalls(), this->Path("out.vtu"), "--min-size", "3", option,
                                              this->Path(name) };
    ASSERT_EQ(Run(arguments).exitCode, 0);
    const auto blocks = std::filesystem::file_size(this->Path("out.vtu")) / 512 + 1;
    ASSERT_GT(std::filesystem::file_size(this->Path(name)) / 512, blocks);
    std::filesystem::remove(this->Path(name));
    ExpectOneLine(RunAfter("ulimit -f " + std::to_string(blocks), arguments), name);
    EXPECT_EQ(this->Files(), (std::set<std::string>{ "labels.nrrd", "out.vtu" }));
  }

  /** An image that takes seconds to mesh. */
  std::string
  WriteLargeImage() const
  {
    const auto image = MakeImage<short>(itk::Size<3>{ { 100, 100, 100 } });
    for (int v = 0; v < 100 * 100 * 100; ++v)
    {
      image->GetBufferPointer()[v] = short((v / 8 + v / 800 + v / 80000) % 4);
    }
    return this->WriteImage<LabelImage>(image, "large.nrrd");
  }
};

// Files may have 512 bytes, and then are full like a disk.
const char * const SmallFiles = "ulimit -f 1";
} // namespace

TEST_F(CommandLineFailure, FullDiskLeavesNoMesh)
{
  const auto labels = this->WriteBalls();
  ExpectOneLine(RunAfter(SmallFiles, { labels, this->Path("out.vtu") }), "out.vtu");
  ExpectOneLine(RunAfter(SmallFiles, { labels, this->Path("out.vtu"), "--surface-only" }), "out.vtu");
  for (const char * const name : { "out.msh", "out.mesh" })
  {
    ExpectOneLine(RunAfter(SmallFiles, { labels, this->Path(name) }), name);
  }
  for (const char * const name : { "out.stl", "out.obj", "out.off" })
  {
    ExpectOneLine(RunAfter(SmallFiles, { labels, this->Path(name), "--surface-only" }), name);
  }
  EXPECT_EQ(this->Files(), std::set<std::string>{ "labels.nrrd" });
}

TEST_F(CommandLineFailure, FullDiskKeepsAnOlderMesh)
{
  const auto labels = this->WriteBalls();
  std::ofstream(this->Path("out.vtu")) << "old";
  ExpectOneLine(RunAfter(SmallFiles, { labels, this->Path("out.vtu") }), "out.vtu");
  EXPECT_EQ(this->Contents("out.vtu"), "old");
}

TEST_F(CommandLineFailure, FullDiskLeavesNoImage) { this->ExpectTooLarge("--save-sizing", "size.nii"); }

TEST_F(CommandLineFailure, FullDiskLeavesNoReport) { this->ExpectTooLarge("--report", "report.json"); }

TEST_F(CommandLineFailure, InterruptionLeavesNoFile)
{
  const std::vector<std::string> command{ MULTIMATERIAL_MESH, this->WriteLargeImage(), this->Path("out.vtu") };
  const auto                     result = Start(command, "reading ...");
  EXPECT_EQ(result.exitCode, 130);
  EXPECT_EQ(result.error, "multimaterial-mesh: aborted\n");
  EXPECT_EQ(this->Files(), std::set<std::string>{ "large.nrrd" });
}

TEST_F(CommandLineFailure, TerminationLeavesNoFile)
{
  const std::string runAndTerminate = "\"$@\" > \"$OUT\" & pid=$!; "
                                      "until grep -q '<filter-progress>' \"$OUT\"; do sleep 0.1; done; "
                                      "kill -TERM $pid; wait $pid";
  const auto        result = Start({ "/bin/sh",
                                     "-c",
                                     "export OUT='" + this->Path("stdout.txt") + "'; " + runAndTerminate,
                                     "sh",
                                     MULTIMATERIAL_MESH,
                                     this->WriteLargeImage(),
                                     this->Path("out.vtu"),
                                     "--slicer-progress" });
  EXPECT_EQ(result.exitCode, 143);
  EXPECT_NE(result.error.find("multimaterial-mesh: aborted\n"), std::string::npos) << result.error;
  EXPECT_EQ(this->Files(), (std::set<std::string>{ "large.nrrd", "stdout.txt" }));
}

TEST_F(CommandLineFailure, OutOfMemory)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__APPLE__)
  GTEST_SKIP() << "The address space cannot be limited.";
#endif
  // Half a GB: enough to start, not enough for the image.
  const auto image = MakeImage<unsigned char>(itk::Size<3>{ { 512, 512, 512 } });
  const auto labels = this->WriteImage<itk::Image<unsigned char, 3>>(image, "huge.nrrd");
  ExpectOneLine(RunAfter("ulimit -v 500000", { labels, this->Path("out.vtu") }), "not enough memory");
  EXPECT_EQ(this->Files(), std::set<std::string>{ "huge.nrrd" });
}

#ifdef FAILING_TETGEN
namespace
{
/** TetGen's last call is that for the mesh, of which the others are the surface's. */
class CommandLineTetGen : public CommandLineFailure
{
public:
  /** Runs the program; its last call of TetGen fails, and what comes after that. */
  RunResult
  RunWithFailure(const std::string & environment, const std::vector<std::string> & options) const
  {
    std::vector<std::string> arguments{ this->WriteBalls(), this->Path("out.vtu") };
    arguments.insert(arguments.end(), options.begin(), options.end());
    const std::string preload = "export LD_PRELOAD='" FAILING_TETGEN "' ";
    EXPECT_EQ(RunAfter(preload + "COUNT='" + this->Path("count") + "'", arguments).exitCode, 0);
    const std::string count = this->Contents("count");
    std::filesystem::remove(this->Path("count"));
    std::filesystem::remove(this->Path("out.vtu"));
    return RunAfter(preload + "FAIL_AT=" + count + " " + environment, arguments);
  }
};
} // namespace

TEST_F(CommandLineTetGen, SurfaceIsKeptIfItFails)
{
  ExpectOneLine(this->RunWithFailure("", {}),
                "the surface is kept for inspection in " + this->Path("out-surface-for-inspection.vtu"));
  EXPECT_EQ(this->Files(), (std::set<std::string>{ "labels.nrrd", "out-surface-for-inspection.vtu" }));
}

TEST_F(CommandLineTetGen, MeshIsMadeByRecoveryIfOtherwiseThereIsNone)
{
  // without facets it is tried twice
  const auto result = this->RunWithFailure("TIMES=2", { "--quiet" });
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.error, "");
  EXPECT_EQ(this->Files(), (std::set<std::string>{ "labels.nrrd", "out.vtu" }));
}

TEST_F(CommandLineTetGen, MeshIsMadeWithoutAnInteriorIfRecoveryFails)
{
  ExpectOneWarning(this->RunWithFailure("TIMES=3", { "--quiet" }), "all points of the interior were left out");
  EXPECT_EQ(this->Files(), (std::set<std::string>{ "labels.nrrd", "out.vtu" }));
}

TEST_F(CommandLineTetGen, IsNotNeededForASurface)
{
  ExpectOneWarning(this->RunWithFailure("", { "--surface-only", "--quiet" }), "the surface was not improved");
  EXPECT_EQ(this->Files(), (std::set<std::string>{ "labels.nrrd", "out.vtu" }));
}

TEST_F(CommandLineTetGen, OutOfMemory) { ExpectOneLine(this->RunWithFailure("OUT_OF_MEMORY=1", {}), "memory"); }

TEST_F(CommandLineTetGen, OutOfMemoryWhereOnlyTheSurfaceIsWanted)
{
  ExpectOneLine(this->RunWithFailure("OUT_OF_MEMORY=1", { "--surface-only" }), "memory");
}

TEST_F(CommandLineTetGen, WordsOfItsOwnArePassedOn)
{
  const auto result = this->RunWithFailure("", {});
  EXPECT_NE(result.error.find("A self-intersection was detected"), std::string::npos) << result.error;
}
#endif
