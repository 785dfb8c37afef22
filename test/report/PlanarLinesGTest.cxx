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
#include "report/PlanarLines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
/** Unit squares whose label is labelOf(column, row), but for those of label 0. */
template <typename TFunction>
mmm::PlanarCells
MakeSquares(std::uint32_t size, const TFunction & labelOf)
{
  mmm::PlanarCells squares;
  for (std::uint32_t row = 0; row <= size; ++row)
  {
    for (std::uint32_t column = 0; column <= size; ++column)
    {
      squares.points.push_back({ { double(column), double(row) } });
    }
  }
  for (std::uint32_t row = 0; row < size; ++row)
  {
    for (std::uint32_t column = 0; column < size; ++column)
    {
      const std::uint32_t first = row * (size + 1) + column;
      const int           label = labelOf(column, row);
      if (label != 0)
      {
        squares.cells.push_back({ { { first, first + 1, first + size + 2, first + size + 1 } }, label });
      }
    }
  }
  return squares;
}

/** By the oriented lines around it. */
double
AreaWithin(const mmm::PlanarCells & cells, const std::vector<mmm::PlanarLine> & lines)
{
  double area = 0.0;
  for (const auto & line : lines)
  {
    for (std::size_t p = 0; p < line.size(); ++p)
    {
      const auto & a = cells.points[line[p]];
      const auto & b = cells.points[line[(p + 1) % line.size()]];
      area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
  }
  return area;
}

std::size_t
CountSides(const std::vector<mmm::PlanarLine> & lines)
{
  std::size_t count = 0;
  for (const auto & line : lines)
  {
    count += line.size();
  }
  return count;
}
} // namespace

TEST(PlanarLines, OutlineOfASquareIsItsBorder)
{
  const auto squares = MakeSquares(7, [](int, int) { return 2; });
  const auto outlines = mmm::OutlinesByLabel(squares.cells);
  ASSERT_EQ(outlines.size(), 1u);
  ASSERT_EQ(outlines.at(2).size(), 1u);
  EXPECT_EQ(outlines.at(2)[0].size(), 28u);
  EXPECT_NEAR(AreaWithin(squares, outlines.at(2)), 49.0, 1e-12);
}

TEST(PlanarLines, OutlinesHaveHolesAndParts)
{
  // a frame with a square of another label and a square that is alone
  const auto squares = MakeSquares(9, [](int column, int row) {
    const int depth = std::min({ column, row, 8 - column, 8 - row });
    return depth == 2 ? 0 : depth < 2 ? 1 : (column == 4 && row == 4 ? 1 : 5);
  });
  const auto outlines = mmm::OutlinesByLabel(squares.cells);
  EXPECT_EQ(outlines.at(1).size(), 3u);
  EXPECT_EQ(CountSides(outlines.at(1)), 36u + 20u + 4u);
  EXPECT_NEAR(AreaWithin(squares, outlines.at(1)), 81.0 - 25.0 + 1.0, 1e-12);
  EXPECT_NEAR(AreaWithin(squares, outlines.at(5)), 8.0, 1e-12);
}

TEST(PlanarLines, OutlinesPassCornersWhereALabelTouchesItself)
{
  const auto squares = MakeSquares(8, [](int column, int row) { return 1 + (column + row) % 2; });
  const auto outlines = mmm::OutlinesByLabel(squares.cells);
  for (const int label : { 1, 2 })
  {
    EXPECT_EQ(CountSides(outlines.at(label)), 4u * 32u);
    EXPECT_NEAR(AreaWithin(squares, outlines.at(label)), 32.0, 1e-12);
  }
}

TEST(PlanarLines, TrailsPassEachEdgeOnce)
{
  const auto squares = MakeSquares(20, [](int column, int row) { return (7 * column + 3 * row) % 4; });
  const auto edges = mmm::EdgesOf(squares.cells);
  const auto trails = mmm::TrailsOf(edges);
  std::vector<mmm::PlanarEdge> passed;
  for (const auto & trail : trails)
  {
    for (std::size_t p = 1; p < trail.size(); ++p)
    {
      passed.push_back({ { std::min(trail[p - 1], trail[p]), std::max(trail[p - 1], trail[p]) } });
    }
  }
  std::sort(passed.begin(), passed.end());
  EXPECT_EQ(passed, edges);
  EXPECT_LT(trails.size(), edges.size() / 4);
}

TEST(PlanarLines, NothingHasNoLines)
{
  EXPECT_TRUE(mmm::OutlinesByLabel({}).empty());
  EXPECT_TRUE(mmm::TrailsOf({}).empty());
}
