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
// The page that --report writes, beside the JSON.
#include "CommandLineTest.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace
{
class CommandLineReport : public CommandLine
{
public:
  /** Meshes MakeBalls() and writes report.json and page.html. */
  RunResult
  Mesh(std::vector<std::string> options = {}) const
  {
    options.insert(options.begin(),
                   { this->WriteBalls(),
                     this->Path("out.vtu"),
                     "--report",
                     this->Path("report.json"),
                     "--report",
                     this->Path("page.html") });
    auto result = Run(options);
    EXPECT_EQ(result.exitCode, 0) << result.error;
    return result;
  }

  nlohmann::json
  Report() const
  {
    return nlohmann::json::parse(this->Contents("report.json"));
  }

  static std::string
  Between(const std::string & text, const std::string & begin, const std::string & end)
  {
    const auto first = text.find(begin);
    EXPECT_NE(first, std::string::npos) << begin;
    const auto last = text.find(end, first);
    EXPECT_NE(last, std::string::npos) << end;
    return text.substr(first + begin.size(), last - first - begin.size());
  }

  /** What the page has for programs: the values of its data elements. */
  std::multiset<double>
  Values() const
  {
    const std::string     page = this->Contents("page.html");
    const std::string     begin = "<data value=\"";
    std::multiset<double> values;
    for (auto at = page.find(begin); at != std::string::npos; at = page.find(begin, at + 1))
    {
      values.insert(std::stod(page.substr(at + begin.size(), 40)));
    }
    return values;
  }
};

/** Adds all numbers within but those of histograms, which are drawings, and of places in lists. */
void
CollectNumbers(const nlohmann::json & value, std::vector<double> & numbers)
{
  if (value.is_number())
  {
    numbers.push_back(value.get<double>());
  }
  for (const auto & [name, member] : value.items())
  {
    if (value.is_structured() && name.find("histogram") == std::string::npos)
    {
      CollectNumbers(member, numbers);
    }
  }
}
} // namespace

TEST_F(CommandLineReport, PageHasTheJsonWithIt)
{
  this->Mesh();
  const std::string page = this->Contents("page.html");
  EXPECT_EQ(nlohmann::json::parse(Between(page, "<script type=\"application/json\" id=\"report\">", "</script>")),
            this->Report());
}

TEST_F(CommandLineReport, NumbersOfTheJsonAreOnThePage)
{
  this->Mesh();
  const auto report = this->Report();
  const auto values = this->Values();
  for (const auto & label : report["quality"]["labels"])
  {
    for (const char * const name : { "tetrahedra", "volume_mm3", "largest_volume_mm3", "components", "boundary_faces" })
    {
      EXPECT_TRUE(values.count(label[name].get<double>())) << name << ' ' << label[name];
    }
    for (const char * const name : { "radius_ratio", "smallest_dihedral_angle_deg" })
    {
      std::vector<double> numbers;
      CollectNumbers(label[name], numbers);
      EXPECT_EQ(numbers.size(), 3u);
      for (const double number : numbers)
      {
        EXPECT_TRUE(values.count(number)) << name << ' ' << number;
      }
    }
  }
  for (const char * const section : { "counts", "relaxation" })
  {
    std::vector<double> numbers;
    CollectNumbers(report[section], numbers);
    EXPECT_GT(numbers.size(), 5u);
    for (const double number : numbers)
    {
      // the dimension of the particles' cells is in words
      EXPECT_TRUE(values.count(number) || number == 1.0 || number == 2.0 || number == 3.0) << section << ' ' << number;
    }
  }
  for (const auto & stage : report["stages"])
  {
    EXPECT_TRUE(values.count(stage["seconds"].get<double>())) << stage;
  }
}

TEST_F(CommandLineReport, PageTellsFilesAndSettings)
{
  this->Mesh({ "--max-size", "2.5" });
  const std::string page = this->Contents("page.html");
  EXPECT_NE(page.find("<h1>Mesh of labels.nrrd</h1>"), std::string::npos);
  EXPECT_NE(page.find("<th scope=\"row\">max_size_mm</th><td>2.5</td>"), std::string::npos);
  EXPECT_NE(page.find("<th scope=\"row\">written</th><td>" + this->Path("page.html") + "</td>"), std::string::npos);
}

TEST_F(CommandLineReport, PageHasTheWarnings)
{
  const auto result = this->Mesh({ "--exterior", "0,77", "--quiet" });
  EXPECT_EQ(result.ErrorLines().size(), 1u);
  EXPECT_NE(this->Contents("page.html").find("<li>no voxel has the exterior label 77</li>"), std::string::npos);
}

TEST_F(CommandLineReport, VolumesAreComparedWithTheVoxels)
{
  this->Mesh();
  const auto   report = this->Report();
  const auto   values = this->Values();
  const auto & labels = report["quality"]["labels"];
  ASSERT_EQ(labels.size(), 2u);
  for (const auto & label : labels)
  {
    const auto & image = report["input"]["labels"];
    const auto   entry =
      std::find_if(image.begin(), image.end(), [&](const auto & other) { return other["label"] == label["label"]; });
    // voxels of 1 mm^3
    const double error = 100.0 * (label["volume_mm3"].get<double>() / (*entry)["voxels"].get<double>() - 1.0);
    EXPECT_TRUE(
      std::any_of(values.begin(), values.end(), [error](double value) { return std::abs(value - error) < 1e-6; }))
      << error;
  }
}

TEST_F(CommandLineReport, PageOfASurfaceShowsItsSegments)
{
  this->Mesh({ "--surface-only" });
  EXPECT_NE(this->Contents("page.html").find(" segments of the surface"), std::string::npos);
}

TEST_F(CommandLineReport, NameOfAnImageCannotBecomeAnElement)
{
#ifndef _WIN32
  const auto labels = this->WriteImage<LabelImage>(MakeBalls().GetPointer(), "a<b>&.nrrd");
  EXPECT_EQ(Run({ labels, this->Path("out.vtu"), "--report", this->Path("page.html"), "--quiet" }).exitCode, 0);
  EXPECT_NE(this->Contents("page.html").find("<h1>Mesh of a&lt;b&gt;&amp;.nrrd</h1>"), std::string::npos);
#endif
}

TEST_F(CommandLineReport, ReportsAreNoFilesForTwoPurposes)
{
  this->ExpectError({ this->WriteBalls(),
                      this->Path("out.vtu"),
                      "--report",
                      this->Path("page.html"),
                      "--report",
                      this->Path("page.html") },
                    2,
                    "are the same file");
}
