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
// The other program: optimize-tetrahedral-mesh.
#include "CommandLineTest.h"

namespace
{
class OptimizeTetrahedralMesh : public CommandLine
{
public:
  static RunResult
  Optimize(std::vector<std::string> arguments)
  {
    arguments.insert(arguments.begin(), OPTIMIZE_TETRAHEDRAL_MESH);
    return Start(arguments);
  }

  void
  ExpectFailure(const std::vector<std::string> & arguments, int exitCode, const std::string & message) const
  {
    const auto files = this->Files();
    const auto result = Optimize(arguments);
    EXPECT_EQ(result.exitCode, exitCode);
    ASSERT_EQ(result.ErrorLines().size(), 1u) << result.error;
    EXPECT_EQ(result.error.rfind("optimize-tetrahedral-mesh: error: ", 0), 0u) << result.error;
    EXPECT_NE(result.error.find(message), std::string::npos) << result.error;
    EXPECT_EQ(this->Files(), files);
  }
};
} // namespace

TEST_F(OptimizeTetrahedralMesh, InputIsNotOverwritten)
{
  ASSERT_EQ(Run({ this->WriteBalls(), this->Path("in.msh"), "--quiet" }).exitCode, 0);
  const auto before = this->Contents("in.msh");
  ExpectFailure({ this->Path("in.msh"), this->Path("./in.msh") }, 2, "INPUT and OUTPUT are the same file");
  EXPECT_EQ(this->Contents("in.msh"), before);
}

TEST_F(OptimizeTetrahedralMesh, FolderOfTheOutputIsCheckedFirst)
{
  ASSERT_EQ(Run({ this->WriteBalls(), this->Path("in.vtu"), "--quiet" }).exitCode, 0);
  ExpectFailure({ this->Path("in.vtu"), this->Path("missing/out.vtu") }, 1, "does not exist; create it first");
}

TEST_F(OptimizeTetrahedralMesh, ReadsAndWritesAllFormats)
{
  const auto labels = this->WriteBalls();
  for (const std::string extension : { ".vtu", ".msh", ".mesh" })
  {
    ASSERT_EQ(Run({ labels, this->Path("in" + extension), "--quiet" }).exitCode, 0);
    const auto result = Optimize({ this->Path("in" + extension), this->Path("out" + extension) });
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_EQ(result.error, "");
    EXPECT_NE(result.output.find("before: "), std::string::npos);
    EXPECT_NE(result.output.find("after: "), std::string::npos);
    // its own triangles between labels are no tetrahedra
    EXPECT_EQ(result.output.find("left out") == std::string::npos, extension == ".vtu");
    EXPECT_EQ(Optimize({ this->Path("out" + extension), this->Path("again.vtu"), "--quiet" }).output, "");
  }
}

TEST_F(OptimizeTetrahedralMesh, ErrorsAreOneLine)
{
  this->ExpectFailure({ this->Path("missing.vtu"), this->Path("out.vtu") }, 1, "missing.vtu");
  this->ExpectFailure({ this->Path("in.stl"), this->Path("out.vtu") }, 2, "in.stl");
  this->ExpectFailure({ this->Path("in.vtu"), this->Path("out.vtu"), "--tolerance", "0" }, 2, "--tolerance");
  this->ExpectFailure({ this->Path("in.vtu") }, 2, "OUTPUT");
}

TEST_F(OptimizeTetrahedralMesh, RefusesASurface)
{
  ASSERT_EQ(Run({ this->WriteBalls(), this->Path("surface.msh"), "--surface-only", "--quiet" }).exitCode, 0);
  this->ExpectFailure({ this->Path("surface.msh"), this->Path("out.vtu") }, 1, "no tetrahedra");
}
