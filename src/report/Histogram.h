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
#ifndef mmmHistogram_h
#define mmmHistogram_h

#include <string>
#include <vector>

namespace mmm
{
/** How often a value lies in each of equal ranges. */
struct Histogram
{
  std::vector<std::size_t> counts;
  /** Where the first range begins and the last one ends. */
  double first{ 0.0 };
  double last{ 1.0 };
  /** What is counted, and the unit with a blank before it or nothing; text. */
  std::string what;
  std::string unit;
  int         decimals{ 0 };
  /** Into how many parts numbers divide the axis. */
  int parts{ 6 };
};

/** In words: "Dihedral angles of label 3: 12.5 % are from 50 to 60 degrees, more than in any other range". */
std::string
Describe(const Histogram & histogram);

/** A drawing for the cell of a table. The highest bar is as high as the drawing. */
std::string
DrawSmall(const Histogram & histogram);

/** A figure with an axis, in which each bar has its number. */
std::string
DrawLarge(const Histogram & histogram);
} // namespace mmm

#endif
