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
// What 3D Slicer asks of the programs that it runs.
#include "CommandLineTest.h"

#include "options/OptionTable.h"

// The header of ITK's own or the system's expat: ITK installs the first name from version 6 on.
#if __has_include("itk_expat.h")
#  include "itk_expat.h"
#else
#  include "expat.h"
#endif

#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>

namespace
{
/** A parameter of the description: its element, attributes and what is in it. */
using Parameter = std::map<std::string, std::string>;

/** Reads the description of a program. Fails the test if it is not well-formed. */
class Description
{
public:
  explicit Description(const std::string & xml)
  {
    const XML_Parser parser = XML_ParserCreate(nullptr);
    XML_SetUserData(parser, this);
    XML_SetElementHandler(parser, Begin, End);
    XML_SetCharacterDataHandler(parser, Text);
    EXPECT_EQ(XML_Parse(parser, xml.data(), int(xml.size()), 1), XML_STATUS_OK)
      << XML_ErrorString(XML_GetErrorCode(parser)) << " in line " << XML_GetCurrentLineNumber(parser);
    XML_ParserFree(parser);
  }

  std::vector<std::string> groups;
  std::vector<Parameter>   parameters;
  Parameter                program;

private:
  static void
  Begin(void * data, const XML_Char * name, const XML_Char ** attributes)
  {
    auto & self = *static_cast<Description *>(data);
    ++self.m_Depth;
    self.m_Text.clear();
    if (self.m_Depth == 3 && std::string(name) != "label" && std::string(name) != "description")
    {
      self.parameters.push_back({ { "element", name } });
      for (; *attributes != nullptr; attributes += 2)
      {
        self.parameters.back()[attributes[0]] = attributes[1];
      }
    }
  }

  static void
  End(void * data, const XML_Char * name)
  {
    auto & self = *static_cast<Description *>(data);
    if (self.m_Depth == 2)
    {
      self.program[name] = self.m_Text;
    }
    if (self.m_Depth == 3 && std::string(name) == "label")
    {
      self.groups.push_back(self.m_Text);
    }
    if (self.m_Depth == 4)
    {
      self.parameters.back()[name] = self.m_Text;
    }
    --self.m_Depth;
  }

  static void
  Text(void * data, const XML_Char * text, int length)
  {
    static_cast<Description *>(data)->m_Text.append(text, length);
  }

  int         m_Depth{ 0 };
  std::string m_Text;
};

class SlicerModule : public CommandLine
{
public:
  static Description
  Describe()
  {
    const auto result = Run({ "--xml" });
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.error, "");
    return Description(result.output);
  }

  static Parameter
  Find(const std::string & name)
  {
    for (const auto & parameter : Describe().parameters)
    {
      if (parameter.at("name") == name)
      {
        return parameter;
      }
    }
    ADD_FAILURE() << "The description has no " << name;
    return {};
  }
};
} // namespace

TEST_F(SlicerModule, DescriptionListsExactlyTheOptions)
{
  std::set<std::string> described;
  for (const auto & parameter : Describe().parameters)
  {
    std::string name = parameter.count("longflag") ? parameter.at("longflag") : parameter.at("name");
    std::replace(name.begin(), name.end(), '_', '-');
    EXPECT_TRUE(described.insert(name).second) << name;
    EXPECT_NE(parameter.count("longflag"), parameter.count("index")) << name;
    for (const char * const element : { "label", "description" })
    {
      EXPECT_TRUE(parameter.count(element) && !parameter.at(element).empty()) << name;
    }
  }
  std::set<std::string> expected;
  cli::ForEachOption([&](const auto & option) {
    if (option.audience != cli::Audience::CommandLine)
    {
      expected.insert(cli::NameOf(option));
    }
  });
  EXPECT_EQ(described, expected);
}

TEST_F(SlicerModule, DescriptionHasTheGroupsOfTheTable)
{
  std::set<std::string> expected;
  for (const auto & group : cli::OptionTable())
  {
    expected.insert(group.name);
  }
  const auto groups = Describe().groups;
  EXPECT_EQ(std::set<std::string>(groups.begin(), groups.end()), expected);
  EXPECT_EQ(groups.size(), expected.size());
}

TEST_F(SlicerModule, DescriptionNamesTheProgram)
{
  const auto program = Describe().program;
  EXPECT_EQ(program.at("title"), "Multimaterial Mesh");
  for (const char * const element : { "category", "description", "version", "license", "contributor" })
  {
    EXPECT_TRUE(program.count(element) && !program.at(element).empty()) << element;
  }
}

TEST_F(SlicerModule, NamesAndFlagsAreThoseOfVariables)
{
  // Slicer's parser refuses others.
  const std::string letters = "_abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
  for (const auto & parameter : Describe().parameters)
  {
    EXPECT_EQ(parameter.at("name").find_first_not_of(letters), std::string::npos) << parameter.at("name");
    if (parameter.count("longflag"))
    {
      EXPECT_EQ(parameter.at("longflag"), "--" + parameter.at("name"));
    }
  }
}

TEST_F(SlicerModule, TakesALabelMapAndGivesAModel)
{
  const auto labels = Find("LABELS");
  EXPECT_EQ(labels.at("element"), "image");
  EXPECT_EQ(labels.at("type"), "label");
  EXPECT_EQ(labels.at("channel"), "input");
  EXPECT_EQ(labels.at("index"), "0");
  const auto output = Find("OUTPUT");
  EXPECT_EQ(output.at("element"), "geometry");
  EXPECT_EQ(output.at("type"), "model");
  EXPECT_EQ(output.at("fileExtensions"), ".vtu");
  EXPECT_EQ(output.at("channel"), "output");
  EXPECT_EQ(output.at("index"), "1");
}

TEST_F(SlicerModule, ResultsAreBesideTheLabelMap)
{
  // Slicer puts what an output refers to, and the output, under the same item of its hierarchy.
  std::set<std::string> results;
  for (const auto & parameter : Describe().parameters)
  {
    const bool isNode = parameter.at("element") == "geometry" || parameter.at("element") == "image";
    const bool isResult = isNode && parameter.at("channel") == "output";
    EXPECT_EQ(parameter.count("reference") == 1, isResult) << parameter.at("name");
    if (isResult)
    {
      results.insert(parameter.at("name"));
      EXPECT_EQ(parameter.at("reference"), Find("LABELS").at("name"));
    }
  }
  EXPECT_EQ(results, (std::set<std::string>{ "OUTPUT", "surface", "particles", "junctions", "save_sizing" }));
}

TEST_F(SlicerModule, NumbersThatCanBeLeftOutAreTexts)
{
  // Slicer passes all numbers, and texts only if they are not empty.
  EXPECT_EQ(Find("radius").at("element"), "string");
  EXPECT_EQ(Find("radius").at("default"), "");
  EXPECT_EQ(Find("epsilon").at("element"), "double");
  EXPECT_EQ(Find("epsilon").at("default"), "2.5");
  EXPECT_EQ(Find("min_island").at("element"), "integer");
  EXPECT_EQ(Find("min_island").at("default"), "8");
  EXPECT_EQ(Find("exterior").at("default"), "0");
}

TEST_F(SlicerModule, DefaultsAsSlicerPassesThemGiveTheSameMesh)
{
  const auto               labels = this->WriteBalls();
  std::vector<std::string> arguments;
  for (const auto & parameter : Describe().parameters)
  {
    if (parameter.at("element") == "boolean" && parameter.at("default") == "true")
    {
      arguments.push_back(parameter.at("longflag"));
    }
    else if (parameter.at("element") != "boolean" && parameter.count("default") && !parameter.at("default").empty())
    {
      arguments.insert(arguments.end(), { parameter.at("longflag"), parameter.at("default") });
    }
  }
  ASSERT_GE(arguments.size(), 8u);
  arguments.insert(arguments.end(), { labels, this->Path("slicer.vtu") });
  const auto result = Run(arguments);
  EXPECT_EQ(result.exitCode, 0) << result.error;
  EXPECT_NE(result.output.find("<filter-progress>"), std::string::npos);
  EXPECT_EQ(Run({ labels, this->Path("plain.vtu"), "--slicer-progress", "--quiet" }).exitCode, 0);
  EXPECT_TRUE(this->Contents("slicer.vtu") == this->Contents("plain.vtu"));
}

TEST_F(SlicerModule, ThereIsNoLogo)
{
  const auto result = Run({ "--logo" });
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.output, "");
  EXPECT_EQ(result.error, "");
}

TEST_F(SlicerModule, WhatSlicerAddsIsAccepted)
{
  const auto result = Run({ "--processinformationaddress",
                            "0x55d0c1f0",
                            "--returnparameterfile",
                            this->Path("return.params"),
                            "--quiet",
                            this->WriteBalls(),
                            this->Path("out.vtu") });
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.error, "");
  EXPECT_EQ(this->Files(), (std::set<std::string>{ "labels.nrrd", "out.vtu" }));
}

TEST_F(SlicerModule, ProgressIsLinesOfXMLThatNeverGoBack)
{
  const auto result = Run({ "--slicer-progress", this->WriteBalls(), this->Path("out.vtu") });
  EXPECT_EQ(result.exitCode, 0);
  std::istringstream output(result.output);
  double             last = 0.0;
  int                begun = 0;
  int                ended = 0;
  for (std::string line; std::getline(output, line);)
  {
    const std::string tag = "<filter-progress>";
    begun += line == "<filter-start>" ? 1 : 0;
    ended += line == "</filter-end>" ? 1 : 0;
    if (line.rfind(tag, 0) == 0)
    {
      const double progress = std::stod(line.substr(tag.size()));
      EXPECT_GE(progress, last);
      EXPECT_LE(progress, 1.0);
      last = progress;
    }
  }
  EXPECT_EQ(last, 1.0);
  EXPECT_GT(begun, 5);
  EXPECT_EQ(ended, begun);
  EXPECT_EQ(result.output.rfind("<filter-start>\n<filter-name>reading</filter-name>\n", 0), 0u);
}

TEST_F(SlicerModule, FilesSayThatTheyAreInLPSWhenSlicerRunsIt)
{
  const std::vector<std::string> arguments{
    "--quiet",   this->WriteBalls(),       this->Path("out.vtu"), "--particles", this->Path("particles.vtu"),
    "--surface", this->Path("surface.vtu")
  };
  for (const bool bySlicer : { true, false })
  {
    auto all = arguments;
    all.insert(all.end(), bySlicer, "--slicer-progress");
    EXPECT_EQ(Run(all).exitCode, 0);
    for (const char * const name : { "out.vtu", "particles.vtu", "surface.vtu" })
    {
      EXPECT_EQ(this->Contents(name).find("SPACE") != std::string::npos, bySlicer) << name;
    }
  }
}

TEST_F(SlicerModule, QuietHasNoProgress)
{
  const auto result = Run({ "--slicer-progress", "--quiet", this->WriteBalls(), this->Path("out.vtu") });
  EXPECT_EQ(result.output, "");
}
