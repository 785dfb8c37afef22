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
// The JSON file of electrodes, and what is said where it is not right.
#include "itkElectrodes.h"
#include "support/TestLabelImages.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

namespace
{
class ElectrodeFile : public ::testing::Test
{
public:
  ~ElectrodeFile() override { std::remove(m_Name.c_str()); }

  mmm::Electrodes
  Read(const std::string & text) const
  {
    std::ofstream(m_Name) << text;
    return mmm::ReadElectrodes(m_Name);
  }

  /** The text is that of an electrode; the words come after the file's name. */
  void
  ExpectError(const std::string & electrode, const std::string & words) const
  {
    mmmtest::ExpectException([&] { this->Read(R"({"space": "LPS", "electrodes": [)" + electrode + "]}"); },
                             m_Name + ": " + words);
  }

private:
  const std::string m_Name = ::testing::TempDir() + "mmm-electrodes.json";
};
} // namespace

TEST_F(ElectrodeFile, HasShapesInLPSOrRAS)
{
  const auto electrodes = this->Read(R"({
    "space": "RAS",
    "fiducials": {"nasion": [0, 90, 0], "inion": [0, -90, 0], "left": [-70, 0, 0], "right": [70, 0, 0]},
    "electrodes": [
      {"name": "Cz", "label": 101, "shape": "disc", "radius": 5, "thickness": 3, "position": [1, 2, 3],
       "gel": {"label": 201, "thickness": 2}},
      {"label": 102, "shape": "rectangle", "size": [50, 70], "thickness": 4, "site": "C3", "towards": [0, 0, 100]},
      {"name": "tube", "label": 103, "shape": "cylinder", "from": [1, 2, 3], "to": [4, 5, 6], "radius": 2,
       "inner_radius": 1}]})");
  ASSERT_EQ(electrodes.list.size(), 3u);
  const mmm::Electrode & disc = electrodes.list[0];
  EXPECT_EQ(disc.position[0], -1.0);
  EXPECT_EQ(disc.position[1], -2.0);
  EXPECT_EQ(disc.position[2], 3.0);
  EXPECT_EQ(disc.gel->label, 201);
  EXPECT_EQ(electrodes.list[1].name, "C3");
  EXPECT_EQ(electrodes.list[1].size[1], 70.0);
  EXPECT_EQ((*electrodes.list[2].end)[0], -4.0);
  EXPECT_EQ(electrodes.list[2].innerRadius, 1.0);
  EXPECT_EQ(electrodes.fiducials->nasion[1], -90.0);
  const auto names = mmm::NamesOf(electrodes);
  EXPECT_EQ(names.at(101).name, "Cz");
  EXPECT_EQ(names.at(201).name, "Cz gel");
}

TEST_F(ElectrodeFile, LeadIsAShaftAndItsContacts)
{
  const auto list = this
                      ->Read(R"({"space": "LPS", "electrodes": [{"name": "left", "label": 51, "shape": "lead",
    "shaft_label": 50, "model": "Medtronic 3389", "tip": [1, 2, 3], "entry": [1, 2, 33]}]})")
                      .list;
  ASSERT_EQ(list.size(), 5u);
  EXPECT_EQ(list[0].label, 50);
  EXPECT_TRUE(list[0].isRounded);
  for (int contact = 1; contact <= 4; ++contact)
  {
    EXPECT_EQ(list[contact].name, "left contact " + std::to_string(contact));
    EXPECT_EQ(list[contact].label, 50 + contact);
    EXPECT_EQ(list[contact].bodyLabel, 50);
    EXPECT_DOUBLE_EQ(list[contact].radius, 0.635);
    EXPECT_DOUBLE_EQ(list[contact].position[2], 3.0 + 1.5 + 2.0 * (contact - 1));
    EXPECT_DOUBLE_EQ((*list[contact].end)[2], list[contact].position[2] + 1.5);
  }
}

TEST_F(ElectrodeFile, LeadsMayHaveDimensionsOfTheirOwn)
{
  const auto list = this
                      ->Read(R"({"space": "LPS", "electrodes": [{"label": 51, "shape": "lead", "shaft_label": 50,
    "diameter": 2, "tip_length": 1, "contacts": 2, "contact_length": 3, "spacing": 4, "tip": [0, 0, 0],
    "entry": [20, 0, 0]}]})")
                      .list;
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[2].name, "contact 2");
  EXPECT_DOUBLE_EQ(list[2].position[0], 8.0);
  EXPECT_DOUBLE_EQ((*list[2].end)[0], 11.0);
  EXPECT_DOUBLE_EQ(list[2].radius, 1.0);
}

TEST_F(ElectrodeFile, ErrorsOfLeadsTellThePlaceInIt)
{
  const std::string lead = R"({"shape": "lead", "label": 51, "tip": [0, 0, 0], "entry": [0, 0, 9], )";
  this->ExpectError(lead + R"("shaft_label": 50, "model": "DB-1"})",
                    "electrodes[0].model: 'DB-1' is no lead that is known; known are Boston Scientific DB-2201, ");
  this->ExpectError(lead + R"("shaft_label": 50, "model": "Medtronic 3387"})",
                    "electrodes[0].entry: it is 9 mm from the tip, and the contacts reach up to 12 mm.");
  this->ExpectError(lead + R"("shaft_label": 54, "model": "Medtronic 3389"})",
                    "electrodes[0].shaft_label: it is that of a contact: they have the labels from 51 to 54.");
  this->ExpectError(lead + R"("shaft_label": 50, "model": "Medtronic 3389", "spacing": 1})",
                    "electrodes[0].spacing: the model says this.");
  this->ExpectError(lead + R"("shaft_label": 50, "contacts": 2.5})",
                    "electrodes[0].contacts: it has to be a whole number up to 64.");
  this->ExpectError(lead + R"("shaft_label": 50, "contacts": 2})", "electrodes[0].diameter: it is missing.");
}

TEST_F(ElectrodeFile, ErrorsTellThePlaceInIt)
{
  this->ExpectError("", "electrodes: there is none.");
  this->ExpectError("3", "electrodes[0].shape: it is missing.");
  this->ExpectError(R"({"shape": "cube"})", "electrodes[0].shape: 'cube' is no shape; it can be disc, ring, rectangle");
  const std::string disc = R"({"shape": "disc", "label": 9, "thickness": 2, "position": [1, 2, 3], "radius": )";
  this->ExpectError(disc + "-2}", "electrodes[0].radius: -2 mm is not positive.");
  this->ExpectError(disc + "\"5\"}", "electrodes[0].radius: this has to be a number.");
  this->ExpectError(disc + "5, \"colour\": 3}",
                    "electrodes[0].colour: there is no such key here; it can be name, label, shape, position, site, "
                    "radius, thickness or gel.");
  this->ExpectError(disc + "5, \"site\": \"Cz\"}", "electrodes[0]: it needs either a position");
  this->ExpectError(disc + "5}, " + disc + "5, \"gel\": {\"label\": 9, \"thickness\": 2}}",
                    "electrodes[1].gel.label: the electrode itself has this label.");
  this->ExpectError(R"({"shape": "disc", "label": 9.5, "thickness": 2, "position": [1, 2, 3], "radius": 1})",
                    "electrodes[0].label: 9.5 is no label");
  this->ExpectError(R"({"shape": "disc", "label": 9, "thickness": 2, "position": [1, 2], "radius": 1})",
                    "electrodes[0].position: there are 2 numbers; it has to be 3.");
  this->ExpectError(R"({"shape": "ring", "label": 9, "radius": 3, "inner_radius": 4})",
                    "electrodes[0].inner_radius: it has to be less than the radius.");
  this->ExpectError(R"({"shape": "cylinder", "label": 9, "radius": 3, "from": [1, 1, 1], "to": [1, 1, 1]})",
                    "electrodes[0].to: it is the same place as 'from'.");
  mmmtest::ExpectException([&] { this->Read(R"({"electrodes": []})"); }, "space: it is missing.");
  mmmtest::ExpectException([&] { this->Read(R"({"space": "MNI", "electrodes": []})"); },
                           "space: 'MNI' is neither LPS nor RAS.");
  mmmtest::ExpectException([] { mmm::ReadElectrodes("no-such.json"); }, "no-such.json: the file cannot be read.");
}
