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
#include "report/HTML.h"

#include "report/Histogram.h"
#include "report/LabelLook.h"

#include <gtest/gtest.h>

#include <limits>
#include <locale>
#include <set>

namespace
{
/** Writes 1.234,5. */
class Commas : public std::numpunct<char>
{
  char
  do_decimal_point() const override
  {
    return ',';
  }
  char
  do_thousands_sep() const override
  {
    return '.';
  }
  std::string
  do_grouping() const override
  {
    return "\3";
  }
};
} // namespace

TEST(HTML, TextCannotBecomeElements) { EXPECT_EQ(mmm::EscapedHTML("<b a=\"1\">&"), "&lt;b a=&quot;1&quot;&gt;&amp;"); }

TEST(HTML, BytesThatXMLDoesNotHaveAreReplaced)
{
  EXPECT_EQ(mmm::EscapedHTML("a\xFF"
                             "b\x01"),
            "a\xEF\xBF\xBD"
            "b ");
  EXPECT_EQ(mmm::EscapedHTML("Sch\xC3\xA4"
                             "del"),
            "Sch\xC3\xA4"
            "del");
}

TEST(HTML, NumbersAreRoundedForPeopleAlone)
{
  EXPECT_EQ(mmm::NumberHTML(1234.5678, 1), "<data value=\"1234.5678\">1234.6</data>");
  EXPECT_EQ(mmm::SignedHTML(0.25, 2), "<data value=\"0.25\">+0.25</data>");
  EXPECT_EQ(mmm::SignedHTML(-0.25, 1),
            "<data value=\"-0.25\">\xE2\x88\x92"
            "0.2</data>");
  EXPECT_EQ(mmm::NumberHTML(std::numeric_limits<double>::quiet_NaN(), 1), "\xE2\x80\x93");
  EXPECT_EQ(mmm::CountHTML(1234567),
            "<data value=\"1234567\">1\xE2\x80\xAF"
            "234\xE2\x80\xAF"
            "567</data>");
  EXPECT_EQ(mmm::CountHTML(12), "<data value=\"12\">12</data>");
}

TEST(HTML, NumbersDoNotDependOnTheLocale)
{
  const auto before = std::locale::global(std::locale(std::locale::classic(), new Commas));
  const auto number = mmm::NumberHTML(1234.5, 1);
  const auto count = mmm::CountHTML(12345);
  std::locale::global(before);
  EXPECT_EQ(number, mmm::NumberHTML(1234.5, 1));
  EXPECT_EQ(count, mmm::CountHTML(12345));
}

TEST(HTML, TablesHaveHeadersOfColumnsAndRows)
{
  mmm::HTMLTable table("Caption & more", { { "Name", false }, { "Number" } });
  table.AddRow({ "one", "1" });
  EXPECT_EQ(table.ToText(),
            "<div class=\"wide\"><table><caption>Caption &amp; more</caption>\n"
            "<thead><tr><th scope=\"col\">Name</th><th scope=\"col\" class=\"n\">Number</th></tr></thead>\n"
            "<tbody>\n<tr><th scope=\"row\">one</th><td class=\"n\">1</td></tr>\n</tbody></table></div>\n");
}

TEST(HTML, HistogramsTellTheirLargestRange)
{
  const mmm::Histogram histogram{ { 1, 2, 5, 0 }, 0.0, 180.0, "Angles", " degrees", 0, 6 };
  EXPECT_EQ(mmm::Describe(histogram), "Angles: 62.50 % are from 90 to 135 degrees, more than in any other range");
  EXPECT_NE(mmm::DrawLarge(histogram).find("<title>45 to 90 degrees: 2, 25.00 %</title>"), std::string::npos);
  EXPECT_EQ(mmm::Describe({ { 0, 0 }, 0.0, 1.0, "Ratios", "", 2, 5 }), "Ratios: none");
}

TEST(HTML, BarsOfHistogramsAreAsHighAsTheirShareOfTheLargest)
{
  const auto drawing = mmm::DrawSmall({ { 4, 2, 0 }, 0.0, 1.0, "Ratios", "", 2, 5 });
  EXPECT_NE(drawing.find("M0 100v-100h9v100z"), std::string::npos) << drawing;
  EXPECT_NE(drawing.find("M10 100v-50h9v50z"), std::string::npos) << drawing;
}

TEST(LabelLook, ColorsAndNamesAreThoseOfTheTable)
{
  mmm::LabelTable table;
  table[4].name = "a<b";
  table[4].color = { { 1.0, 0.5, 0.0 } };
  EXPECT_EQ(mmm::ColorText(4, table), "#ff8000");
  EXPECT_EQ(mmm::LabelText(4, table), "4 a<b");
  EXPECT_NE(mmm::LabelHTML(4, table).find("4 a&lt;b"), std::string::npos);
  EXPECT_EQ(mmm::LabelText(5, table), "5");
}

TEST(LabelLook, DefaultColorsAreDifferent)
{
  std::set<std::string> colors;
  for (int label = -20; label < 130; ++label)
  {
    colors.insert(mmm::ColorText(label, {}));
  }
  EXPECT_EQ(colors.size(), 150u);
}
