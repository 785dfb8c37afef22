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
#ifndef ProgressDisplay_h
#define ProgressDisplay_h

#include "console/SlicerProgress.h"

#include <chrono>
#include <string>

namespace cli
{
/** \brief Shows on stdout what is being done: a bar per stage on a terminal, else a line per stage when it ends. */
class ProgressDisplay
{
public:
  enum class Style
  {
    None,
    /** A bar per stage on a terminal, else a line per stage. */
    Text,
    Slicer
  };

  explicit ProgressDisplay(Style style);
  /** Leaves the cursor at the start of a line. */
  ~ProgressDisplay();
  ProgressDisplay(const ProgressDisplay &) = delete;
  ProgressDisplay &
  operator=(const ProgressDisplay &) = delete;

  /** The fraction of a stage that is done, and that of all work. A new name ends the stage before. */
  void
  Show(const std::string & stage, double fraction, double total);

  /** A line of text for the user, after the stage that ends with it. Slicer shows no text. */
  void
  Note(const std::string & text);

  /** The stage is done. */
  void
  Finish();

private:
  using Clock = std::chrono::steady_clock;

  void
  DrawBar(double fraction, double seconds);

  Style m_Style;
  /** Whether there is a bar. */
  bool              m_IsTerminal;
  SlicerProgress    m_Slicer;
  std::string       m_Stage;
  Clock::time_point m_Start;
  Clock::time_point m_LastDrawn;
};
} // namespace cli

#endif
