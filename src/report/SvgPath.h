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
#ifndef mmmSvgPath_h
#define mmmSvgPath_h

#include <array>
#include <string>

namespace mmm
{
/** A place in a drawing, in whole units to the right and downwards. */
using SvgPoint = std::array<long, 2>;

/** \brief The data of a path of SVG, short: differences of whole numbers. Steps along an axis in the same direction
 * become one, and those of no length none. */
class SvgPath
{
public:
  /** Begins a line. */
  void
  MoveTo(const SvgPoint & point);

  void
  LineTo(const SvgPoint & point);

  /** Goes back to where the line began. */
  void
  Close();

  /** Empty if there is no line. */
  const std::string &
  GetText();

private:
  void
  Flush();
  void
  Write(char command, const SvgPoint & difference);
  void
  WriteNumber(long number);

  std::string m_Text;
  /** The last command, or that which a pair of numbers without command repeats. */
  char     m_Command{ 0 };
  SvgPoint m_Start{ { 0, 0 } };
  SvgPoint m_Place{ { 0, 0 } };
  /** A step that may go on. */
  SvgPoint m_Step{ { 0, 0 } };
  /** A start from which there is no line yet. */
  bool m_IsToMove{ false };
};
} // namespace mmm

#endif
