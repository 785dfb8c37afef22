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
#include "report/SvgPath.h"

#include <gtest/gtest.h>

#include <cctype>
#include <cstdlib>
#include <random>
#include <vector>

namespace
{
using mmm::SvgPoint;

/** A line, and whether it is closed. */
struct Line
{
  std::vector<SvgPoint> points;
  bool                  isClosed{ false };
};

/** What a reader of SVG makes of the data: relative moves, lines and closures. */
std::vector<Line>
Read(const std::string & data)
{
  std::vector<Line> lines;
  SvgPoint          place{ { 0, 0 } };
  char              command = 0;
  const char *      at = data.c_str();
  const auto        number = [&at] {
    char *     end = nullptr;
    const long value = std::strtol(at, &end, 10);
    EXPECT_NE(end, at);
    at = end;
    return value;
  };
  while (*at != 0)
  {
    if (std::isalpha(static_cast<unsigned char>(*at)))
    {
      command = *at++;
    }
    if (command == 'z')
    {
      lines.back().isClosed = true;
      place = lines.back().points.front();
      continue;
    }
    place[0] += command == 'v' ? 0 : number();
    place[1] += command == 'h' ? 0 : number();
    if (command == 'm')
    {
      lines.emplace_back();
      command = 'l';
    }
    lines.back().points.push_back(place);
  }
  return lines;
}
} // namespace

TEST(SvgPath, IsShort)
{
  mmm::SvgPath path;
  path.MoveTo({ { 10, 20 } });
  path.LineTo({ { 13, 16 } });
  path.LineTo({ { 12, 18 } });
  path.LineTo({ { 12, 30 } });
  path.Close();
  EXPECT_EQ(path.GetText(), "m10 20 3-4-1 2v12z");
}

TEST(SvgPath, ReadsAsItWasDrawn)
{
  std::mt19937                        random(3);
  std::uniform_int_distribution<long> place(-500, 500);
  std::vector<Line>                   lines;
  mmm::SvgPath                        path;
  for (int n = 0; n < 200; ++n)
  {
    lines.push_back({ {}, n % 3 == 0 });
    for (int p = 0; p < 3 + n % 5; ++p)
    {
      const SvgPoint point{ { place(random), place(random) } };
      lines.back().points.push_back(point);
      p == 0 ? path.MoveTo(point) : path.LineTo(point);
    }
    if (lines.back().isClosed)
    {
      path.Close();
    }
  }
  const auto read = Read(path.GetText());
  ASSERT_EQ(read.size(), lines.size());
  for (std::size_t n = 0; n < lines.size(); ++n)
  {
    EXPECT_EQ(read[n].points, lines[n].points);
    EXPECT_EQ(read[n].isClosed, lines[n].isClosed);
  }
}

TEST(SvgPath, StepsAlongAnAxisBecomeOne)
{
  mmm::SvgPath path;
  path.MoveTo({ { 0, 0 } });
  for (const SvgPoint & point :
       std::vector<SvgPoint>{ { { 1, 0 } }, { { 1, 0 } }, { { 5, 0 } }, { { 5, 2 } }, { { 5, 9 } }, { { 5, 8 } } })
  {
    path.LineTo(point);
  }
  const auto read = Read(path.GetText());
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].points, (std::vector<SvgPoint>{ { { 0, 0 } }, { { 5, 0 } }, { { 5, 9 } }, { { 5, 8 } } }));
}

TEST(SvgPath, PointsAloneLeaveNothing)
{
  mmm::SvgPath path;
  path.MoveTo({ { 3, 4 } });
  path.LineTo({ { 3, 4 } });
  path.Close();
  EXPECT_EQ(path.GetText(), "");
}
