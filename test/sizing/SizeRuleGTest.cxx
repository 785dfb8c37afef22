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
#include "sizing/SizeRule.h"

#include "support/TestLabelImages.h"

#include <cmath>

TEST(SizeRule, TextGivesFactorAndBoundsByLabel)
{
  const auto rules = mmm::ParseLabelSizeRules("3:factor=0.5:max=2,-7:min=1e-1");
  ASSERT_EQ(rules.size(), 2u);
  EXPECT_EQ(rules.at(3).factor, 0.5);
  EXPECT_EQ(rules.at(3).maximumSize, 2.0);
  EXPECT_TRUE(std::isnan(rules.at(3).minimumSize));
  EXPECT_EQ(rules.at(-7).factor, 1.0);
  EXPECT_EQ(rules.at(-7).minimumSize, 0.1);
}

TEST(SizeRule, EmptyTextHasNoRules) { EXPECT_TRUE(mmm::ParseLabelSizeRules("").empty()); }

TEST(SizeRule, TextComesBack)
{
  const std::string text = "-7:min=0.25,3:factor=0.5:min=1:max=2";
  EXPECT_EQ(mmm::ToText(mmm::ParseLabelSizeRules(text)), text);
}

TEST(SizeRule, ThrowsOnTextThatIsNoRule)
{
  const auto expect = [](const std::string & text, const std::string & words) {
    mmmtest::ExpectException([&] { mmm::ParseLabelSizeRules(text); }, words);
  };
  expect("bone:max=2", "'bone' where a label has to be");
  expect("3.5:max=2", "'3.5' where a label has to be");
  expect("3:max=2,", "'' where a label has to be");
  expect("99999999999:max=2", "'99999999999' where a label has to be");
  expect("3:size=2", "The sizes of label 3 have 'size=2', which is none of factor=NUMBER, min=NUMBER");
  expect("3:max", "'max'");
  expect("3:max=", "'max='");
  expect("3:max=2mm", "'max=2mm'");
  expect("3:max=2 ", "'max=2 '");
  expect("3", "ask for nothing in label 3");
  expect("3:max=2,3:min=1", "The sizes of label 3 are given twice");
}

TEST(SizeRule, UnknownLabelsAreNamedWithThoseThereAre)
{
  const auto rules = mmm::ParseLabelSizeRules("2:max=1,8:max=1,9:max=1");
  EXPECT_EQ(mmm::DescribeUnknownLabels(rules, { 9, 8, 2 }), "");
  EXPECT_EQ(mmm::DescribeUnknownLabels(rules, { 12, 0, 1, 2, 4, 3, 13 }),
            "Sizes are given for 8, 9, which is no label here. The labels are 0 to 4, 12, 13.");
}
