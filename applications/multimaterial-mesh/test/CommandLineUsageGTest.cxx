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
// What the program says of command lines that it does not understand, and of outputs that it cannot write.
#include "CommandLineTest.h"

#include "options/OptionTable.h"

#include <algorithm>
#include <fstream>

namespace
{
class CommandLineUsage : public CommandLine
{
public:
  void
  ExpectUsageError(std::vector<std::string> options, const std::string & message) const
  {
    options.insert(options.begin(), { this->WriteBalls(), this->Path("out.vtu") });
    this->ExpectError(options, 2, message);
  }
};
} // namespace

TEST_F(CommandLineUsage, NoArguments) { this->ExpectError({}, 2, "LABELS is required; --help lists the options"); }

TEST_F(CommandLineUsage, UnknownOption) { this->ExpectUsageError({ "--smooth" }, "--smooth"); }

TEST_F(CommandLineUsage, NegativeSize)
{
  this->ExpectUsageError({ "--min-size", "-1" }, "--min-size is '-1'; it has to be a number above 0 (mm)");
}

TEST_F(CommandLineUsage, NumbersOutOfRange)
{
  this->ExpectUsageError({ "--radius", "-0.5" }, "--radius");
  this->ExpectUsageError({ "--epsilon", "0" }, "--epsilon");
  this->ExpectUsageError({ "--tolerance", "0" }, "--tolerance");
  this->ExpectUsageError({ "--gradient-limit", "0" }, "--gradient-limit");
  this->ExpectUsageError({ "--max-size", "nan" }, "--max-size");
  this->ExpectUsageError({ "--min-island", "-8" }, "--min-island");
  this->ExpectUsageError({ "--min-island", "2.5" }, "--min-island");
  this->ExpectUsageError({ "--threads", "0" }, "--threads");
  this->ExpectUsageError({ "--seed", "-1" }, "--seed");
  this->ExpectUsageError({ "--seed", "99999999999999999999" }, "--seed");
}

TEST_F(CommandLineUsage, TextForNumber)
{
  this->ExpectUsageError({ "--radius", "half" }, "--radius is 'half'; it has to be a number of at least 0 (mm)");
  this->ExpectUsageError({ "--radius", "0,5" }, "--radius is '0,5'");
}

TEST_F(CommandLineUsage, MinimumAboveMaximum)
{
  this->ExpectUsageError({ "--min-size", "2", "--max-size", "1" }, "--min-size is 2 mm, but --max-size is only 1 mm");
}

TEST_F(CommandLineUsage, ExteriorIsNoList)
{
  for (const char * const list : { "0,", "x", "0;1", "1,none", "1.5" })
  {
    this->ExpectUsageError({ "--exterior", list }, "--exterior");
  }
}

TEST_F(CommandLineUsage, OutputOfAnotherFormat)
{
  const auto labels = this->WriteBalls();
  this->ExpectError({ labels, this->Path("out.vtk") }, 2, "meshes are written as .vtu");
  this->ExpectError({ labels, this->Path("out.stl") }, 2, "meshes are written as .vtu, .msh or .mesh");
  this->ExpectUsageError({ "--surface", this->Path("surface.ply") }, "surfaces are written as .vtu, .msh, .mesh, .stl");
  this->ExpectUsageError({ "--particles", this->Path("particles.msh") }, "particles are written as .vtu");
  this->ExpectUsageError({ "--save-sizing", this->Path("size.png") }, "images are written as .nrrd");
}

TEST_F(CommandLineUsage, HullsThatCannotBe)
{
  for (const char * const text : { "hull.stl", "=2", "hull.stl=none" })
  {
    this->ExpectUsageError({ "--hull", text }, std::string("--hull is '") + text + "'; it has to be FILE=L[,L...]");
  }
  this->ExpectUsageError({ "--hull", "hull.stl=2,x" }, "it has to be integer labels");
  this->ExpectUsageError({ "--hull", this->Path("hull.ply") + "=2" }, "surfaces are written as .vtu");
  this->ExpectUsageError({ "--hull", this->Path("hull.stl") + "=0,2" }, "has the label 0, which is exterior");
  const auto labels = this->WriteBalls();
  this->ExpectError({ labels, this->Path("out.vtu"), "--hull", this->Path("hull.stl") + "=7", "--quiet" },
                    1,
                    "no voxel has a label of --hull");
}

TEST_F(CommandLineUsage, FormatThatThereIsNot)
{
  this->ExpectUsageError({ "--msh-format", "3" }, "--msh-format is '3'; it has to be one of 4.1, 4.1-ascii, 2.2");
}

TEST_F(CommandLineUsage, RASWithoutAFileForIt)
{
  this->ExpectUsageError({ "--ras" }, "--ras is for other files than .vtu");
  this->ExpectUsageError({ "--ras", "--surface", this->Path("surface.vtu") }, "--ras is for other files than .vtu");
}

TEST_F(CommandLineUsage, LabelsThatSimNIBSHasNot)
{
  const auto image = MakeBalls();
  image->SetPixel({ { 1, 1, 1 } }, 1000);
  const auto labels = this->WriteImage<LabelImage>(image, "large.nrrd");
  this->ExpectError(
    { labels, this->Path("out.msh"), "--msh-format", "simnibs", "--quiet" }, 1, "label 1000 is to be meshed");
}

TEST_F(CommandLineUsage, AirThatSimNIBSHasNot)
{
  const auto image = MakeBalls();
  std::replace(image->GetBufferPointer(), image->GetBufferPointer() + 16 * 16 * 16, 0, 1);
  const auto full = this->WriteImage<LabelImage>(image, "full.nrrd");
  const auto run = [&](const std::string & labels, const std::vector<std::string> & options) {
    std::vector<std::string> arguments{ labels, this->Path("out.msh"), "--msh-format", "simnibs", "--quiet" };
    arguments.insert(arguments.end(), options.begin(), options.end());
    this->ExpectError(arguments, 1, "label 0 is that of the air; leave out --fill-exterior and --air-margin");
  };
  run(this->WriteBalls(), { "--fill-exterior" });
  run(full, { "--air-margin", "2" });
}

TEST_F(CommandLineUsage, OptionInPlaceOfAFileName)
{
  this->ExpectUsageError({ "--report", "--quiet" }, "--report is '--quiet', which looks like an option");
}

TEST_F(CommandLineUsage, OneFileForTwoPurposes)
{
  this->ExpectUsageError({ "--surface", this->Path("./out.vtu") }, "are the same file");
  this->ExpectUsageError({ "--save-sizing", this->Path("labels.nrrd") }, "are the same file");
}

TEST_F(CommandLineUsage, PrefixOfAnotherFile)
{
  const auto prefix = this->Path("part");
  this->ExpectUsageError({ "--save-indicators", prefix, "--save-sizing", prefix + "-3.nrrd" },
                         "--save-indicators could write to " + prefix +
                           "-3.nrrd, which is the file of --save-sizing; choose another prefix");
  this->ExpectUsageError({ "--surface-per-label", prefix + ".vtu", "--particles", prefix + "12.vtu" },
                         "which is the file of --particles");
  this->ExpectUsageError({ "--save-indicators", prefix, "--roi", prefix + "5.nrrd", "--roi-max-size", "2" },
                         "which is the file of --roi");
}

TEST_F(CommandLineUsage, SurfaceTwice)
{
  this->ExpectUsageError({ "--surface-only", "--surface", this->Path("surface.vtu") }, "leave out --surface");
}

TEST_F(CommandLineUsage, NoOutputFolder)
{
  const auto labels = this->WriteBalls();
  this->ExpectError({ labels, this->Path("missing/out.vtu") }, 1, "does not exist; create it first");
  this->ExpectError({ labels, this->Path("out.vtu"), "--report", this->Path("missing/report.json") },
                    1,
                    "missing/report.json: the folder");
  this->ExpectError({ labels, this->Path("out.vtu"), "--save-indicators", this->Path("missing/f") }, 1, "the folder");
  this->ExpectError({ labels, this->Path("out.vtu"), "--surface-per-label", this->Path("missing/s") }, 1, "the folder");
}

TEST_F(CommandLineUsage, OutputIsAFolder)
{
  const auto labels = this->WriteBalls();
  std::filesystem::create_directory(this->Path("out.vtu"));
  this->ExpectError({ labels, this->Path("out.vtu") }, 1, "out.vtu: it is a folder");
}

#ifndef _WIN32
TEST_F(CommandLineUsage, OutputIsADevice)
{
  const auto labels = this->WriteBalls();
  this->ExpectError({ labels, this->Path("out.vtu"), "--report", "/dev/null" }, 1, "it is not an ordinary file");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}
#endif

TEST_F(CommandLineUsage, HelpListsAllOptionsWithUnits)
{
  for (const char * const option : { "--help", "-h" })
  {
    const auto result = Run({ option });
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.error, "");
    cli::ForEachOption([&](const auto & entry) {
      EXPECT_NE(result.output.find(cli::NameOf(entry)), std::string::npos) << entry.name;
      EXPECT_NE(result.output.find(entry.unit), std::string::npos) << entry.name;
    });
  }
}

TEST_F(CommandLineUsage, HelpComesBeforeErrors)
{
  const auto result = Run({ "--radius", "-1", "--help" });
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.error, "");
}

TEST_F(CommandLineUsage, ParametersPageHasARowForEachOption)
{
  std::ifstream stream(PARAMETERS_PAGE);
  std::string   rows;
  for (std::string line; std::getline(stream, line);)
  {
    if (line.rfind("| `--", 0) == 0)
    {
      rows += line + '\n';
    }
  }
  cli::ForEachOption([&](const auto & entry) {
    if (!entry.IsPositional())
    {
      const std::string usage = cli::NameOf(entry) + (entry.placeholder.empty() ? "" : " " + entry.placeholder);
      EXPECT_NE(rows.find('`' + usage + '`'), std::string::npos) << usage;
    }
  });
}

TEST_F(CommandLineUsage, Version)
{
  const auto result = Run({ "--version" });
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.output.rfind("multimaterial-mesh ", 0), 0u) << result.output;
  EXPECT_EQ(result.error, "");
}
